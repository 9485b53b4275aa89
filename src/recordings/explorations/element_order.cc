#include "recordings/explorations/element_order.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "base/text/text.h"

namespace somato {
namespace {

constexpr std::size_t kFewNames = 8;  // The eye compares them.
constexpr std::size_t kMostKnown = 1000;

std::string shown_names(const std::vector<std::string>& names) {
  return names.empty() ? "without names" : shown_list(names);
}

// The names in `of` that are not in `others`.
std::vector<std::string> missing_in(const std::vector<std::string>& others,
                                    const std::vector<std::string>& of) {
  const std::set<std::string_view> known(others.begin(), others.end());
  std::vector<std::string> missing;
  for (const std::string& name : of) {
    if (!known.contains(name)) missing.push_back(name);
  }
  return missing;
}

// A sentence about the elements of a frame and those of the first one.
std::string difference(const std::vector<std::string>& names,
                       const std::vector<std::string>& first) {
  std::string text = fmt::format("its elements are {}; those of the first frame are {}",
                                 shown_names(names), shown_names(first));
  if (names.size() <= kFewNames && first.size() <= kFewNames) return text;
  const std::vector<std::string> more = missing_in(first, names);
  const std::vector<std::string> fewer = missing_in(names, first);
  if (!more.empty()) text += fmt::format("; it has also {}", shown_names(more));
  if (!fewer.empty()) text += fmt::format("; it lacks {}", shown_names(fewer));
  return text;
}

}  // namespace

Result<void> ElementOrder::learn(std::string_view key, const std::vector<std::string>& names) {
  if (known_.size() < kMostKnown) known_.insert(names.begin(), names.end());
  if (!is_begun_ && !is_selection_) names_ = names;
  std::optional<std::vector<std::size_t>> places = std::vector<std::size_t>();
  if (names != names_) {
    SOMATO_TRY(places, places_in(names));
  }
  has_all_ = places.has_value();
  places_ = std::move(places).value_or(std::vector<std::size_t>());
  key_ = key;
  is_begun_ = true;
  return {};
}

// The place of each element in a frame with these names; nothing if it lacks a selected one. A name
// that is not unique does not identify an element.
Result<std::optional<std::vector<std::size_t>>> ElementOrder::places_in(
    const std::vector<std::string>& names) const {
  std::multimap<std::string_view, std::size_t> known;
  for (std::size_t i = 0; i < names.size(); ++i) known.emplace(names[i], i);
  std::vector<std::size_t> places;
  std::set<std::string_view> used;
  for (const std::string& name : names_) {
    const std::size_t count = known.count(name);
    if (count == 1 && used.insert(name).second) places.push_back(known.find(name)->second);
    if (count > 1) {
      return fail(ErrorKind::kData, fmt::format("it has {} elements {}", count, shown(name)), {},
                  "use names that differ");
    }
  }
  const bool has_all = places.size() == names_.size();
  if (!is_selection_ && (!has_all || names.size() != names_.size())) {
    return fail(ErrorKind::kData, difference(names, names_));
  }
  return has_all ? std::optional(std::move(places)) : std::nullopt;
}

bool ElementOrder::place(std::vector<double>& values) const {
  if (!has_all_) values.clear();
  if (!has_all_ || places_.empty()) return has_all_;
  std::vector<double> placed;
  placed.reserve(places_.size());
  for (const std::size_t place : places_) placed.push_back(values[place]);
  values = std::move(placed);
  return true;
}

}  // namespace somato
