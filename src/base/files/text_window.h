#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/files/open_file.h"
#include "somato/core/result.h"

namespace somato {

/// The text of a regular file, of which only a part is in memory: the part that was read and not
/// dropped.
class TextWindow {
 public:
  /// The most that may be in memory, in bytes: no record of a file of numbers is longer.
  static constexpr std::size_t kLargest = std::size_t{1} << 26;

  /// At the beginning of `file`, which is `where` and must outlive this object, or at `place`,
  /// where a character begins and before which there are so many `lines`.
  TextWindow(const OpenFile& file, std::string where, std::size_t place = 0, std::size_t lines = 0)
      : file_(file), where_(std::move(where)), place_(place), lines_(lines) {}

  /// The text in memory, valid until the next change. Never part of a character.
  std::string_view text() const { return {text_.data(), checked_}; }

  /// The bytes of the file that have been read.
  std::size_t place() const { return place_; }

  /// The place of text() in the file.
  std::size_t start() const { return place_ - text_.size(); }

  /// Forgets the first `count` bytes of text().
  void drop(std::size_t count);

  /// Reads on; false when the file has ended. Errors: kSystem with the system's reason; kData, with
  /// the line, for bytes that are no UTF-8 text, and when more than kLargest would be in memory.
  Result<bool> extend();

  /// Begins again.
  void rewind();

 private:
  Result<void> check(bool ended);

  const OpenFile& file_;
  std::string where_;
  std::string text_;         // text() and perhaps the beginning of a character.
  std::size_t checked_ = 0;  // Bytes of it that are text.
  std::size_t place_ = 0;    // In the file, behind text_.
  std::size_t lines_ = 0;    // Line ends in the part that was read and validated as text.
};

}  // namespace somato
