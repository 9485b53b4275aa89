#include "recordings/explorations/given_names.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "systems/support/systems.h"

namespace somato {
namespace {

TEST(GivenNames, ReplaceTheLabelOfOneExploration) {
  GivenNames names;
  EXPECT_TRUE(names.empty());
  names.give(1, {"object", "cup"});
  names.give(1, {"object", "mug"});
  EXPECT_FALSE(names.empty());
  const std::vector<Label> own{{"object", "ball"}, {"trial", "1"}};
  EXPECT_EQ(names.labels(0, own), own);
  EXPECT_EQ(names.labels(1, own), (std::vector<Label>{{"object", "mug"}, {"trial", "1"}}));
  names.forget(1);
  EXPECT_EQ(names.labels(1, own), own);
}

// All explorations of a recording have the same labels: validate() refuses others.
TEST(GivenNames, AreTakenBackInTheOppositeOrder) {
  GivenNames names;
  EXPECT_EQ(names.last(), nullptr);
  names.give(1, {"object", "cup"});
  names.give(0, {"object", "ball"});
  names.give(1, {"object", "mug"});
  names.give(1, {"object", "mug"});  // nothing to take back
  EXPECT_EQ(names.last()->before, "cup");
  names.take_back();
  EXPECT_EQ(names.given(1, "object"), "cup");
  names.forget(0);  // an exploration that was discarded
  EXPECT_EQ(names.last()->exploration, 1U);
  names.take_back();
  EXPECT_EQ(names.last(), nullptr);
  EXPECT_EQ(names.given(1, "object"), std::nullopt);
  EXPECT_EQ(names.labels(1, {}), (std::vector<Label>{{"object", "unknown"}}));
  names.give(2, {"object", "cup"});
  names.give(3, {"object", "cup"});
  names.forget_before(3);
  names.take_back();
  EXPECT_EQ(names.last(), nullptr) << "what is no longer kept is not taken back";
}

TEST(GivenNames, AddALabelToAllExplorations) {
  Recording recording = testing::hand_recording(3, 1);
  for (Exploration& one : recording.explorations) one.labels.clear();
  GivenNames names;
  names.give(2, {"object", "cup"});
  const Recording named = names.apply(recording);
  EXPECT_TRUE(validate(named));
  EXPECT_EQ(label_values(named, "object").value(), (std::vector<std::string>{"unknown", "cup"}));
  EXPECT_TRUE(recording.explorations[2].labels.empty());
}

}  // namespace
}  // namespace somato
