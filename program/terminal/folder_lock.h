#pragma once

#include <filesystem>
#include <utility>

#include "somato/core/result.h"

namespace somato::program {

/// An exclusive lock on a folder during its lifetime; the system releases it with the process. Two
/// processes writing the same journal would damage it.
class FolderLock {
 public:
  /// Removes the partial files that killed runs have left there. Errors (kSystem): another process
  /// holds the lock. On file systems without locks it has no effect.
  static Result<FolderLock> take(const std::filesystem::path& folder);

  /// Waits until no other process holds the lock; partial files are kept. Errors: kInterrupted, by
  /// Ctrl-C.
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
