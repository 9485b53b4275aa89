#include "terminal/still_elements.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "somato/core/value.h"
#include "terminal/wording.h"

namespace somato::program {
namespace {

// The first names are enough to find the cause.
std::string line_of(const std::vector<std::size_t>& found, std::size_t all, const std::string& what,
                    const std::vector<std::string>& names) {
  constexpr std::size_t kShown = 12;
  const std::vector<std::size_t> first(
      found.begin(), found.begin() + static_cast<std::ptrdiff_t>(std::min(kShown, found.size())));
  std::vector<std::string> quoted;
  for (const std::string& name : element_names_of(first, names)) {
    quoted.push_back(names.empty() ? name : to_toml(Value(name)));
  }
  return fmt::format("{} of {} {}: {}{}\n", found.size(), counted(all, "element"), what,
                     fmt::join(quoted, ", "), found.size() > kShown ? ", ..." : "");
}

}  // namespace

StillElements still_elements(const std::vector<ElementRange>& elements) {
  StillElements still;
  still.elements = elements.size();
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const ElementRange& range = elements[i];
    still.missing_values += range.missing;
    if (range.missing > 0) still.missing.push_back(i);
    if (range.is_still()) (range.least == 0.0F ? still.zero : still.unchanged).push_back(i);
  }
  return still;
}

std::vector<std::string> element_names_of(const std::vector<std::size_t>& elements,
                                          const std::vector<std::string>& names) {
  std::vector<std::string> named;
  named.reserve(elements.size());
  for (const std::size_t element : elements) {
    named.push_back(names.empty() ? fmt::format("{}", element + 1) : names.at(element));
  }
  return named;
}

std::string text_of(const StillElements& still, const std::vector<std::string>& names,
                    const std::string& prefix) {
  std::string text;
  const auto add = [&](const std::vector<std::size_t>& found, const std::string& what) {
    if (!found.empty()) text += prefix + line_of(found, still.elements, what, names);
  };
  add(still.zero, "always 0");
  add(still.unchanged, "never changed");
  add(still.missing, fmt::format("lacking {}", counted(still.missing_values, "reading")));
  return text;
}

}  // namespace somato::program
