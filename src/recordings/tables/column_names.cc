#include "recordings/tables/column_names.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace somato {
namespace {

constexpr std::string_view kDots = "..";
constexpr char kStar = '*';
constexpr std::uint64_t kMostColumns = 100000;

// A name that ends in a number, such as "channel12".
struct Numbered {
  std::string_view stem;
  std::size_t digits;
  std::uint64_t number;
};

std::optional<Numbered> numbered_name(std::string_view name) {
  const std::size_t last = name.find_last_not_of("0123456789");
  const std::size_t stem = last == std::string_view::npos ? 0 : last + 1;
  Numbered parts{name.substr(0, stem), name.size() - stem, 0};
  const auto [stop, status] =
      std::from_chars(name.data() + stem, name.data() + name.size(), parts.number);
  return status == std::errc{} ? std::optional(parts) : std::nullopt;
}

Result<void> add_range(std::string_view range, std::size_t dots, std::vector<std::string>& names) {
  const auto first = numbered_name(range.substr(0, dots));
  const auto last = numbered_name(range.substr(dots + kDots.size()));
  if (!first || !last || first->stem != last->stem || first->number > last->number) {
    return fail(ErrorKind::kUsage, fmt::format("'{}' is not a range of columns", range), {},
                "write for example \"taxel1..taxel16\"");
  }
  if (last->number - first->number >= kMostColumns || names.size() >= kMostColumns) {
    return fail(ErrorKind::kUsage,
                fmt::format("'{}' gives more than {} columns", range, kMostColumns));
  }
  for (std::uint64_t number = first->number; number <= last->number; ++number) {
    names.push_back(fmt::format("{}{:0{}}", first->stem, number, first->digits));
  }
  return {};
}

}  // namespace

bool is_column_pattern(std::string_view column) {
  return column.find(kStar) != std::string_view::npos;
}

// The text between two stars is searched from the left, which leaves the longest rest.
bool fits_column_pattern(std::string_view pattern, std::string_view name) {
  std::size_t star = pattern.find(kStar);
  if (star == std::string_view::npos) return pattern == name;
  if (!name.starts_with(pattern.substr(0, star))) return false;
  for (std::size_t found = 0; star != std::string_view::npos; star = pattern.find(kStar)) {
    found = name.find(pattern.substr(0, star));
    if (found == std::string_view::npos) return false;
    name.remove_prefix(found + star);
    pattern.remove_prefix(star + 1);
  }
  return name.ends_with(pattern);
}

Result<std::vector<std::string>> expand_columns(const std::vector<std::string>& columns) {
  std::vector<std::string> names;
  for (const std::string& column : columns) {
    const std::size_t dots = column.find(kDots);
    if (dots == std::string::npos || is_column_pattern(column)) {
      names.push_back(column);
    } else
      SOMATO_TRY_VOID(add_range(column, dots, names));
  }
  return names;
}

}  // namespace somato
