#pragma once

#include <string>
#include <utility>

#include "base/files/open_file.h"
#include "somato/core/result.h"

namespace somato {

/// An open regular file that is read again and again and has to stay as it was when it was opened.
class UnchangedFile {
 public:
  /// Errors: kSystem with the system's reason; for a folder or a file that is not regular.
  static Result<UnchangedFile> open(FileSystem& files, const std::string& path);

  const OpenFile& file() const { return file_; }
  const std::string& path() const { return path_; }
  std::size_t size() const { return status_.size; }

  /// Fails (kData) when it has another length or date by now.
  Result<void> check() const;

  /// Reads `count` bytes from `place`. Errors: kSystem with the system's reason; kData when they
  /// are no longer there.
  Result<void> read(std::size_t place, char* bytes, std::size_t count) const;

 private:
  UnchangedFile(OpenFile file, std::string path, const FileStatus& status)
      : file_(std::move(file)), path_(std::move(path)), status_(status) {}

  tl::unexpected<Error> changed() const;

  OpenFile file_;
  std::string path_;
  FileStatus status_;
};

}  // namespace somato
