#include "base/text/name_glob.h"

#include <cstddef>

namespace somato {
namespace {

// Length of the UTF-8 character at `place`, in bytes.
std::size_t bytes_of_character(std::string_view text, std::size_t place) {
  std::size_t end = place + 1;
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) ++end;
  return end - place;
}

}  // namespace

// If the rest does not match, the last `*` matches one more character.
bool matches_glob(std::string_view pattern, std::string_view name) {
  std::size_t at = 0;
  std::size_t place = 0;
  std::size_t star = std::string_view::npos;
  std::size_t star_end = 0;
  while (place < name.size()) {
    if (at < pattern.size() && pattern[at] == '*') {
      star = at++;
      star_end = place;
    } else if (at < pattern.size() && pattern[at] == '?') {
      ++at;
      place += bytes_of_character(name, place);
    } else if (at < pattern.size() && pattern[at] == name[place]) {
      ++at;
      ++place;
    } else if (star != std::string_view::npos) {
      star_end += bytes_of_character(name, star_end);
      place = star_end;
      at = star + 1;
    } else {
      return false;
    }
  }
  while (at < pattern.size() && pattern[at] == '*') ++at;
  return at == pattern.size();
}

}  // namespace somato
