#pragma once

#include <algorithm>
#include <cstdio>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "maps/pictures/xml.h"
#include "maps/svg/svg.h"
#include "maps/svg/text_layout.h"

namespace somato::test {

/// The pixels that something covers, outlines left out.
struct Box {
  double left = std::numeric_limits<double>::infinity();
  double top = std::numeric_limits<double>::infinity();
  double right = -std::numeric_limits<double>::infinity();
  double bottom = -std::numeric_limits<double>::infinity();

  void add(Point point) {
    left = std::min(left, point.x);
    top = std::min(top, point.y);
    right = std::max(right, point.x);
    bottom = std::max(bottom, point.y);
  }
  void add(const Box& box) {
    add(Point{box.left, box.top});
    add(Point{box.right, box.bottom});
  }
  Point centre() const { return {(left + right) / 2, (top + bottom) / 2}; }

  /// Numbers of a picture are rounded to hundredths, so that `slack` is allowed.
  bool holds(const Box& box, double slack = 0.02) const {
    return box.left >= left - slack && box.top >= top - slack && box.right <= right + slack &&
           box.bottom <= bottom + slack;
  }
  bool overlaps(const Box& box) const {
    return left < box.right && box.left < right && top < box.bottom && box.top < bottom;
  }
};

/// A shape or text with what it covers in the picture.
struct Drawn {
  Element element;
  Box box;
};

/// The transformation of an element's points by the groups around it.
struct Placement {
  Point offset{0.0, 0.0};
  Point scale{1.0, 1.0};

  Point of(Point point) const {
    return {offset.x + scale.x * point.x, offset.y + scale.y * point.y};
  }
  Placement within(const std::string& transform) const {
    Point moved{0.0, 0.0};
    Point stretched{1.0, 1.0};
    read(transform, "translate(", moved);
    read(transform, "scale(", stretched);
    return {of(moved), {scale.x * stretched.x, scale.y * stretched.y}};
  }
  static void read(const std::string& transform, const std::string& name, Point& into) {
    const std::size_t at = transform.find(name);
    if (at == std::string::npos) return;
    std::sscanf(transform.c_str() + at + name.size(), "%lf,%lf", &into.x, &into.y);
  }
};

inline double number_of(const Element& element, std::string_view attribute) {
  return std::stod(element[attribute]);
}

inline std::vector<Point> corners_of(const Element& polygon) {
  std::istringstream points(polygon["points"]);
  std::vector<Point> corners;
  Point corner;
  char comma = 0;
  while (points >> corner.x >> comma >> corner.y) corners.push_back(corner);
  return corners;
}

inline double width_of_text(const Element& text) {
  const double boldness = text["font-weight"] == "bold" ? kBoldness : 1.0;
  return boldness * text_width(text.text, number_of(text, "font-size"));
}

/// From the top of the capitals to below the letters that reach down, as in common fonts.
inline Box box_of_text(const Element& text) {
  const double size = number_of(text, "font-size");
  const double width = width_of_text(text);
  const std::string anchor = text["text-anchor"];
  const double before = anchor == "middle" ? width / 2 : anchor == "end" ? width : 0.0;
  const double left = number_of(text, "x") - before;
  const double base = number_of(text, "y");
  return {left, base - 0.75 * size, left + width, base + 0.22 * size};
}

/// Before the groups around it place it; nothing for what has no extent of its own.
inline Box own_box(const Element& shape) {
  Box box;
  if (shape.name == "text") return box_of_text(shape);
  if (shape.name == "rect") {
    const Point corner{number_of(shape, "x"), number_of(shape, "y")};
    box.add(corner);
    box.add(Point{corner.x + number_of(shape, "width"), corner.y + number_of(shape, "height")});
  } else if (shape.name == "circle") {
    const double radius = number_of(shape, "r");
    const Point centre{number_of(shape, "cx"), number_of(shape, "cy")};
    box.add(Point{centre.x - radius, centre.y - radius});
    box.add(Point{centre.x + radius, centre.y + radius});
  } else {
    for (const Point& corner : corners_of(shape)) box.add(corner);
  }
  return box;
}

/// All shapes and texts below `root`, groups and lines left out.
inline void collect_drawn(const Element& root, const Placement& placement,
                          std::vector<Drawn>& drawn) {
  for (const Element& child : root.children) {
    if (child.name == "g") {
      collect_drawn(child, placement.within(child["transform"]), drawn);
    } else if (child.name != "title" && child.name != "path") {
      const Box own = own_box(child);
      Box box;
      box.add(placement.of({own.left, own.top}));
      box.add(placement.of({own.right, own.bottom}));
      drawn.push_back({child, box});
    }
  }
}

inline std::vector<Drawn> drawn_in(const Element& root) {
  std::vector<Drawn> drawn;
  collect_drawn(root, Placement().within(root["transform"]), drawn);
  return drawn;
}

/// Those of one kind of element.
inline std::vector<Drawn> drawn_in(const Element& root, std::string_view name) {
  std::vector<Drawn> drawn = drawn_in(root);
  std::erase_if(drawn, [&](const Drawn& one) { return one.element.name != name; });
  return drawn;
}

inline Box box_around(const std::vector<Drawn>& drawn) {
  Box box;
  for (const Drawn& one : drawn) box.add(one.box);
  return box;
}

}  // namespace somato::test
