#include "recordings/tables/name_pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "base/text/text.h"

namespace somato {
namespace {

constexpr std::string_view kNumber = "number";
constexpr std::string_view kDigits = "0123456789";

tl::unexpected<Error> bad_pattern(std::string what) {
  return fail(ErrorKind::kUsage, std::move(what), {},
              "write for example \"{object}_{trial:number}.csv\"");
}

// An optional sign, digits, and perhaps a point and digits.
bool is_number(std::string_view text) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  const std::size_t point = std::min(text.find('.'), text.size());
  const std::string_view fraction = text.substr(std::min(point + 1, text.size()));
  const bool complete = point == text.size() || !fraction.empty();
  return point > 0 && complete &&
         text.substr(0, point).find_first_not_of(kDigits) == std::string_view::npos &&
         fraction.find_first_not_of(kDigits) == std::string_view::npos;
}

std::vector<Label> labels_of(const std::vector<std::string>& names,
                             const std::vector<std::string_view>& values) {
  std::vector<Label> labels;
  labels.reserve(names.size());
  for (std::size_t i = 0; i < names.size(); ++i)
    labels.push_back({names[i], std::string(values[i])});
  return labels;
}

std::string listed(const std::vector<Label>& labels) {
  std::string text;
  for (const Label& label : labels) {
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", label.name, shown(label.value));
  }
  return text;
}

}  // namespace

bool NamePattern::Part::takes(std::string_view value) const {
  return number ? is_number(value) : !value.empty();
}

Result<void> NamePattern::add_label(std::string_view inside) {
  const std::size_t colon = std::min(inside.find(':'), inside.size());
  const std::string_view kind = inside.substr(std::min(colon + 1, inside.size()));
  const std::string name(inside.substr(0, colon));
  if (colon < inside.size() && kind != kNumber) {
    return bad_pattern(
        fmt::format("a label cannot be restricted to {}, only to 'number'", shown(kind)));
  }
  if (!is_name(name)) return bad_pattern("a label of the pattern has no name");
  for (const Part& other : parts_) {
    if (other.name == name) return bad_pattern(fmt::format("two labels are named '{}'", name));
  }
  parts_.push_back({name, colon < inside.size(), {}});
  return {};
}

Result<NamePattern> NamePattern::parse(std::string_view text, bool needs_labels) {
  NamePattern pattern;
  pattern.text_ = text;
  for (;;) {
    const std::size_t open = std::min(text.find_first_of("{}"), text.size());
    (pattern.parts_.empty() ? pattern.before_ : pattern.parts_.back().behind) =
        text.substr(0, open);
    if (open == text.size()) break;
    const std::size_t close = text.find_first_of("{}", open + 1);
    if (text[open] == '}' || close == std::string_view::npos || text[close] == '{') {
      return bad_pattern("a brace of the pattern has no counterpart");
    }
    if (open == 0 && !pattern.parts_.empty()) {
      return bad_pattern(
          "two labels of the pattern are adjacent, so that their boundary is undefined");
    }
    SOMATO_TRY_VOID(pattern.add_label(text.substr(open + 1, close - open - 1)));
    text.remove_prefix(close + 1);
  }
  if (!needs_labels || !pattern.parts_.empty()) return pattern;
  return bad_pattern("the pattern has no labels");
}

std::vector<std::string> NamePattern::labels() const {
  std::vector<std::string> names;
  names.reserve(parts_.size());
  for (const Part& part : parts_) names.push_back(part.name);
  return names;
}

std::string NamePattern::extension() const {
  const std::string& end = parts_.empty() ? before_ : parts_.back().behind;
  const std::size_t dot = end.rfind('.');
  return dot == std::string::npos ? std::string() : end.substr(dot);
}

// The same number of parts between slashes as in the pattern.
std::string_view NamePattern::last_parts(std::string_view path) const {
  auto slashes = std::count(before_.begin(), before_.end(), '/');
  for (const Part& part : parts_) {
    slashes += std::count(part.behind.begin(), part.behind.end(), '/');
  }
  std::size_t start = path.size();
  for (; start > 0; --start) {
    if (path[start - 1] == '/' && slashes-- == 0) break;
  }
  return path.substr(start);
}

// The values of the labels for each way to match `path`, at most two. A match is identified by the
// ends of its labels, so that matches are followed from label to label by position.
std::vector<NamePattern::Values> NamePattern::ways_to_read(std::string_view path) const {
  constexpr std::size_t kEnoughWays = 2;
  if (!path.starts_with(before_)) return {};
  std::map<std::size_t, std::vector<Values>> ways{{before_.size(), {{}}}};
  for (const Part& part : parts_) {
    std::map<std::size_t, std::vector<Values>> further;
    for (const auto& [start, values_so_far] : ways) {
      for (std::size_t end = start + 1; end <= path.size(); ++end) {
        const std::string_view value = path.substr(start, end - start);
        if (!path.substr(end).starts_with(part.behind) || !part.takes(value)) continue;
        std::vector<Values>& there = further[end + part.behind.size()];
        for (const Values& values : values_so_far) {
          if (there.size() == kEnoughWays) break;
          there.push_back(values);
          there.back().push_back(value);
        }
      }
    }
    ways = std::move(further);
  }
  return ways[path.size()];
}

Result<std::optional<std::vector<Label>>> NamePattern::match(std::string_view path) const {
  const std::vector<Values> ways = ways_to_read(last_parts(path));
  if (ways.empty()) return std::nullopt;
  std::vector<Label> first = labels_of(labels(), ways[0]);
  if (ways.size() == 1) return first;
  return fail(ErrorKind::kData,
              fmt::format("the name can be read in more than one way: {}; or {}", listed(first),
                          listed(labels_of(labels(), ways[1]))),
              std::string(path), "restrict a numeric label, as in {trial:number}");
}

}  // namespace somato
