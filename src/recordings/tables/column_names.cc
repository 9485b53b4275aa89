#include "recordings/tables/column_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <numeric>
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

// The two ends of a range, such as "taxel1" and "taxel16".
struct Ends {
  std::string_view first;
  std::string_view last;
};

std::optional<Ends> ends_of(std::string_view column) {
  const std::size_t dots = column.find(kDots);
  if (dots == std::string_view::npos || column.find(kStar) != std::string_view::npos) return {};
  return Ends{column.substr(0, dots), column.substr(dots + kDots.size())};
}

bool are_two_names(const Ends& ends) {
  return !ends.first.empty() && !ends.last.empty() &&
         ends.last.find(kDots) == std::string_view::npos;
}

// The ends of a range of numbers, or nothing for a range by place.
std::optional<std::pair<Numbered, Numbered>> numbered_ends(const Ends& ends) {
  const auto first = numbered_name(ends.first);
  const auto last = numbered_name(ends.last);
  if (!first || !last || first->stem != last->stem) return {};
  return std::pair(*first, *last);
}

std::string numbered(const Numbered& like, std::uint64_t number) {
  return fmt::format("{}{:0{}}", like.stem, number, like.digits);
}

// Whether the two digits of the ends may be a row and a column, as in "t00..t33".
bool may_have_two_indices(const Numbered& first, const Numbered& last) {
  return first.digits == 2 && last.digits == 2 && first.number / 10 < last.number / 10 &&
         first.number % 10 < last.number % 10;
}

tl::unexpected<Error> no_range(std::string_view range) {
  return fail(ErrorKind::kUsage, fmt::format("'{}' is not a range of columns", range), {},
              "write for example \"taxel1..taxel16\", the first column first");
}

Result<void> add_range(std::string_view range, const Numbered& first, const Numbered& last,
                       std::vector<std::string>& names) {
  if (first.number > last.number) return no_range(range);
  if (last.number - first.number >= kMostColumns || names.size() >= kMostColumns) {
    return fail(ErrorKind::kUsage,
                fmt::format("'{}' gives more than {} columns", range, kMostColumns));
  }
  for (std::uint64_t number = first.number; number <= last.number; ++number) {
    names.push_back(numbered(first, number));
  }
  return {};
}

// Row by row.
std::vector<std::string> names_of_two_indices(const Numbered& first, const Numbered& last) {
  std::vector<std::string> names;
  for (std::uint64_t row = first.number / 10; row <= last.number / 10; ++row) {
    for (std::uint64_t column = first.number % 10; column <= last.number % 10; ++column) {
      names.push_back(numbered(first, 10 * row + column));
    }
  }
  return names;
}

// Whether the columns with two digits between the ends are these, and no others.
bool are_all(const std::vector<std::string>& names, const Numbered& first, const Numbered& last,
             const std::vector<std::string>& header) {
  const auto between = std::count_if(header.begin(), header.end(), [&](const std::string& name) {
    const auto parts = numbered_name(name);
    return parts && parts->stem == first.stem && parts->digits == 2 &&
           parts->number >= first.number && parts->number <= last.number;
  });
  return static_cast<std::size_t>(between) == names.size();
}

Result<std::vector<std::size_t>> places_of(const std::vector<std::string>& names,
                                           const PlaceOfColumn& place_of) {
  std::vector<std::size_t> places;
  for (const std::string& name : names) {
    SOMATO_TRY(const std::size_t place, place_of(name));
    places.push_back(place);
  }
  return places;
}

}  // namespace

bool is_column_pattern(std::string_view column) {
  return column.find(kStar) != std::string_view::npos || is_column_range(column);
}

bool is_column_range(std::string_view column) {
  return ends_of(column).has_value();
}

Result<std::vector<std::size_t>> columns_in_range(std::string_view range,
                                                  const std::vector<std::string>& header,
                                                  const PlaceOfColumn& place_of) {
  const Ends ends = ends_of(range).value();
  if (const auto numbers = numbered_ends(ends)) {
    const auto& [first, last] = *numbers;
    std::vector<std::string> names;
    SOMATO_TRY_VOID(add_range(range, first, last, names));
    auto places = places_of(names, place_of);
    if (places || !may_have_two_indices(first, last)) return places;
    names = names_of_two_indices(first, last);
    auto of_two = places_of(names, place_of);
    return of_two && are_all(names, first, last, header) ? of_two : places;
  }
  SOMATO_TRY(const std::size_t first, place_of(std::string(ends.first)));
  SOMATO_TRY(const std::size_t last, place_of(std::string(ends.last)));
  if (first > last) return no_range(range);
  std::vector<std::size_t> places(last - first + 1);
  std::iota(places.begin(), places.end(), first);
  return places;
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
    const auto ends = ends_of(column);
    if (ends && !are_two_names(*ends)) return no_range(column);
    const auto numbers = ends ? numbered_ends(*ends) : std::nullopt;
    if (!numbers || may_have_two_indices(numbers->first, numbers->second)) {
      names.push_back(column);
    } else {
      SOMATO_TRY_VOID(add_range(column, numbers->first, numbers->second, names));
    }
  }
  return names;
}

}  // namespace somato
