#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "base/files/open_file.h"
#include "somato/core/result.h"

namespace somato {

/// Bytes that are written and then read once in the same order: in memory, and beyond a limit in a
/// temporary file without a name, which the system removes with the process. The file is in the
/// folder TMPDIR, or else in /var/tmp.
class Spool {
 public:
  static constexpr std::size_t kUsualMemory = std::size_t{16} << 20;

  explicit Spool(std::size_t most_memory = kUsualMemory) : most_memory_(most_memory) {}

  /// Appends `bytes`. Errors: kSystem with the folder and the system's reason.
  Result<void> write(std::string_view bytes);

  /// The number of bytes that have not been read.
  std::size_t unread() const { return stored_ + buffer_.size() - place_; }

  /// Copies the next `count` bytes, at most unread(). Errors: as write().
  Result<void> read(char* bytes, std::size_t count);

  /// Removes everything.
  void clear();

 private:
  Result<void> store();

  std::size_t most_memory_;
  std::string buffer_;            // Follows the bytes in the file.
  std::optional<OpenFile> file_;  // Once the limit has been exceeded.
  std::size_t stored_ = 0;        // Bytes in the file.
  std::size_t place_ = 0;         // The place of the next byte to read.
  std::string window_;            // Part of the file.
  std::size_t window_place_ = 0;
};

}  // namespace somato
