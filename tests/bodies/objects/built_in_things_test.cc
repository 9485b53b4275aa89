#include "bodies/objects/built_in_things.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

TEST(BuiltInThings, AreKnownByAllTheirProperties) {
  ObjectTable table = own_object_table("lucs3_new", declared_materials()).value();
  table.materials = {declared_materials().front()};
  EXPECT_TRUE(are_built_in(table));
  ObjectTable taller = table;
  taller.objects.back().size[2] += 1.0;
  EXPECT_FALSE(are_built_in(taller));
  ObjectTable softer = table;
  softer.materials.back().stiffness /= 2.0;
  EXPECT_FALSE(are_built_in(softer));
}

}  // namespace
}  // namespace somato
