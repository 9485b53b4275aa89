#include "live/kept_explorations.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "live/viewing.h"

namespace somato::live {
namespace {

// Two explorations of a hand, of which the view begins with the first.
class KeptExplorationsTest : public ::testing::Test {
 protected:
  Recording recording_ = testing::hand_source(2).recording;
  Exploration second_ = recording_.explorations.back();
  std::vector<Exploration> saved_;
  ExplorationSink sink_ = [this](Exploration exploration) -> Result<void> {
    saved_.push_back(std::move(exploration));
    return {};
  };

  void SetUp() override { recording_.explorations.pop_back(); }
};

TEST_F(KeptExplorationsTest, SavesWhatIsAddedWithTheGivenLabels) {
  KeptExplorations kept(recording_, sink_);
  ASSERT_TRUE(kept.add(second_, nullptr));
  EXPECT_EQ(kept.count(), 2U);
  EXPECT_EQ(kept.scene(1), nullptr);
  ASSERT_TRUE(kept.name(1, {"object", "cup"}));
  ASSERT_TRUE(kept.save_before(2));
  ASSERT_EQ(saved_.size(), 1U);
  EXPECT_EQ(saved_[0].labels[0].value, "cup");
  EXPECT_EQ(saved_[0].channels, second_.channels);
  EXPECT_FALSE(kept.name(1, {"object", "bowl"})) << "it is saved";
}

TEST_F(KeptExplorationsTest, RefusesOneThatIsUnlikeTheOthers) {
  KeptExplorations kept(recording_, sink_);
  ASSERT_TRUE(kept.name(1, {"object", "cup"}));
  second_.channels.pop_back();
  EXPECT_FALSE(kept.add(second_, nullptr));
  EXPECT_EQ(kept.count(), 1U);
  EXPECT_TRUE(kept.names().empty()) << "its labels are forgotten";
}

TEST_F(KeptExplorationsTest, SavesTheOthersThoughOneFails) {
  const ExplorationSink sink = [this](Exploration exploration) -> Result<void> {
    saved_.push_back(std::move(exploration));
    if (saved_.size() == 1) return fail(ErrorKind::kSystem, "the disk is full");
    return {};
  };
  KeptExplorations kept(recording_, sink);
  ASSERT_TRUE(kept.add(second_, nullptr));
  ASSERT_TRUE(kept.add(second_, nullptr));
  EXPECT_FALSE(kept.save_before(3));
  EXPECT_EQ(saved_.size(), 2U);
  EXPECT_TRUE(kept.save_before(3));
}

TEST_F(KeptExplorationsTest, SavesNothingWithoutASink) {
  const ExplorationSink none;
  KeptExplorations kept(recording_, none);
  ASSERT_TRUE(kept.add(second_, nullptr));
  EXPECT_TRUE(kept.save_before(2));
  EXPECT_TRUE(kept.name(0, {"object", "cup"}));
}

}  // namespace
}  // namespace somato::live
