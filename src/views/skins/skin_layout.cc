#include "views/skins/skin_layout.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

#include "views/skins/grid_layout.h"

namespace somato {
namespace {

constexpr std::array<std::string_view, 4> kSegments{"proximal", "middle", "distal", "tip"};
constexpr std::array<std::string_view, 5> kFingers{"thumb", "index", "middle", "ring", "little"};
constexpr double kPad = 0.28;
constexpr double kBetweenSegments = 0.2;
constexpr double kBetweenFingers = 0.75;

// An element of a segment of a finger.
struct Part {
  std::string finger;
  std::string_view segment;
  std::size_t number = 1;
  std::size_t element = 0;
};

// The number at the end of "..._3", which is removed; 1 if there is none.
std::size_t take_number(std::string_view& name) {
  const std::size_t digits = name.find_last_not_of("0123456789") + 1;
  std::size_t number = 1;
  if (digits == name.size() || digits == 0 || name[digits - 1] != '_') return number;
  const auto read = std::from_chars(name.data() + digits, name.data() + name.size(), number);
  if (read.ec == std::errc()) name.remove_suffix(name.size() - digits + 1);
  return number;
}

std::optional<Part> part_of(std::string_view name, std::size_t element) {
  const std::size_t whole = name.size();
  const std::size_t number = take_number(name);
  const bool is_numbered = name.size() < whole;
  constexpr std::string_view kPrefix = "taxel_";
  if (name.starts_with(kPrefix)) name.remove_prefix(kPrefix.size());
  for (const std::string_view segment : kSegments) {
    if (name.size() < segment.size() + 2 || !name.ends_with(segment)) continue;
    name.remove_suffix(segment.size());
    if (!name.ends_with('_')) return std::nullopt;
    return Part{std::string(name.substr(0, name.size() - 1)), segment, number, element};
  }
  if (!is_numbered || std::find(kFingers.begin(), kFingers.end(), name) == kFingers.end()) {
    return std::nullopt;
  }
  return Part{std::string(name), "tip", number, element};
}

// Nothing unless all names are those of elements of fingers.
std::optional<std::vector<Part>> parts_of(const std::vector<std::string>& names) {
  if (names.size() < 2) return std::nullopt;
  std::vector<Part> parts;
  parts.reserve(names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    auto part = part_of(names[i], i);
    if (!part) return std::nullopt;
    parts.push_back(std::move(*part));
  }
  return parts;
}

// The elements in each row of a segment, from the palm outwards, as the simulated hands have them
// (models/lucs_haptic_hand_2.xml, lucs_haptic_hand_3.xml); other numbers nearly square.
std::vector<std::size_t> row_sizes(std::size_t count, std::string_view segment) {
  if (count == 7) return {2, 3, 2};
  if (count == 8) return {3, 2, 3};
  if (count == 3 && segment == "distal") return {2, 1};
  if (count <= 3) return std::vector<std::size_t>(count, 1);
  const auto columns = static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count))));
  const std::size_t rows = (count + columns - 1) / columns;
  std::vector<std::size_t> sizes;
  sizes.reserve(rows);
  for (std::size_t row = 0; row < rows; ++row) sizes.push_back((count + row) / rows);
  return sizes;
}

using Row = std::vector<std::size_t>;  // elements

std::vector<Row> rows_of(std::vector<Part> parts, std::string_view segment) {
  std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
    return std::pair(a.number, a.element) < std::pair(b.number, b.element);
  });
  std::vector<Row> rows;
  auto next = parts.begin();
  for (const std::size_t size : row_sizes(parts.size(), segment)) {
    Row& row = rows.emplace_back();
    for (std::size_t i = 0; i < size; ++i) row.push_back((next++)->element);
  }
  return rows;
}

// The rows of each segment of a finger, from the palm outwards.
std::vector<std::vector<Row>> segments_of(const std::vector<Part>& parts,
                                          const std::string& finger) {
  std::vector<std::vector<Row>> segments;
  for (const std::string_view name : kSegments) {
    std::vector<Part> own;
    std::copy_if(parts.begin(), parts.end(), std::back_inserter(own),
                 [&](const Part& part) { return part.finger == finger && part.segment == name; });
    if (!own.empty()) segments.push_back(rows_of(std::move(own), name));
  }
  return segments;
}

// In the order of their first elements, with the thumb first.
std::vector<std::string> fingers_of(const std::vector<Part>& parts) {
  std::vector<std::string> names;
  for (const Part& part : parts) {
    if (std::find(names.begin(), names.end(), part.finger) == names.end()) {
      names.push_back(part.finger);
    }
  }
  const auto thumb = std::find(names.begin(), names.end(), "thumb");
  if (thumb != names.end()) std::rotate(names.begin(), thumb, thumb + 1);
  return names;
}

double width_of(const std::vector<Row>& rows) {
  std::size_t widest = 0;
  for (const Row& row : rows) widest = std::max(widest, row.size());
  return static_cast<double>(widest) + 2 * kPad;
}

double height_of(const std::vector<Row>& rows) {
  return static_cast<double>(rows.size()) + 2 * kPad;
}

double height_of(const std::vector<std::vector<Row>>& segments) {
  double height = -kBetweenSegments;
  for (const auto& rows : segments) height += height_of(rows) + kBetweenSegments;
  return height;
}

// Segments from the lower end upwards.
void place_finger(const std::vector<std::vector<Row>>& segments, double left, double width,
                  SkinLayout& layout) {
  double bottom = layout.height;
  for (const auto& rows : segments) {
    const double height = height_of(rows);
    layout.segments.push_back({{left, bottom - height}, width, height});
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const double first = left + (width - static_cast<double>(rows[r].size()) + 1) / 2;
      for (std::size_t i = 0; i < rows[r].size(); ++i) {
        layout.elements[rows[r][i]] = {first + static_cast<double>(i),
                                       bottom - kPad - static_cast<double>(r) - 0.5};
      }
    }
    bottom -= height + kBetweenSegments;
  }
}

SkinLayout hand_layout(const std::vector<Part>& parts) {
  SkinLayout layout;
  layout.elements.resize(parts.size());
  const std::vector<std::string> fingers = fingers_of(parts);
  for (const std::string& finger : fingers) {
    layout.height = std::max(layout.height, height_of(segments_of(parts, finger)));
  }
  double left = 0.0;
  for (const std::string& finger : fingers) {
    const auto segments = segments_of(parts, finger);
    double width = 0.0;
    for (const auto& rows : segments) width = std::max(width, width_of(rows));
    place_finger(segments, left, width, layout);
    layout.fingers.push_back({finger, {left + width / 2, layout.height}});
    layout.width = left + width;
    left += width + kBetweenFingers;
  }
  return layout;
}

}  // namespace

SkinLayout skin_layout(const std::vector<std::string>& names, std::size_t count,
                       const std::vector<std::size_t>& shape) {
  const auto parts = parts_of(names);
  return parts ? hand_layout(*parts) : grid_layout(names, count, shape);
}

}  // namespace somato
