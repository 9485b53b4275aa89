#include <optional>
#include <utility>
#include <vector>

#include "views/skins/skin_layout.h"

namespace somato {
namespace {

constexpr double kAround = 0.75;  // from an element of a group to its outline

// Given places, in distances between neighbours from the upper left corner of all.
class PlacedLayout {
 public:
  explicit PlacedLayout(const SkinPlaces& skin)
      : skin_(skin),
        bounds_(bounds_of(skin.places, skin.background)),
        spacing_(spacing_of(skin.places)) {}

  SkinLayout layout() const {
    SkinLayout layout;
    const Point end = at(bounds_.second);
    layout.width = end.x + kAround;
    layout.height = end.y + kAround;
    for (const Point& place : skin_.places) layout.elements.push_back(at(place));
    for (const SkinGroup& group : skin_.groups) add(group, layout);
    if (skin_.background) {
      const SkinBackground& own = *skin_.background;
      layout.background = SkinLayout::Background{
          own.image, {at(own.corner), own.width / spacing_, own.height / spacing_}};
    }
    return layout;
  }

 private:
  Point at(const Point& place) const {
    return {(place.x - bounds_.first.x) / spacing_ + kAround,
            (place.y - bounds_.first.y) / spacing_ + kAround};
  }

  void add(const SkinGroup& group, SkinLayout& layout) const {
    std::vector<Point> own;
    own.reserve(group.elements.size());
    for (const std::size_t i : group.elements) own.push_back(layout.elements[i]);
    const auto [least, greatest] = bounds_of(own, std::nullopt);
    const double width = greatest.x - least.x + 2 * kAround;
    const double height = greatest.y - least.y + 2 * kAround;
    layout.segments.push_back({{least.x - kAround, least.y - kAround}, width, height});
    layout.fingers.push_back({group.name, {(least.x + greatest.x) / 2, greatest.y + kAround}});
  }

  const SkinPlaces& skin_;
  std::pair<Point, Point> bounds_;
  double spacing_;
};

}  // namespace

SkinLayout skin_layout(const SkinPlaces& skin) {
  return PlacedLayout(skin).layout();
}

}  // namespace somato
