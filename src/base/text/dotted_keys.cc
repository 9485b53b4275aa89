#include "base/text/dotted_keys.h"

#include <algorithm>

namespace somato {
namespace {

// The length of the comment or string that `text` begins with; 1 for any other character.
std::size_t token_length(std::string_view text) {
  const char first = text[0];
  if (first == '#') return std::min(text.find('\n'), text.size());
  if (first != '"' && first != '\'') return 1;
  const std::string_view triple = first == '"' ? R"(""")" : "'''";
  const bool many_lines = text.starts_with(triple);
  const std::string_view end = many_lines ? triple : triple.substr(0, 1);
  for (std::size_t i = end.size(); i < text.size(); ++i) {
    if (first == '"' && text[i] == '\\') {
      ++i;
    } else if (text.substr(i).starts_with(end)) {
      // A multi-line string may end with one or two additional quotation marks.
      const std::size_t stop = text.find_first_not_of(first, i);
      return many_lines ? std::min({stop, text.size(), i + 5}) : i + 1;
    }
  }
  return text.size();
}

bool is_part_of_key(char c) {
  return c != '\n' && c != '=' && c != ',' && c != '{' && c != '[';
}

}  // namespace

std::size_t line_of_long_key(std::string_view text, std::size_t most) {
  std::size_t line = 1;
  std::size_t dots = 0;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = token_length(text.substr(i));
    if (text[i] == '.') ++dots;
    if (!is_part_of_key(text[i])) dots = 0;
    if (dots > most) return line;
    line += static_cast<std::size_t>(std::count(
        text.begin() + static_cast<long>(i), text.begin() + static_cast<long>(i + length), '\n'));
    i += length;
  }
  return 0;
}

}  // namespace somato
