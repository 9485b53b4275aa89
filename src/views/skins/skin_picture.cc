#include "views/skins/skin_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "maps/svg/colour_bar.h"
#include "maps/svg/colours.h"
#include "maps/svg/svg.h"
#include "maps/svg/text_layout.h"
#include "somato/core/check.h"
#include "views/skins/skin_layout.h"

namespace somato {
namespace {

void check(const SkinPicture& picture) {
  require(!picture.frames.empty(), "a picture of a skin needs a frame");
  const std::size_t elements = picture.frames.front().values.size();
  require(elements > 0, "a frame needs an element");
  require(picture.element_names.empty() || picture.element_names.size() == elements,
          "a frame needs one name per element");
  require(std::isfinite(picture.least) && std::isfinite(picture.greatest) &&
              picture.least <= picture.greatest,
          "the limits of the colours must be finite and in order");
  for (const SkinFrame& frame : picture.frames) {
    require(frame.values.size() == elements, "frames must have the same elements");
    require(!picture.places || picture.places->places.size() == elements,
            "a frame needs one place per element");
    require(frame.valid.empty() || frame.valid.size() == elements,
            "a frame needs one mark per element for missing values");
    require(std::all_of(frame.values.begin(), frame.values.end(),
                        [](float value) { return std::isfinite(value); }),
            "a frame's values must be finite");
  }
}

// Lengths in pixels.
class SkinDrawing {
 public:
  explicit SkinDrawing(const SkinPicture& picture)
      : picture_(picture),
        layout_(layout_of(picture)),
        pitch_(std::clamp(kSkinWidth / layout_.width, 7.0, 30.0)),
        range_{picture.least, picture.greatest},
        columns_(
            std::min(picture.frames.size(), picture.columns > 0 ? picture.columns : kMostColumns)) {
    title_ = wrapped(picture.title, inner_width(), kBoldness * kTitleSize, 3);
    caption_ = wrapped(picture.caption, inner_width(), kCaptionSize, 8);
  }

  std::string draw() const {
    SvgWriter svg(inner_width() + 2 * kMargin, bar_top() + kColourBarHeight + kMargin,
                  picture_.title);
    write(svg, kMargin, title_, {.size = kTitleSize, .bold = true});
    write(svg, caption_top(), caption_, {.size = kCaptionSize, .fill = "#444444"});
    for (std::size_t i = 0; i < picture_.frames.size(); ++i) {
      svg.open_group("frame", corner(i));
      draw_frame(svg, picture_.frames[i]);
      svg.close_group();
    }
    draw_colour_bar(svg, {kMargin, bar_top()}, std::min(inner_width(), kSkinWidth), range_,
                    picture_.unit);
    return std::move(svg).finish();
  }

 private:
  static constexpr double kMargin = 20.0;
  static constexpr double kGap = 28.0;
  static constexpr double kSkinWidth = 320.0;
  static constexpr double kLeastWidth = 200.0;
  static constexpr double kTitleSize = 18.0;
  static constexpr double kCaptionSize = 12.0;
  static constexpr double kFrameTitleSize = 14.0;
  static constexpr double kFrameTitleHeight = 26.0;
  static constexpr double kNameSize = 11.0;
  static constexpr double kNameHeight = 22.0;
  static constexpr double kBarGap = 12.0;
  static constexpr std::size_t kMostColumns = 4;
  static constexpr std::size_t kMostTooltips = 2500;

  static SkinLayout layout_of(const SkinPicture& picture) {
    if (picture.places) return skin_layout(*picture.places);
    return skin_layout(picture.element_names, picture.frames.front().values.size(), picture.shape);
  }

  static double line_height(double size) { return std::ceil(size * 1.35); }

  static void write(SvgWriter& svg, double top, const std::vector<std::string>& lines,
                    const TextStyle& style) {
    for (const std::string& line : lines) {
      svg.text({kMargin, top + style.size}, line, style);
      top += line_height(style.size);
    }
  }

