#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "somato/core/result.h"

namespace somato {

/// The offset of the first byte that does not belong to well-formed UTF-8 (RFC 3629), or npos.
std::size_t first_invalid_utf8(std::string_view text);

inline bool is_utf8(std::string_view text) {
  return first_invalid_utf8(text) == std::string_view::npos;
}

/// Whether `text` may name a thing: UTF-8, 1 to 255 bytes, no control characters.
bool is_name(std::string_view text);

/// The text of a file's `bytes` without its byte order mark. Errors (kData, with `where` and the
/// line): bytes that are no UTF-8 text, NUL bytes.
Result<std::string_view> text_of(std::string_view bytes, std::string_view where);

/// `text` without blanks (spaces and tabs) at both ends.
std::string_view trimmed(std::string_view text);

/// `text` fit for a message: quoted, cut when long, control characters replaced.
std::string shown(std::string_view text);

}  // namespace somato
