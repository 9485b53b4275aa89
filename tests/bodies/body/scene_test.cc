#include "somato/bodies/scene.h"

#include <gtest/gtest.h>

#include <set>

namespace somato {
namespace {

template <typename Enum>
void expect_names_for_all(std::size_t count) {
  std::set<std::string> names;
  for (const auto& [value, name] : Choices<Enum>::all()) {
    EXPECT_EQ(choice_name(value), name);
    names.insert(name);
  }
  EXPECT_EQ(names.size(), count);
}

TEST(Scene, NamesItsShapesAndRoles) {
  expect_names_for_all<GeomShape>(6);
  expect_names_for_all<GeomRole>(3);
}

TEST(Scene, HasGeomsThatStandWhereTheyAreUnlessSaidOtherwise) {
  const SceneGeom geom;
  EXPECT_FALSE(geom.body);
  EXPECT_FALSE(geom.taxel);
  EXPECT_EQ(geom.pose.turn, (std::array<double, 4>{1.0, 0.0, 0.0, 0.0}));
}

}  // namespace
}  // namespace somato
