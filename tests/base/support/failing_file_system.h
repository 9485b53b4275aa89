#pragma once

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/files/file_system.h"

namespace somato::testing {

/// The real file system, but operation number `failing` yields `error`, and a write takes at most
/// `most` bytes.
class FailingFileSystem final : public FileSystem {
 public:
  explicit FailingFileSystem(int failing, int error = EIO, std::size_t most = SIZE_MAX)
      : failing_(failing), error_(error), most_(most) {}

  bool flushes = true;  ///< Else flushing does nothing: for tests that save very often.

  bool failed() const { return count_ > failing_; }
  int opened() const { return opened_; }
  int count() const { return count_; }

  Outcome<int> open(const std::string& path, Opening opening) override {
    if (fails()) return tl::unexpected<int>(error_);
    const Outcome<int> file = real_.open(path, opening);
    opened_ += file ? 1 : 0;
    return file;
  }
  Outcome<FileStatus> status(int file) override {
    if (fails()) return tl::unexpected<int>(error_);
    return real_.status(file);
  }
  Outcome<std::size_t> read(int file, char* bytes, std::size_t count) override {
    if (fails()) return tl::unexpected<int>(error_);
    return real_.read(file, bytes, std::min(count, most_));
  }
  Outcome<std::size_t> read_at(int file, std::size_t place, char* bytes,
                               std::size_t count) override {
    if (fails()) return tl::unexpected<int>(error_);
    return real_.read_at(file, place, bytes, std::min(count, most_));
  }
  // A disk fills up in the middle of a write: half of it is taken before it fails.
  Outcome<std::size_t> write(int file, std::string_view bytes) override {
    if (fails()) {
      if (error_ != EINTR) (void)real_.write(file, bytes.substr(0, bytes.size() / 2));
      return tl::unexpected<int>(error_);
    }
    return real_.write(file, bytes.substr(0, most_));
  }
  Outcome<void> set_permissions(int file, const FileStatus& like) override {
    if (fails()) return tl::unexpected<int>(error_);
    return real_.set_permissions(file, like);
  }
  Outcome<void> flush(int file) override {
    if (fails()) return tl::unexpected<int>(error_);
    return flushes ? real_.flush(file) : Outcome<void>();
  }
  Outcome<void> lock(int file) override {
    if (fails()) return tl::unexpected<int>(error_);
    return real_.lock(file);
  }
  // As on Linux, a failing close has closed the file.
  Outcome<void> close(int file) override {
    --opened_;
    const Outcome<void> closed = real_.close(file);
    if (fails()) return tl::unexpected<int>(error_);
    return closed;
  }
  Outcome<void> rename(const std::string& from, const std::string& to) override {
    if (fails()) return tl::unexpected<int>(error_);
    return real_.rename(from, to);
  }
  Outcome<void> remove(const std::string& path) override { return real_.remove(path); }

 private:
  bool fails() { return count_++ == failing_; }

  FileSystem& real_ = operating_system();
  int failing_;
  int error_;
  std::size_t most_;
  int count_ = 0;
  int opened_ = 0;
};

}  // namespace somato::testing
