#include "somato/bodies/object.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "somato/core/check.h"

namespace somato {
namespace {

constexpr double kHalfTurn = std::numbers::pi;

Object object_of(Shape shape, std::array<double, 3> size, double top_diameter = 0.0) {
  Object object;
  object.shape = shape;
  object.size = size;
  object.top_diameter = top_diameter;
  return object;
}

// The area of an object's section at a height above its foot, from school geometry.
double section(const Object& object, double z) {
  const auto [width, depth, height] = object.size;
  const double round = kHalfTurn / 4.0;
  switch (object.shape) {
    case Shape::kBlock:
      return width * depth;
    case Shape::kCylinder:
      return round * width * width;
    case Shape::kCone: {
      const double d = width + (object.top_diameter - width) * z / height;
      return round * d * d;
    }
    case Shape::kCapsule: {
      const double r = width / 2.0;
      const double beyond = std::max({r - z, z - (height - r), 0.0});
      return kHalfTurn * (r * r - beyond * beyond);
    }
    default: {
      const double u = 2.0 * z / height - 1.0;
      return round * width * depth * (1.0 - u * u);
    }
  }
}

// Thin slices, one on the other.
double sliced_volume(const Object& object) {
  constexpr int kSlices = 20000;
  const double thickness = object.size[2] / kSlices;
  double sum = 0.0;
  for (int i = 0; i < kSlices; ++i) sum += section(object, (i + 0.5) * thickness) * thickness;
  return sum;
}

// The length of a polygon of many corners in the ellipse.
double polygon(double width, double depth) {
  constexpr int kCorners = 200000;
  double sum = 0.0;
  for (int i = 0; i < kCorners; ++i) {
    const double a = 2.0 * kHalfTurn * i / kCorners;
    const double b = 2.0 * kHalfTurn * (i + 1) / kCorners;
    sum += std::hypot(width / 2.0 * (std::cos(b) - std::cos(a)),
                      depth / 2.0 * (std::sin(b) - std::sin(a)));
  }
  return sum;
}

TEST(Volume, IsThatOfThinSlices) {
  for (const Object& object :
       {object_of(Shape::kSphere, {72, 72, 72}), object_of(Shape::kCylinder, {62, 62, 121}),
        object_of(Shape::kBlock, {58, 50, 110}), object_of(Shape::kCone, {60, 60, 90}),
        object_of(Shape::kCone, {60, 60, 90}, 25), object_of(Shape::kEllipsoid, {40, 60, 100}),
        object_of(Shape::kCapsule, {40, 40, 100}), object_of(Shape::kCapsule, {40, 40, 40})}) {
    const double sliced = sliced_volume(object);
    EXPECT_NEAR(volume(object), sliced, 1e-6 * sliced) << choice_name(object.shape);
  }
}

TEST(Volume, OfAMeshRequiresItsFile) {
  EXPECT_THROW((void)volume(object_of(Shape::kMesh, {1, 1, 1})), InvalidArgument);
}

TEST(Mass, IsInKilogramsOfCubicMillimetres) {
  Material water;
  water.density = 1000.0;
  EXPECT_DOUBLE_EQ(mass_of(water, 1e6), 1.0);  // a litre
}

TEST(Girth, OfRoundAndOfSquareThings) {
  EXPECT_NEAR(girth(object_of(Shape::kSphere, {72, 72, 72})), 226.19467, 1e-5);
  EXPECT_NEAR(girth(object_of(Shape::kCapsule, {40, 40, 90})), 40 * kHalfTurn, 1e-12);
  EXPECT_NEAR(girth(object_of(Shape::kCone, {50, 50, 90}, 20)), 50 * kHalfTurn, 1e-12);
  EXPECT_EQ(girth(object_of(Shape::kBlock, {58, 50, 110})), 216.0);
  EXPECT_EQ(girth(object_of(Shape::kMesh, {0, 0, 0})), 0.0);
}

TEST(Girth, OfAnEllipseIsThatOfAPolygonOfManyCorners) {
  EXPECT_NEAR(girth(object_of(Shape::kEllipsoid, {4, 2, 9})), 9.688448220547675, 1e-13);
  for (const auto& [width, depth] : {std::pair{40.0, 60.0}, {60.0, 40.0}, {1.0, 1000.0}}) {
    const double length = polygon(width, depth);
    EXPECT_NEAR(girth(object_of(Shape::kEllipsoid, {width, depth, 5})), length, 1e-8 * length);
    EXPECT_NEAR(girth(object_of(Shape::kMesh, {width, depth, 5})), length, 1e-8 * length);
  }
}

TEST(Labels, SayWhatIsKnownOfTheThing) {
  Object boccia = object_of(Shape::kSphere, {72, 72, 72});
  boccia.name = "boccia";
  boccia.material.name = "plastic";
  boccia.material.hardness = Hardness::kSoft;
  EXPECT_EQ(labels_of(boccia, 4), (std::vector<Label>{{"object", "boccia"},
                                                      {"shape", "sphere"},
                                                      {"symmetry", "radial"},
                                                      {"girth", "226.2"},
                                                      {"width", "72.0"},
                                                      {"depth", "72.0"},
                                                      {"material", "plastic"},
                                                      {"hardness", "soft"},
                                                      {"trial", "5"}}));
}

}  // namespace
}  // namespace somato
