#include "views/skins/skin_places.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace somato {
namespace {

double distance_to_nearest(const std::vector<Point>& places, std::size_t element) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (i == element) continue;
    const double x = places[i].x - places[element].x;
    const double y = places[i].y - places[element].y;
    least = std::min(least, std::sqrt(x * x + y * y));
  }
  return least;
}

void extend(std::pair<Point, Point>& bounds, const Point& point) {
  bounds.first = {std::min(bounds.first.x, point.x), std::min(bounds.first.y, point.y)};
  bounds.second = {std::max(bounds.second.x, point.x), std::max(bounds.second.y, point.y)};
}

}  // namespace

double spacing_of(const std::vector<Point>& places) {
  if (places.size() < 2) return 1.0;
  std::vector<double> distances;
  distances.reserve(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    distances.push_back(distance_to_nearest(places, i));
  }
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

std::pair<Point, Point> bounds_of(const std::vector<Point>& places,
                                  const std::optional<SkinBackground>& background) {
  std::pair<Point, Point> bounds{places.front(), places.front()};
  for (const Point& place : places) extend(bounds, place);
  if (!background) return bounds;
  const Point corner = background->corner;
  extend(bounds, corner);
  extend(bounds, {corner.x + background->width, corner.y + background->height});
  return bounds;
}

}  // namespace somato
