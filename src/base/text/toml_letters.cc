#include "base/text/toml_letters.h"

#include <algorithm>

#include "base/text/utf8.h"

namespace somato {
namespace {

constexpr char32_t kStandIns = 0xC0000;  // Up to U+CFFFF.

// The test divides the characters from U+00A0 to U+FEFF into 64 ranges. It is undefined in three of
// them, except for the blanks there.
bool has_undefined_test(char32_t code) {
  if (code <= 0xA0 || code >= 0xFEFF || code == 0x3000) return false;
  const char32_t range = (code - 0xA0) / 0x3FA;
  return range == 0 || range == 11 || range == 63;
}

// `text` with `changed(code)` in place of each character; bytes that are no character stay.
template <class Change>
std::string with_characters(std::string_view text, const Change& changed) {
  std::string out;
  out.reserve(text.size());
  while (!text.empty()) {
    const Utf8Character first = first_character(text);
    if (first.bytes > 1) append_character(out, changed(first.code));
    if (first.bytes <= 1) out += text[0];
    text.remove_prefix(std::max<std::size_t>(first.bytes, 1));
  }
  return out;
}

}  // namespace

std::string with_stand_ins(std::string_view text) {
  return with_characters(
      text, [](char32_t code) { return has_undefined_test(code) ? kStandIns + code : code; });
}

std::string without_stand_ins(std::string_view text) {
  return with_characters(text, [](char32_t code) {
    return code >= kStandIns && has_undefined_test(code - kStandIns) ? code - kStandIns : code;
  });
}

std::size_t first_stand_in(std::string_view text) {
  constexpr std::string_view kFirstByte = "\xF3";
  std::size_t found = std::min(text.find("\\U000C"), text.find("\\U000c"));
  for (std::size_t i = text.find(kFirstByte); i < found; i = text.find(kFirstByte, i + 1)) {
    const char32_t code = first_character(text.substr(i)).code;
    if (code >= kStandIns && code <= kStandIns + 0xFFFF) found = i;
  }
  return found;
}

}  // namespace somato
