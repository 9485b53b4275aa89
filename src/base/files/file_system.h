#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <tl/expected.hpp>

namespace somato {

/// The result of an operation on files, or the system's error number (`ENOSPC`, ...).
template <typename T>
using Outcome = tl::expected<T, int>;

/// Information about an open file.
struct FileStatus {
  enum class Kind { kRegular, kDirectory, kOther };
  Kind kind = Kind::kRegular;
  std::size_t size = 0;
  std::int64_t modified = 0;  ///< When the content was last changed: nanoseconds of some clock.
  unsigned permissions = 0;   ///< The nine permission bits.
  unsigned owner = 0;
  unsigned group = 0;
  std::size_t links = 1;  ///< The number of names in folders; 0 once it was removed.
};

/// Mode of opening a file.
enum class Opening {
  kRead,
  kOverwrite,  ///< An existing file for writing, its content kept until written over.
  kTruncate,   ///< An existing file for writing, emptied.
  kCreate,     ///< A new file for writing; fails with EEXIST when there is one.
  kFolder,     ///< A folder, to be flushed.
};

/// The operations of the operating system for reading and saving: an interface at which tests can
/// inject failures. Each is one system call without retries.
class FileSystem {
 public:
  FileSystem() = default;
  FileSystem(const FileSystem&) = delete;
  FileSystem(FileSystem&&) = delete;
  FileSystem& operator=(const FileSystem&) = delete;
  FileSystem& operator=(FileSystem&&) = delete;
  virtual ~FileSystem() = default;

  virtual Outcome<int> open(const std::string& path, Opening opening) = 0;
  virtual Outcome<FileStatus> status(int file) = 0;
  virtual Outcome<std::size_t> read(int file, char* bytes, std::size_t count) = 0;
  virtual Outcome<std::size_t> read_at(int file, std::size_t place, char* bytes,
                                       std::size_t count) = 0;
  virtual Outcome<std::size_t> write(int file, std::string_view bytes) = 0;
  virtual Outcome<void> set_permissions(int file, const FileStatus& like) = 0;
  virtual Outcome<void> flush(int file) = 0;

  /// Locks the file for this process until it is closed; EWOULDBLOCK if another one holds the lock.
  virtual Outcome<void> lock(int file) = 0;
  virtual Outcome<void> close(int file) = 0;
  virtual Outcome<void> rename(const std::string& from, const std::string& to) = 0;
  virtual Outcome<void> remove(const std::string& path) = 0;
};

/// The real one.
FileSystem& operating_system();

}  // namespace somato
