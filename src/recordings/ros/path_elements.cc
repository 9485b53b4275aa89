#include "recordings/ros/path_elements.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "base/text/text.h"

namespace somato {
namespace {

bool take_index(std::string_view& text, std::size_t& index) {
  const auto [stop, status] = std::from_chars(text.data(), text.data() + text.size(), index);
  text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  return status == std::errc{};
}

// "2" or "2..5".
bool parse_range(std::string_view text, PathElements& elements) {
  if (!take_index(text, elements.first)) return false;
  elements.last = elements.first;
  if (text.empty()) return true;
  if (!text.starts_with("..")) return false;
  text.remove_prefix(2);
  return take_index(text, elements.last) && text.empty() && elements.first <= elements.last;
}

// "*:32".
bool parse_padding(std::string_view text, PathElements& elements) {
  std::size_t count = 0;
  if (!text.starts_with("*:")) return false;
  text.remove_prefix(2);
  elements.is_padded = take_index(text, count) && text.empty() && count > 0;
  elements.last = count - 1;
  return elements.is_padded;
}

// Whether every bracket in the text has its partner.
bool has_balanced_brackets(std::string_view text) {
  std::size_t depth = 0;
  for (const char c : text) {
    if (c == ']' && depth == 0) return false;
    depth += c == '[' ? 1U : 0U;
    depth -= c == ']' ? 1U : 0U;
  }
  return depth == 0;
}

// "shoulder,elbow".
bool parse_names(std::string_view text, PathElements& elements) {
  if (!has_balanced_brackets(text)) return false;
  for (const std::string& name : split(text, ',')) elements.names.emplace_back(trimmed(name));
  std::vector<std::string> sorted = elements.names;
  std::sort(sorted.begin(), sorted.end());
  const bool is_repeated = std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
  return !sorted.front().empty() && !is_repeated;
}

// The place of the first `separator` outside brackets, or the size of the text.
std::size_t find_outside_brackets(std::string_view text, char separator) {
  std::size_t depth = 0;
  std::size_t place = 0;
  for (; place < text.size() && (depth > 0 || text[place] != separator); ++place) {
    if (text[place] == '[') ++depth;
    if (text[place] == ']' && depth > 0) --depth;
  }
  return place;
}

}  // namespace

std::optional<PathElements> parse_path_elements(std::string_view text) {
  PathElements elements;
  if (text == "*") return elements;
  const bool is_of_names = text.find_first_not_of("0123456789.*:-+ ") != std::string_view::npos;
  const bool is_valid = is_of_names ? parse_names(text, elements)
                                    : parse_range(text, elements) || parse_padding(text, elements);
  return is_valid ? std::optional(std::move(elements)) : std::nullopt;
}

std::string_view take_path_part(std::string_view& rest) {
  const std::size_t end = find_outside_brackets(rest, '.');
  const std::string_view part = rest.substr(0, end);
  rest.remove_prefix(end + 1 < rest.size() ? end + 1 : end);
  return part;
}

std::vector<std::string> split_outside_brackets(std::string_view text, char separator) {
  std::vector<std::string> parts;
  for (;;) {
    const std::size_t end = find_outside_brackets(text, separator);
    parts.emplace_back(text.substr(0, end));
    if (end == text.size()) return parts;
    text.remove_prefix(end + 1);
  }
}

}  // namespace somato
