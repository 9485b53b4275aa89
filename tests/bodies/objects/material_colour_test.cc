#include "bodies/objects/material_colour.h"

#include <gtest/gtest.h>

#include <set>

#include "somato/bodies/material.h"

namespace somato {
namespace {

TEST(MaterialColour, IsAnothersForEachDeclaredMaterial) {
  std::set<std::array<double, 3>> colours;
  for (const Material& material : declared_materials()) {
    const auto colour = material_colour(material.name);
    ASSERT_TRUE(colour) << material.name;
    for (const double part : *colour) {
      EXPECT_GE(part, 0.0);
      EXPECT_LE(part, 1.0);
    }
    colours.insert(*colour);
  }
  EXPECT_EQ(colours.size(), declared_materials().size());
}

TEST(MaterialColour, IsNotKnownOfOthers) {
  EXPECT_FALSE(material_colour("cork"));
  EXPECT_FALSE(material_colour(""));
}

}  // namespace
}  // namespace somato
