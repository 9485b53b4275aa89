#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "base/files/open_file.h"

namespace somato {

/// New content for the file at `path`, written incrementally, that replaces the file atomically;
/// see save_whole(). Without commit() nothing changes, except that a file that is not regular (a
/// pipe, a device) is written directly.
class Replacement {
 public:
  /// Errors: kSystem with the system's reason.
  static Result<Replacement> begin(FileSystem& files, const std::string& path);

  Replacement(const Replacement&) = delete;
  Replacement(Replacement&& other) noexcept;
  Replacement& operator=(const Replacement&) = delete;
  Replacement& operator=(Replacement&&) = delete;
  ~Replacement();

  /// Errors: kSystem with the system's reason.
  Result<void> write(std::string_view bytes);

  /// Flushes the new content to the disk and gives it the name. Errors: kSystem with the system's
  /// reason.
  Result<void> commit();

 private:
  Replacement(FileSystem& files, OpenFile file, std::string path, std::string beside)
      : files_(&files),
        file_(std::move(file)),
        path_(std::move(path)),
        beside_(std::move(beside)) {}

  static Result<Replacement> begin_beside(FileSystem& files, const std::string& path,
                                          const std::optional<FileStatus>& like);

  FileSystem* files_;
  OpenFile file_;
  std::string path_;
  std::string beside_;  // The new file's name for now; empty once it has its own, or never had any.
};

/// Whether Replacement writes to `path` directly: a pipe, a device, `/dev/stdout`.
bool is_written_directly(const std::string& path);

}  // namespace somato
