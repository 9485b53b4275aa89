#pragma once

#include <string>
#include <utility>

#include "somato/core/result.h"

namespace somato {

/// A new folder for temporary files that only this user can read; it is removed with its content in
/// the end.
class ScratchFolder {
 public:
  /// In $TMPDIR, or else in /tmp. Errors: kSystem with the system's reason.
  static Result<ScratchFolder> create();

  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder(ScratchFolder&& other) noexcept;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ScratchFolder& operator=(ScratchFolder&&) = delete;
  ~ScratchFolder();

  const std::string& path() const { return path_; }

 private:
  explicit ScratchFolder(std::string path) : path_(std::move(path)) {}

  std::string path_;
};

}  // namespace somato
