#include "views/skins/grid_layout.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

namespace somato {
namespace {

constexpr std::size_t kLongestRow = 32;  // of elements without a shape
constexpr std::string_view kDigits = "0123456789";

using Cell = std::pair<std::size_t, std::size_t>;  // row, column

struct Indices {
  std::string_view before;   // the first index
  std::string_view between;  // both
  Cell cell;
};

std::size_t number_of(std::string_view digits) {
  std::size_t number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

// Two numbers with something between them, at the end of a name.
std::optional<Indices> numbers_in(std::string_view name) {
  const std::size_t second = name.find_last_not_of(kDigits) + 1;
  const std::size_t end = name.substr(0, second).find_last_of(kDigits) + 1;
  if (second == name.size() || end == 0) return std::nullopt;
  const std::size_t first = name.substr(0, end).find_last_not_of(kDigits) + 1;
  return Indices{name.substr(0, first),
                 name.substr(end, second - end),
                 {number_of(name.substr(first, end - first)), number_of(name.substr(second))}};
}

// Two digits at the end of a name.
std::optional<Indices> digits_in(std::string_view name) {
  const std::size_t digits = name.find_last_not_of(kDigits) + 1;
  if (name.size() - digits != 2) return std::nullopt;
  return Indices{name.substr(0, digits),
                 {},
                 {number_of(name.substr(digits, 1)), number_of(name.substr(digits + 1))}};
}

// The cells that the names give; nothing unless they differ in their indices only, and each has its
// own.
template <typename IndicesIn>
std::optional<std::vector<Cell>> cells_of(const std::vector<std::string>& names,
                                          const IndicesIn& indices_in) {
  std::vector<Cell> cells;
  std::set<Cell> all;
  std::optional<Indices> first;
  for (const std::string& name : names) {
    const auto own = indices_in(name);
    if (!own) return std::nullopt;
    if (!first) first = own;
    if (own->before != first->before || own->between != first->between) return std::nullopt;
    if (!all.insert(own->cell).second) return std::nullopt;
    cells.push_back(own->cell);
  }
  return cells;
}

struct Extent {
  std::size_t least_row = 0;
  std::size_t least_column = 0;
  std::size_t rows = 0;
  std::size_t columns = 0;
};

Extent extent_of(const std::vector<Cell>& cells) {
  Cell least = cells.front();
  Cell greatest = cells.front();
  for (const auto& [row, column] : cells) {
    least = {std::min(least.first, row), std::min(least.second, column)};
    greatest = {std::max(greatest.first, row), std::max(greatest.second, column)};
  }
  return {least.first, least.second, greatest.first - least.first + 1,
          greatest.second - least.second + 1};
}

SkinLayout layout_of(const std::vector<Cell>& cells, std::size_t rows, std::size_t columns) {
  SkinLayout layout;
  layout.is_grid = true;
  layout.width = static_cast<double>(columns);
  layout.height = static_cast<double>(rows);
  layout.elements.reserve(cells.size());
  for (const auto& [row, column] : cells) {
    layout.elements.push_back({static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5});
  }
  return layout;
}

// Distinct cells fill their extent if they are as many as its cells.
std::optional<SkinLayout> full_grid(std::optional<std::vector<Cell>> cells) {
  if (!cells || cells->empty()) return std::nullopt;
  const Extent extent = extent_of(*cells);
  const bool has_axes = extent.rows > 1 && extent.columns > 1;
  if (!has_axes || extent.rows > cells->size() || extent.columns > cells->size() ||
      extent.rows * extent.columns != cells->size()) {
    return std::nullopt;
  }
  for (auto& [row, column] : *cells) {
    row -= extent.least_row;
    column -= extent.least_column;
  }
  return layout_of(*cells, extent.rows, extent.columns);
}

std::optional<SkinLayout> named_grid(const std::vector<std::string>& names) {
  auto grid = full_grid(cells_of(names, numbers_in));
  return grid ? grid : full_grid(cells_of(names, digits_in));
}

// The columns of a shape with two axes; 0 without.
std::size_t columns_of_shape(const std::vector<std::size_t>& shape) {
  std::vector<std::size_t> axes;
  std::copy_if(shape.begin(), shape.end(), std::back_inserter(axes),
               [](std::size_t length) { return length > 1; });
  return axes.size() > 1 ? axes.back() : 0;
}

std::size_t squarest_columns(std::size_t count) {
  const double root = std::sqrt(static_cast<double>(count));
  auto rows = static_cast<std::size_t>(root);
  while (rows > 1 && count % rows != 0) --rows;
  const std::size_t columns = count / std::max<std::size_t>(rows, 1);
  if (columns <= kLongestRow || columns <= 4 * rows) return columns;
  return static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count) * 2.0)));
}

}  // namespace

SkinLayout grid_layout(const std::vector<std::string>& names, std::size_t count,
                       const std::vector<std::size_t>& shape) {
  const std::size_t of_shape = columns_of_shape(shape);
  if (of_shape == 0) {
    if (auto named = named_grid(names)) return *named;
  }
  const std::size_t columns =
      std::clamp<std::size_t>(of_shape > 0 ? of_shape : squarest_columns(count), 1, count);
  std::vector<Cell> cells;
  cells.reserve(count);
  for (std::size_t i = 0; i < count; ++i) cells.emplace_back(i / columns, i % columns);
  return layout_of(cells, (count + columns - 1) / columns, columns);
}

}  // namespace somato
