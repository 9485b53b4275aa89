#include "base/text/json_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace somato {
namespace {

// The position at which the text is nested too deeply; checked before parsing, which would require
// a hundred times the memory of the text.
std::size_t place_of_deep_nesting(std::string_view text) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted && c == '\\') ++i;
    if (c == '"') quoted = !quoted;
    if (!quoted && (c == '[' || c == '{') && ++depth > kDeepestNesting) return i;
    if (!quoted && (c == ']' || c == '}')) --depth;
  }
  return std::string_view::npos;
}

std::string at_byte(const std::string& where, std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
  return fmt::format("{}:{}:{}", where, line, before.size() - line_start + 1);
}

}  // namespace

template <typename Json>
Result<Json> parse_json(std::string_view text, const std::string& where,
                        const std::string& advice) {
  const std::size_t deep = place_of_deep_nesting(text);
  if (deep != std::string_view::npos) {
    return fail(ErrorKind::kData,
                fmt::format("the JSON has more than {} levels of nesting", kDeepestNesting),
                at_byte(where, text, deep), advice);
  }
  try {
    return Json::parse(text);
  } catch (const typename Json::parse_error& error) {
    const bool is_cut = error.byte > text.size();
    return fail(ErrorKind::kData, is_cut ? "not valid JSON: it ends too early" : "not valid JSON",
                at_byte(where, text, error.byte > 0 ? error.byte - 1 : 0), advice);
  } catch (const typename Json::out_of_range&) {
    return fail(ErrorKind::kData, "a number is out of range", where, advice);
  }
}

template Result<nlohmann::json> parse_json(std::string_view, const std::string&,
                                           const std::string&);
template Result<nlohmann::ordered_json> parse_json(std::string_view, const std::string&,
                                                   const std::string&);

}  // namespace somato