  double frame_width() const { return std::max(kLeastWidth, layout_.width * pitch_); }
  double frame_height() const {
    return kFrameTitleHeight + layout_.height * pitch_ +
           (layout_.fingers.empty() ? 0.0 : kNameHeight);
  }
  double inner_width() const {
    return static_cast<double>(columns_) * (frame_width() + kGap) - kGap;
  }
  double caption_top() const {
    return kMargin + static_cast<double>(title_.size()) * line_height(kTitleSize);
  }
  double frames_top() const {
    return caption_top() + static_cast<double>(caption_.size()) * line_height(kCaptionSize) + 6;
  }
  Point corner(std::size_t frame) const {
    const std::size_t row = frame / columns_;
    return {kMargin + static_cast<double>(frame % columns_) * (frame_width() + kGap),
            frames_top() + static_cast<double>(row) * (frame_height() + kGap)};
  }
  double bar_top() const { return corner(picture_.frames.size() - 1).y + frame_height() + kBarGap; }

  void draw_frame(SvgWriter& svg, const SkinFrame& frame) const {
    write_line(svg, {0, kFrameTitleSize}, frame.title, frame_width(),
               {.size = kFrameTitleSize, .bold = true});
    svg.open_group("skin", {(frame_width() - layout_.width * pitch_) / 2, kFrameTitleHeight});
    draw_background(svg);
    draw_segments(svg);
    for (std::size_t i = 0; i < frame.values.size(); ++i) draw_element(svg, frame, i);
    svg.close_group();
  }

  void draw_background(SvgWriter& svg) const {
    if (!layout_.background) return;
    const auto& [corner, width, height] = layout_.background->box;
    svg.image({corner.x * pitch_, corner.y * pitch_}, width * pitch_, height * pitch_,
              layout_.background->image);
  }

  // Over a picture, groups are outlined only.
  void draw_segments(SvgWriter& svg) const {
    const std::string fill = layout_.background ? "none" : "#eeeeee";
    for (const SkinLayout::Segment& segment : layout_.segments) {
      svg.rectangle({segment.corner.x * pitch_, segment.corner.y * pitch_}, segment.width * pitch_,
                    segment.height * pitch_, {.fill = fill, .stroke = "#bbbbbb"});
    }
    for (const SkinLayout::Finger& finger : layout_.fingers) {
      svg.text({finger.foot.x * pitch_, finger.foot.y * pitch_ + kNameSize + 4}, finger.name,
               {.size = kNameSize, .anchor = Anchor::kMiddle, .fill = "#444444"});
    }
  }

  void draw_element(SvgWriter& svg, const SkinFrame& frame, std::size_t element) const {
    const Point at{layout_.elements[element].x * pitch_, layout_.elements[element].y * pitch_};
    const std::string tooltip =
        frame.values.size() <= kMostTooltips ? tooltip_of(frame, element) : std::string();
    if (!layout_.is_grid) {
      svg.circle(at, 0.42 * pitch_, paint_of(frame, element), tooltip);
    } else {
      svg.rectangle({at.x - pitch_ / 2, at.y - pitch_ / 2}, pitch_, pitch_,
                    paint_of(frame, element), tooltip);
    }
  }

  static bool is_missing(const SkinFrame& frame, std::size_t element) {
    return !frame.valid.empty() && frame.valid[element] == 0;
  }

  Paint paint_of(const SkinFrame& frame, std::size_t element) const {
    if (is_missing(frame, element)) return {.fill = "#ffffff", .stroke = "#888888"};
    const std::string fill =
        to_string(sequential_colour(range_.place_of(static_cast<double>(frame.values[element]))));
    // Outlined in it, or the white between cells shines through where a viewer smooths edges.
    return {.fill = fill, .stroke = layout_.is_grid ? fill : "#222222", .stroke_width = 0.5};
  }

  std::string tooltip_of(const SkinFrame& frame, std::size_t element) const {
    const std::string name = picture_.element_names.empty() ? fmt::format("element {}", element + 1)
                                                            : picture_.element_names[element];
    if (is_missing(frame, element)) return name + ": missing";
    const std::string value = readable_number(static_cast<double>(frame.values[element]));
    return name + ": " + value + (picture_.unit.empty() ? "" : " " + picture_.unit);
  }

  const SkinPicture& picture_;
  SkinLayout layout_;
  double pitch_;
  ValueRange range_;
  std::size_t columns_;
  std::vector<std::string> title_;
  std::vector<std::string> caption_;
};

}  // namespace

std::string draw_skin(const SkinPicture& picture) {
  check(picture);
  return SkinDrawing(picture).draw();
}

}  // namespace somato
