#pragma once

#include <string>
#include <string_view>

namespace somato {

/// The replacement for a character that cannot be shown.
constexpr char32_t kReplacement = 0xFFFD;

/// The characters of UTF-8 text as they may be shown: every byte that is not part of a character,
/// and every control character, becomes kReplacement; tabs and line ends become spaces.
std::u32string characters_of(std::string_view text);

/// Characters as UTF-8.
std::string utf8_of(std::u32string_view characters);

}  // namespace somato
