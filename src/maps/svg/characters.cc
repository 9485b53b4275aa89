#include "maps/svg/characters.h"

#include <array>
#include <cstddef>

namespace somato {
namespace {

struct Decoded {
  char32_t character = kReplacement;
  std::size_t bytes = 1;
};

// The number of bytes of a character that starts with `first`; 0 if there is none.
std::size_t length_from(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first < 0xE0) return 2;
  if (first >= 0xE0 && first < 0xF0) return 3;
  if (first >= 0xF0 && first < 0xF5) return 4;
  return 0;
}

bool is_character(char32_t value, std::size_t bytes) {
  constexpr std::array<char32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = value >= 0xD800 && value < 0xE000;
  return value >= kLeast[bytes] && value <= 0x10FFFF && !is_surrogate;
}

Decoded decode(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  const std::size_t bytes = length_from(first);
  if (bytes == 0 || bytes > text.size()) return {};
  if (bytes == 1) return {first, 1};
  char32_t value = first & (0xFFU >> (bytes + 1));
  for (const char next : text.substr(1, bytes - 1)) {
    if ((static_cast<unsigned char>(next) & 0xC0U) != 0x80) return {};
    value = value << 6U | (static_cast<unsigned char>(next) & 0x3FU);
  }
  return is_character(value, bytes) ? Decoded{value, bytes} : Decoded{};
}

char32_t shown(char32_t character) {
  if (character == '\t' || character == '\n' || character == '\r') return ' ';
  const bool is_control = character < 0x20 || (character >= 0x7F && character < 0xA0);
  const bool is_forbidden_in_xml = character == 0xFFFE || character == 0xFFFF;
  return is_control || is_forbidden_in_xml ? kReplacement : character;
}

void append(std::string& text, char32_t character) {
  const auto byte = [&](char32_t value) { text += static_cast<char>(value); };
  const auto rest = [&](unsigned shift) { byte(0x80 | (character >> shift & 0x3F)); };
  if (character < 0x80) {
    byte(character);
  } else if (character < 0x800) {
    byte(0xC0 | character >> 6U);
    rest(0);
  } else if (character < 0x10000) {
    byte(0xE0 | character >> 12U);
    rest(6);
    rest(0);
  } else {
    byte(0xF0 | character >> 18U);
    rest(12);
    rest(6);
    rest(0);
  }
}

}  // namespace

std::u32string characters_of(std::string_view text) {
  std::u32string characters;
  while (!text.empty()) {
    const Decoded decoded = decode(text);
    characters += shown(decoded.character);
    text.remove_prefix(decoded.bytes);
  }
  return characters;
}

std::string utf8_of(std::u32string_view characters) {
  std::string text;
  for (const char32_t character : characters) append(text, character);
  return text;
}

}  // namespace somato
