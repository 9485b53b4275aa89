#include <gtest/gtest.h>

#include <algorithm>

#include "somato/bodies/object_table.h"
#include "somato/simulation/simulated_explorer.h"

namespace somato {
namespace {

// The first exploration of an object of all_senses.toml as the only object of its table, because
// the placement and the noise of an exploration depend on the number of the object.
Exploration explored_separately(const std::string& name) {
  const ObjectTable table = own_object_table("all_senses", declared_materials()).value();
  const auto object = std::find_if(table.objects.begin(), table.objects.end(),
                                   [&](const Object& one) { return one.name == name; });
  const auto explorer =
      simulated_explorer(ExploringBody::kAllSenses, {{*object}, {}}, {}, 1).value();
  return explorer->explore(0, 0).value();
}

bool same(const Exploration& a, const Exploration& b, const std::string& channel) {
  return (*find_channel(a, channel))->frames == (*find_channel(b, channel))->frames;
}

TEST(AllSensesObjects, OfOneSurfaceOrOneFormAreTheSameToTheOtherSenses) {
  const Exploration smooth = explored_separately("cylinder_50_smooth_soft");
  const Exploration grained = explored_separately("cylinder_50_grained_soft");
  const Exploration block = explored_separately("block_50_smooth_soft");
  const Exploration hard = explored_separately("cylinder_50_smooth_hard");
  for (const char* channel : {"joints", "touch", "touch_change"}) {
    EXPECT_TRUE(same(smooth, grained, channel)) << channel;
    EXPECT_FALSE(same(smooth, block, channel)) << channel;
  }
  EXPECT_TRUE(same(smooth, block, "sound"));
  EXPECT_FALSE(same(smooth, grained, "sound"));
  for (const Exploration* soft : {&grained, &block}) {
    EXPECT_TRUE(same(smooth, *soft, "potentiometer"));
  }
  EXPECT_FALSE(same(smooth, hard, "potentiometer"));
}

}  // namespace
}  // namespace somato
