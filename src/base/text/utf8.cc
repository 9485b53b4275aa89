#include "base/text/utf8.h"

#include <array>

namespace somato {
namespace {

// The length that a character's first byte announces, 0 if it cannot be a first byte.
std::size_t announced_length(unsigned char first) {
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first < 0xE0) return 2;
  if (first >= 0xE0 && first < 0xF0) return 3;
  if (first >= 0xF0 && first < 0xF5) return 4;
  return 0;
}

bool is_character(char32_t code, std::size_t bytes) {
  constexpr std::array<char32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = code >= 0xD800 && code < 0xE000;
  return code >= kLeast[bytes] && code <= 0x10FFFF && !is_surrogate;
}

}  // namespace

Utf8Character first_character(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  const std::size_t bytes = announced_length(first);
  if (bytes == 0 || bytes > text.size()) return {};
  if (bytes == 1) return {first, 1};
  char32_t code = first & (0xFFU >> (bytes + 1));
  for (const char next : text.substr(1, bytes - 1)) {
    if ((static_cast<unsigned char>(next) & 0xC0U) != 0x80) return {};
    code = code << 6U | (static_cast<unsigned char>(next) & 0x3FU);
  }
  return is_character(code, bytes) ? Utf8Character{code, bytes} : Utf8Character{};
}

void append_character(std::string& text, char32_t code) {
  const auto byte = [&](char32_t value) { text += static_cast<char>(value); };
  const auto rest = [&](unsigned shift) { byte(0x80 | (code >> shift & 0x3F)); };
  if (code < 0x80) {
    byte(code);
  } else if (code < 0x800) {
    byte(0xC0 | code >> 6U);
    rest(0);
  } else if (code < 0x10000) {
    byte(0xE0 | code >> 12U);
    rest(6);
    rest(0);
  } else {
    byte(0xF0 | code >> 18U);
    rest(12);
    rest(6);
    rest(0);
  }
}

}  // namespace somato
