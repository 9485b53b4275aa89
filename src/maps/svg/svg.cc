#include "maps/svg/svg.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "base/core/elementary.h"
#include "maps/svg/characters.h"
#include "somato/core/check.h"

namespace somato {
namespace {

std::string attribute(std::string_view name, std::string_view value) {
  return value.empty() ? std::string() : fmt::format(" {}=\"{}\"", name, xml_escaped(value));
}

std::string attributes_of(const Paint& paint) {
  return attribute("fill", paint.fill) + attribute("stroke", paint.stroke) +
         (paint.stroke_width > 0 ? attribute("stroke-width", svg_number(paint.stroke_width)) : "") +
         attribute("stroke-dasharray", paint.dashes);
}

std::string transform_of(Point offset, Point scale) {
  std::string transform;
  if (offset.x != 0 || offset.y != 0) {
    transform = fmt::format("translate({},{})", svg_number(offset.x), svg_number(offset.y));
  }
  if (scale.x != 1 || scale.y != 1) {
    // Six digits: a scale is multiplied by hundreds of cells.
    transform += fmt::format("scale({},{})", svg_number(scale.x, 6), svg_number(scale.y, 6));
  }
  return transform;
}

const char* name_of(Anchor anchor) {
  switch (anchor) {
    case Anchor::kStart:
      return "";  // the default
    case Anchor::kMiddle:
      return "middle";
    case Anchor::kEnd:
      return "end";
  }
  SOMATO_ASSERT(false);
}

// The point of a circle, in turns clockwise from the top.
Point on_circle(Point centre, double radius, double turns) {
  return {centre.x + radius * cosine_of_turns(turns - 0.25),
          centre.y - radius * cosine_of_turns(turns)};
}

const char* entity_of(char character) {
  switch (character) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return nullptr;
  }
}

}  // namespace

std::string svg_number(double value, int decimals) {
  require(std::isfinite(value), "a picture's numbers must be finite");
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string xml_escaped(std::string_view text) {
  std::string escaped;
  for (const char character : utf8_of(characters_of(text))) {
    const char* entity = entity_of(character);
    entity ? escaped += entity : escaped += character;
  }
  return escaped;
}

SvgWriter::SvgWriter(double width, double height, std::string_view name) {
  require(width > 0 && height > 0, "a picture needs a width and a height");
  const std::string w = svg_number(width);
  const std::string h = svg_number(height);
  svg_ = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
      "viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\" role=\"img\">\n<title>{2}</title>\n",
      w, h, xml_escaped(name));
  rectangle({0, 0}, width, height, {.fill = "#ffffff"});
}

void SvgWriter::open_group(std::string_view name, Point offset, const Paint& paint, Point scale) {
  svg_ += "<g" + attribute("class", name) + attribute("transform", transform_of(offset, scale)) +
          attributes_of(paint) + ">\n";
  ++open_groups_;
}

void SvgWriter::close_group() {
  require(open_groups_ > 0, "there is no group to close");
  svg_ += "</g>\n";
  --open_groups_;
}

void SvgWriter::end_shape(std::string_view tag, const Paint& paint, std::string_view tooltip) {
  svg_ += attributes_of(paint);
  svg_ += tooltip.empty() ? std::string("/>\n")
                          : fmt::format("><title>{}</title></{}>\n", xml_escaped(tooltip), tag);
}

void SvgWriter::rectangle(Point corner, double width, double height, const Paint& paint,
                          std::string_view tooltip) {
  svg_ += fmt::format(R"(<rect x="{}" y="{}" width="{}" height="{}")", svg_number(corner.x),
                      svg_number(corner.y), svg_number(width), svg_number(height));
  end_shape("rect", paint, tooltip);
}

void SvgWriter::image(Point corner, double width, double height, std::string_view data) {
  svg_ += fmt::format(
      R"(<image x="{}" y="{}" width="{}" height="{}" preserveAspectRatio="none" href="{}")",
      svg_number(corner.x), svg_number(corner.y), svg_number(width), svg_number(height),
      xml_escaped(data));
  end_shape("image", {}, {});
}

void SvgWriter::circle(Point centre, double radius, const Paint& paint, std::string_view tooltip) {
  svg_ += fmt::format(R"(<circle cx="{}" cy="{}" r="{}")", svg_number(centre.x),
                      svg_number(centre.y), svg_number(radius));
  end_shape("circle", paint, tooltip);
}

void SvgWriter::polygon(const std::vector<Point>& corners, const Paint& paint,
                        std::string_view tooltip) {
  std::string points;
  for (const Point& corner : corners) {
    points += (points.empty() ? "" : " ") + svg_number(corner.x) + "," + svg_number(corner.y);
  }
  svg_ += "<polygon" + attribute("points", points);
  end_shape("polygon", paint, tooltip);
}

void SvgWriter::sector(Point centre, double radius, double from, double to, const Paint& paint,
                       std::string_view tooltip) {
  require(from >= 0 && from < to && to <= 1, "a sector lies between 0 and 1 turns");
  if (to - from > 0.9999) return circle(centre, radius, paint, tooltip);
  const Point start = on_circle(centre, radius, from);
  const Point end = on_circle(centre, radius, to);
  svg_ += fmt::format(R"(<path d="M{} {}L{} {}A{} {} 0 {} 1 {} {}Z")", svg_number(centre.x),
                      svg_number(centre.y), svg_number(start.x), svg_number(start.y),
                      svg_number(radius), svg_number(radius), to - from > 0.5 ? 1 : 0,
                      svg_number(end.x), svg_number(end.y));
  end_shape("path", paint, tooltip);
}

void SvgWriter::segments(const std::vector<Point>& ends, const Paint& paint) {
  require(ends.size() % 2 == 0, "a segment has two ends");
  std::string path;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    path += fmt::format("{}{} {}", i % 2 == 0 ? "M" : "L", svg_number(ends[i].x),
                        svg_number(ends[i].y));
  }
  svg_ += "<path" + attribute("d", path);
  end_shape("path", paint, {});
}

void SvgWriter::text(Point at, std::string_view content, const TextStyle& style,
                     std::string_view tooltip) {
  svg_ += fmt::format(R"(<text x="{}" y="{}" font-size="{}")", svg_number(at.x), svg_number(at.y),
                      svg_number(style.size));
  svg_ += attribute("text-anchor", name_of(style.anchor)) +
          attribute("font-weight", style.bold ? "bold" : "") + attribute("fill", style.fill) + ">" +
          xml_escaped(content);
  if (!tooltip.empty()) svg_ += "<title>" + xml_escaped(tooltip) + "</title>";
  svg_ += "</text>\n";
}

std::string SvgWriter::finish() && {
  require(open_groups_ == 0, "a group is still open");
  return std::move(svg_) + "</svg>\n";
}

}  // namespace somato
