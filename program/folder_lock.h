#pragma once

#include <filesystem>
#include <utility>

#include "somato/core/result.h"

namespace somato::program {

/// Keeps other runs of the program out of a folder as long as it lives; the system ends it with the
/// process. Two that write the same journal would spoil it.
class FolderLock {
 public:
  /// Removes the partial files that killed runs have left there. Errors (kSystem): another run
  /// holds it. File systems without locks are taken as they are.
  static Result<FolderLock> take(const std::filesystem::path& folder);

  /// Waits until no other run holds it; partial files stay. Errors: kInterrupted, by Ctrl-C.
  static Result<FolderLock> wait(const std::filesystem::path& folder);

  FolderLock(FolderLock&& other) noexcept : folder_(std::exchange(other.folder_, -1)) {}
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  FolderLock& operator=(FolderLock&& other) noexcept {
    std::swap(folder_, other.folder_);
    return *this;
  }
  ~FolderLock();

 private:
  explicit FolderLock(int folder) : folder_(folder) {}

  int folder_;  // a file descriptor
};

}  // namespace somato::program
