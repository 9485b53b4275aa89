#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace somato {

/// A point of a picture, in pixels; y grows downwards.
struct Point {
  double x = 0.0;
  double y = 0.0;
};

/// Fill and outline of a shape. Empty strings inherit those of its group.
struct Paint {
  std::string fill{};         ///< A colour such as `#rrggbb`, or `none`.
  std::string stroke{};       ///< The same for the outline.
  double stroke_width = 0.0;  ///< In pixels; 0 leaves it to the group.
  std::string dashes{};       ///< Lengths of dashes and gaps, such as "4 3"; empty: inherited.
};

/// Alignment of a text relative to its point.
enum class Anchor { kStart, kMiddle, kEnd };

/// Style of a text, in the reader's default sans-serif font.
struct TextStyle {
  double size = 12.0;  ///< In pixels.
  Anchor anchor = Anchor::kStart;
  bool bold = false;
  std::string fill = "#222222";
};

/// Writes a standalone SVG picture: no scripts, no fonts or pictures from
/// elsewhere, the same bytes
/// for the same calls on every machine. Texts may hold anything: they are escaped. A `tooltip`,
/// when not empty, is shown to readers who point at the shape.
class SvgWriter {
 public:
  /// A white picture, in pixels, called `name` for readers who do not see it. Throws
  /// InvalidArgument unless both sides are finite and positive.
  SvgWriter(double width, double height, std::string_view name);

  /// Shapes up to the matching close_group() are scaled by `scale`, moved by `offset` and painted
  /// with `paint`. `name` identifies the content for programs, in the attribute `class`.
  void open_group(std::string_view name, Point offset = {}, const Paint& paint = {},
                  Point scale = {1.0, 1.0});
  void close_group();

  void rectangle(Point corner, double width, double height, const Paint& paint = {},
                 std::string_view tooltip = {});
  void circle(Point centre, double radius, const Paint& paint = {}, std::string_view tooltip = {});
  void polygon(const std::vector<Point>& corners, const Paint& paint = {},
               std::string_view tooltip = {});

  /// A sector of a circle, clockwise from one angle to another one, in turns from the top; from 0
  /// to 1 is a circle. Throws InvalidArgument unless 0 <= from < to <= 1.
  void sector(Point centre, double radius, double from, double to, const Paint& paint = {},
              std::string_view tooltip = {});

  /// Straight lines between each pair of points 2i and 2i + 1, as one shape.
  void segments(const std::vector<Point>& ends, const Paint& paint = {});

  /// A picture in "data:...", stretched over the rectangle.
  void image(Point corner, double width, double height, std::string_view data);

  /// One line of text; the point is on its base line.
  void text(Point at, std::string_view content, const TextStyle& style = {},
            std::string_view tooltip = {});

  /// The picture. Throws InvalidArgument when a group is still open.
  std::string finish() &&;

 private:
  void end_shape(std::string_view tag, const Paint& paint, std::string_view tooltip);

  std::string svg_;
  int open_groups_ = 0;
};

/// `value` with at most `decimals` digits after the point, without trailing zeros; a point is a
/// point in every locale. Throws InvalidArgument for a value that is not finite.
std::string svg_number(double value, int decimals = 2);

/// `text` escaped for XML: & < > " ' are escaped; control characters and invalid UTF-8 become
/// U+FFFD, white space becomes a space.
std::string xml_escaped(std::string_view text);

}  // namespace somato
