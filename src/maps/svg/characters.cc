#include "maps/svg/characters.h"

#include <algorithm>
#include <cstddef>

#include "base/text/utf8.h"

namespace somato {
namespace {

char32_t shown(char32_t character) {
  if (character == '\t' || character == '\n' || character == '\r') return ' ';
  const bool is_control = character < 0x20 || (character >= 0x7F && character < 0xA0);
  const bool is_forbidden_in_xml = character == 0xFFFE || character == 0xFFFF;
  return is_control || is_forbidden_in_xml ? kReplacement : character;
}

}  // namespace

std::u32string characters_of(std::string_view text) {
  std::u32string characters;
  while (!text.empty()) {
    const Utf8Character first = first_character(text);
    characters += first.bytes > 0 ? shown(first.code) : kReplacement;
    text.remove_prefix(std::max<std::size_t>(first.bytes, 1));
  }
  return characters;
}

std::string utf8_of(std::u32string_view characters) {
  std::string text;
  for (const char32_t character : characters) append_character(text, character);
  return text;
}

}  // namespace somato
