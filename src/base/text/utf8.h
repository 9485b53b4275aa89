#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace somato {

/// A character and its length in UTF-8, which is 0 where there is none.
struct Utf8Character {
  char32_t code = 0;
  std::size_t bytes = 0;
};

/// The character that `text`, which is not empty, begins with; of length 0 if its first bytes are
/// not well-formed UTF-8 (RFC 3629).
Utf8Character first_character(std::string_view text);

/// Appends the character `code` to `text`.
void append_character(std::string& text, char32_t code);

}  // namespace somato
