#include "studies/suggestion/channel_roles.h"

#include <gtest/gtest.h>

#include "studies/support/made_senses.h"

namespace somato {
namespace {

using Roles = std::vector<ChannelRole>;

Recording joined(const std::vector<Recording>& channels) {
  Recording all = channels.front();
  for (std::size_t i = 1; i < channels.size(); ++i) {
    for (std::size_t e = 0; e < all.explorations.size(); ++e) {
      all.explorations[e].channels.push_back(channels[i].explorations[e].channels.front());
    }
  }
  return all;
}

TEST(ChannelRoles, DependOnWhatChanges) {
  const Recording recording = joined({testing::frames_as_given("constant", {{5, 5}, {5}}),
                                      testing::frames_as_given("setting", {{50, 50}, {100}}),
                                      testing::frames_as_given("sense", {{1, 2}, {3}}),
                                      testing::frames_as_given("reading", {{1}, {3}})});
  EXPECT_EQ(roles_of(recording), (Roles{ChannelRole::kConstant, ChannelRole::kSetting,
                                        ChannelRole::kSense, ChannelRole::kSense}));
}

TEST(ChannelRoles, SettingsAreSensesIfThereAreNoOthers) {
  EXPECT_EQ(roles_of(testing::frames_as_given("setting", {{50, 50}, {100, 100}})),
            Roles{ChannelRole::kSense});
}

TEST(ChannelRoles, TheSpeedIsASingleElementInMillimetresPerSecond) {
  Recording recording = joined({testing::frames_as_given("touch", {{1, 2}, {3, 3}}),
                                testing::frames_as_given("speed", {{50}, {100}})});
  EXPECT_EQ(roles_of(recording)[1], ChannelRole::kSense);
  EXPECT_FALSE(find_speed(recording).has_value());
  for (Exploration& exploration : recording.explorations) exploration.channels[1].unit = "mm/s";
  EXPECT_EQ(find_speed(recording), 1U);
  EXPECT_EQ(roles_of(recording)[1], ChannelRole::kSetting);
}

}  // namespace
}  // namespace somato
