#pragma once

#include <cerrno>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "base/files/file_system.h"
#include "somato/core/result.h"

namespace somato {

/// The failure of an operation on the file at `path`, with the reason of the system's error number
/// and advice where there is any.
tl::unexpected<Error> system_failure(const std::string& what, const std::string& path, int error);

/// Signals interrupt system calls; that is no failure.
template <typename Operation>
auto uninterrupted(Operation operation) {
  auto outcome = operation();
  while (!outcome && outcome.error() == EINTR) outcome = operation();
  return outcome;
}

/// An open file that is closed on every way out.
class OpenFile {
 public:
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  OpenFile(FileSystem& files, int number) : files_(&files), number_(number) {}
  OpenFile(OpenFile&& other) noexcept
      : files_(other.files_), number_(std::exchange(other.number_, -1)) {}
  OpenFile& operator=(OpenFile&&) = delete;
  ~OpenFile() { (void)close(); }

  static Outcome<OpenFile> open(FileSystem& files, const std::string& path, Opening opening);

  Outcome<FileStatus> status() const;
  Outcome<std::size_t> read(char* bytes, std::size_t count) const;

  /// Reads until `count` bytes from `place` are read or the file ends; returns the number of bytes.
  Outcome<std::size_t> read_all_at(std::size_t place, char* bytes, std::size_t count) const;

  Outcome<void> write_all(std::string_view bytes) const;
  Outcome<void> take_permissions(const FileStatus& like) const;
  Outcome<void> flush() const;
  Outcome<void> lock() const;

  /// Never twice: after a failed close the number may already belong to another file.
  Outcome<void> close();

 private:
  FileSystem* files_;
  int number_;
};

struct FileToRead {
  OpenFile file;
  FileStatus status;
};

/// Opens a file for reading. Errors: kSystem with the system's reason, also for a folder.
Result<FileToRead> open_to_read(FileSystem& files, const std::string& path);

/// Flushes the folder that holds `path`, so that names that were given or removed there survive a
/// power failure. A folder that may be written to but not read, or a file system that cannot flush
/// folders, is no reason to fail.
Outcome<void> flush_folder_of(FileSystem& files, const std::string& path);

}  // namespace somato
