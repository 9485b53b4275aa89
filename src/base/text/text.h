#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "somato/core/result.h"

namespace somato {

/// The offset of the first byte that does not belong to well-formed UTF-8 (RFC 3629), or npos.
std::size_t first_invalid_utf8(std::string_view text);

inline bool is_utf8(std::string_view text) {
  return first_invalid_utf8(text) == std::string_view::npos;
}

/// The byte order mark of some UTF-8 files.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

inline constexpr std::size_t kLongestName = 255;  ///< Bytes of a valid name.

/// Whether `text` is a valid name: UTF-8, 1 to 255 bytes, no control characters.
bool is_name(std::string_view text);

/// The text of a file's `bytes` without its byte order mark. Errors (kData, with `where` and the
/// line): bytes that are no UTF-8 text, NUL bytes.
Result<std::string_view> text_of(std::string_view bytes, std::string_view where);

/// The offset of the first byte that no text file holds (NUL, no UTF-8), or npos.
std::size_t first_byte_of_no_text(std::string_view bytes);

/// The failure (kData, with `where` and the line) at byte `bad` of bytes before which the file has
/// `lines_before` ends of lines.
tl::unexpected<Error> no_text(std::string_view bytes, std::size_t bad, std::size_t lines_before,
                              std::string_view where);

/// `text` without blanks (spaces and tabs) at both ends.
std::string_view trimmed(std::string_view text);

/// The parts of `text` between separators; one part if there is none.
std::vector<std::string> split(std::string_view text, char separator);

/// `text` fit for a message: quoted, cut when long, control characters replaced.
std::string shown(std::string_view text);

/// The texts fit for a message, with commas between: the first eight and the number of others.
std::string shown_list(const std::vector<std::string>& texts);

}  // namespace somato
