#include "somato/bodies/object.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "somato/core/check.h"

namespace somato {
namespace {

constexpr double kPi = std::numbers::pi;

// The length round an ellipse, exactly: by the arithmetic-geometric mean of its half axes, whose
// digits double with every step.
double round_ellipse(double width, double depth) {
  double a = width / 2.0;
  double b = depth / 2.0;
  double sum = (a * a + b * b) / 2.0;
  double weight = 1.0;
  for (int step = 0; step < 12 && a != b; ++step) {
    const double difference = (a - b) / 2.0;
    const double mean = (a + b) / 2.0;
    sum -= weight * difference * difference;
    b = std::sqrt(a * b);
    a = mean;
    weight *= 2.0;
  }
  return a > 0.0 ? 2.0 * kPi * sum / a : 0.0;
}

double capsule_volume(double diameter, double height) {
  return kPi * diameter * diameter * ((height - diameter) / 4.0 + diameter / 6.0);
}

double cone_volume(double bottom, double top, double height) {
  return kPi / 12.0 * height * (bottom * bottom + bottom * top + top * top);
}

}  // namespace

const std::vector<std::pair<Shape, std::string>>& Choices<Shape>::all() {
  static const std::vector<std::pair<Shape, std::string>> choices{
      {Shape::kSphere, "sphere"}, {Shape::kCylinder, "cylinder"},   {Shape::kBlock, "block"},
      {Shape::kCone, "cone"},     {Shape::kEllipsoid, "ellipsoid"}, {Shape::kCapsule, "capsule"},
      {Shape::kMesh, "mesh"}};
  return choices;
}

double volume(const Object& object) {
  require(object.shape != Shape::kMesh, "volume: the volume of a mesh requires its file");
  const auto [width, depth, height] = object.size;
  switch (object.shape) {
    case Shape::kCylinder:
      return kPi / 4.0 * width * depth * height;
    case Shape::kBlock:
      return width * depth * height;
    case Shape::kCone:
      return cone_volume(width, object.top_diameter, height);
    case Shape::kCapsule:
      return capsule_volume(width, height);
    default:
      return kPi / 6.0 * width * depth * height;
  }
}

double mass_of(const Material& material, double volume) {
  return material.density * volume * 1e-9;  // a m^3 is 10^9 mm^3
}

double girth(const Object& object) {
  const auto [width, depth, height] = object.size;
  if (object.shape == Shape::kBlock) return 2.0 * (width + depth);
  return round_ellipse(width, depth);
}

bool is_radially_symmetric(const Object& object) {
  return object.shape != Shape::kBlock && object.shape != Shape::kMesh &&
         object.size[0] == object.size[1];
}

std::vector<Label> labels_of(const Object& object, std::size_t trial) {
  return {{"object", object.name},
          {"shape", choice_name(object.shape)},
          {"symmetry", is_radially_symmetric(object) ? "radial" : "none"},
          {"girth", fmt::format("{:.1f}", girth(object))},
          {"width", fmt::format("{:.1f}", object.size[0])},
          {"depth", fmt::format("{:.1f}", object.size[1])},
          {"material", object.material.name},
          {"hardness", choice_name(object.material.hardness)},
          {"trial", fmt::format("{}", trial + 1)}};
}

}  // namespace somato
