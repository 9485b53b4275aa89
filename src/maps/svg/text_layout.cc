#include "maps/svg/text_layout.h"

#include <algorithm>

#include "maps/svg/characters.h"

namespace somato {
namespace {

constexpr char32_t kEllipsis = 0x2026;

// In units of the font size.
double width_of(char32_t character) {
  constexpr std::u32string_view kNarrow = U" .,:;|!'()[]{}/ijltfrI-";
  constexpr std::u32string_view kWide = U"mwMW@%";
  if (kNarrow.find(character) != std::u32string_view::npos) return 0.4;
  if (kWide.find(character) != std::u32string_view::npos) return 1.0;
  if (character >= 0x1100 && character != kEllipsis) return 1.1;  // CJK, emoji
  const bool is_capital = character >= 'A' && character <= 'Z';
  return is_capital || character >= 0x80 ? 0.75 : 0.63;
}

double width_of(std::u32string_view characters) {
  double width = 0.0;
  for (const char32_t character : characters) width += width_of(character);
  return width;
}

std::u32string shortened(std::u32string_view characters, double width) {
  if (width_of(characters) <= width) return std::u32string(characters);
  double left = width - width_of(kEllipsis);
  std::size_t kept = 0;
  while (kept < characters.size() && width_of(characters[kept]) <= left) {
    left -= width_of(characters[kept++]);
  }
  return std::u32string(characters.substr(0, kept)) + kEllipsis;
}

// The words of a text, without the spaces between them.
std::vector<std::u32string> words_of(std::u32string_view characters) {
  std::vector<std::u32string> words;
  while (!characters.empty()) {
    const std::size_t end = std::min(characters.find(U' '), characters.size());
    if (end > 0) words.emplace_back(characters.substr(0, end));
    characters.remove_prefix(std::min(end + 1, characters.size()));
  }
  return words;
}

}  // namespace

double text_width(std::string_view text, double size) {
  return width_of(characters_of(text)) * size;
}

std::string shortened(std::string_view text, double width, double size) {
  return utf8_of(shortened(std::u32string_view(characters_of(text)), width / size));
}

std::vector<std::string> wrapped(std::string_view text, double width, double size,
                                 std::size_t most_lines) {
  // More characters than fit, so that a text without end costs no more than one that is cut.
  constexpr double kNarrowest = 0.4;
  const auto most = static_cast<std::size_t>(width / size / kNarrowest) * (most_lines + 1) + 2;
  std::vector<std::u32string> lines;
  for (const std::u32string& word : words_of(characters_of(text).substr(0, most))) {
    const bool fits = !lines.empty() && width_of(lines.back() + U' ' + word) <= width / size;
    const bool is_full = lines.size() == most_lines;
    if (fits || is_full) {
      lines.back() += U' ' + word;
    } else {
      lines.push_back(word);
    }
  }
  std::vector<std::string> cut;
  cut.reserve(lines.size());
  for (const std::u32string& line : lines) cut.push_back(utf8_of(shortened(line, width / size)));
  return cut;
}

void write_line(SvgWriter& svg, Point at, std::string_view text, double width,
                const TextStyle& style) {
  const std::string line = shortened(text, width, style.size * (style.bold ? kBoldness : 1.0));
  const bool is_whole = line == utf8_of(characters_of(text));
  svg.text(at, line, style, is_whole ? std::string_view() : text);
}

}  // namespace somato
