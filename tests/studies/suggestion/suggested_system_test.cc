#include "studies/suggestion/suggested_system.h"

#include <gtest/gtest.h>

#include "studies/support/made_senses.h"

namespace somato {
namespace {

using Names = std::vector<std::string>;

// The scaled last frame of a channel.
CandidateGroup group_of(const std::string& channel, const Recording& recording,
                        std::size_t number) {
  CandidateGroup group{{number}, {channel_source(channel, recording, number)}, {}};
  group.sources[0].modules.push_back(channel_source("unused", recording, 0).modules[0]);
  FrameFacts facts;
  facts.most_frames = 1;
  group.candidates.push_back(
      {0, codes_of(group.sources[0], facts)[0], Scaling::kUnit, 3, 4.0, {}, 1.0, {}});
  return group;
}

Names names_of(const SystemDescription& system) {
  Names names;
  for (const ModuleDescription& module : system.modules) names.push_back(module.name);
  return names;
}

Value setting_of(const ModuleDescription& module, const std::string& key) {
  return std::get<Value>(module.settings.find(key)->content);
}

TEST(SuggestedSystem, ASinglePartIsTheInputOfTheMap) {
  const Recording recording = testing::made_senses(2, 2, {{"touch", {0, 1}}});
  const std::vector<CandidateGroup> groups{group_of("touch", recording, 0)};
  Suggestion suggestion;
  suggestion.explorations = 4;
  suggestion.parts = {{0, 0, 1.0, 0.5, 0.1}};
  const auto system = system_of(suggestion, groups);
  EXPECT_EQ(names_of(system), (Names{"touch", "last_of_touch", "unit_last_of_touch", "map"}));
  EXPECT_EQ(setting_of(system.modules.back(), "rows"), Value{std::int64_t{15}});
}

TEST(SuggestedSystem, SeveralPartsAreScaledAndConcatenated) {
  const Recording recording = testing::made_senses(2, 2, {{"touch", {0, 1}}, {"joints", {0, 1}}});
  const std::vector<CandidateGroup> groups{group_of("touch", recording, 0),
                                           group_of("joints", recording, 1)};
  Suggestion suggestion;
  suggestion.explorations = 1000;  // 31 x 32 and eight more
  suggestion.parts = {{1, 0, 1.0, 0.123456, 0.1}, {0, 0, 2.0, 0.5, 0.1}};
  const auto system = system_of(suggestion, groups);
  EXPECT_EQ(names_of(system),
            (Names{"joints", "last_of_joints", "unit_last_of_joints", "part_of_unit_last_of_joints",
                   "touch", "last_of_touch", "unit_last_of_touch", "part_of_unit_last_of_touch",
                   "vector", "map"}));
  EXPECT_EQ(setting_of(system.modules[3], "factor"), Value{0.1234});
  EXPECT_EQ(setting_of(system.modules.back(), "rows"), Value{std::int64_t{31}});
  EXPECT_EQ(setting_of(system.modules.back(), "columns"), Value{std::int64_t{32}});
  EXPECT_EQ(setting_of(system.modules.back(), "training"), Value{std::string("batch")});
  EXPECT_EQ(setting_of(system.modules.back(), "radius_start"), Value{4.0});  // 32 / 8
}

TEST(SuggestedSystem, APartWithTheFactorOneIsNotScaled) {
  const Recording recording = testing::made_senses(2, 2, {{"touch", {0, 1}}, {"joints", {0, 1}}});
  const std::vector<CandidateGroup> groups{group_of("touch", recording, 0),
                                           group_of("joints", recording, 1)};
  Suggestion suggestion;
  suggestion.explorations = 4;
  suggestion.parts = {{0, 0, 1.0, 1.0, 0.1}, {1, 0, 1.0, 1.0, 0.1}};
  suggestion.similarity = Similarity::kManhattan;
  const auto system = system_of(suggestion, groups);
  EXPECT_EQ(names_of(system), (Names{"touch", "last_of_touch", "unit_last_of_touch", "joints",
                                     "last_of_joints", "unit_last_of_joints", "vector", "map"}));
  EXPECT_EQ(setting_of(system.modules.back(), "similarity"), Value{std::string("manhattan")});
}

TEST(SuggestedSystem, TheMapHasAtMostAsManyNeuronsAsExplorations) {
  for (const std::size_t explorations : {2U, 7U, 30U, 31U, 100U, 511U, 2133U}) {
    const auto [rows, columns] = sides_of_map(explorations, 1, 1.0);
    EXPECT_LE(rows * columns, explorations);
    EXPECT_GT((rows + 1) * (columns + 1), explorations);
    EXPECT_LE(columns, rows + 2);
  }
  using Sides = std::pair<std::size_t, std::size_t>;
  EXPECT_EQ(sides_of_map(100, 1, 0.25), Sides(5, 5));
  EXPECT_EQ(sides_of_map(100, 15, 1.0), Sides(15, 15));   // the least
  EXPECT_EQ(sides_of_map(10000, 1, 1.0), Sides(70, 71));  // 50 x 100 neurons
}

}  // namespace
}  // namespace somato
