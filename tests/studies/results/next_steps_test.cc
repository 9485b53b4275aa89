#include "studies/results/next_steps.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace somato {
namespace {

// 12 samples of each of two classes, of which the first `wrong` are confused.
PartResults part(double accuracy, double baseline, std::size_t wrong = 0) {
  ProtocolResults protocol{"k_folds", "", "object", 24, {}, {}};
  protocol.metrics = {{"accuracy", {accuracy}, {}}, {"baseline_accuracy", {baseline}, {}}};
  Run run;
  for (std::size_t i = 0; i < 24; ++i) {
    run.winners.push_back(run.winners.size());
    run.labels.emplace_back(i < 12 ? "cup" : "ball");
    run.predictions.push_back(i < wrong ? "ball" : run.labels.back());
  }
  protocol.runs = {run};
  PartResults results;
  results.system = "mine";
  results.recordings = {{"grasps.mcap", "given", 0, "hash", 24}};
  results.protocols = {protocol};
  return results;
}

const NextStep* step_with(const std::vector<NextStep>& steps, const std::string& words) {
  const auto found = std::find_if(steps.begin(), steps.end(), [&](const NextStep& step) {
    return step.text.find(words) != std::string::npos;
  });
  return found == steps.end() ? nullptr : &*found;
}

TEST(NextSteps, BeginWithAMapThatCollapsed) {
  PartResults collapsed = part(0.8, 0.82);
  for (std::size_t& winner : collapsed.protocols[0].runs[0].winners) winner = 0;
  EXPECT_NE(next_steps(collapsed, {}).front().text.find("fewer winners (1) than there are classes"),
            std::string::npos);
}

TEST(NextSteps, FollowFromTheBaseline) {
  const auto good = next_steps(part(0.97, 0.98), {});
  EXPECT_FALSE(step_with(good, "below the nearest neighbour"));
  EXPECT_FALSE(step_with(good, "The nearest neighbour does not"));
  const auto below = next_steps(part(0.8, 0.95), {});
  ASSERT_TRUE(step_with(below, "15 points below the nearest neighbour"));
  EXPECT_EQ(step_with(below, "15 points")->page, "docs/below-the-baseline.md");
  const auto poor = next_steps(part(0.8, 0.82), {});
  ASSERT_TRUE(step_with(poor, "The nearest neighbour does not"));
  EXPECT_EQ(poor[0].commands.at(0), "somato suggest grasps.mcap -o suggested.toml");
}

TEST(NextSteps, FollowFromChance) {
  EXPECT_TRUE(step_with(next_steps(part(0.52, 0.55), {}), "hardly above chance"));
  EXPECT_FALSE(step_with(next_steps(part(0.7, 0.72), {}), "hardly above chance"));
  EXPECT_FALSE(step_with(next_steps(part(0.52, 0.95), {}), "hardly above chance"))
      << "the vectors are good";
}

TEST(NextSteps, DoNotSuggestWhatWasSuggested) {
  PartResults suggested = part(0.8, 0.82);
  suggested.system = "suggested";
  EXPECT_TRUE(next_steps(suggested, {})[0].commands.empty());
}

TEST(NextSteps, NameTheFilesAsAShellReadsThem) {
  PartResults own = part(0.8, 0.82, 3);
  own.protocols[0].label = "kind of thing";
  const auto steps = next_steps(own, {"my data/it's.mcap", "out/system.somato"});
  EXPECT_EQ(steps[0].commands.at(0),
            "somato suggest 'my data/it'\\''s.mcap' --label 'kind of thing' -o suggested.toml");
  ASSERT_TRUE(step_with(steps, "'cup' and 'ball'"));
  EXPECT_EQ(step_with(steps, "'cup' and 'ball'")->commands.at(0),
            "somato view 'my data/it'\\''s.mcap' --model out/system.somato");
  ASSERT_TRUE(step_with(steps, "Classify new"));
  EXPECT_FALSE(step_with(next_steps(own, {"data", ""}), "Classify new"));
}

TEST(NextSteps, ReadATableAsItsStudyDid) {
  PartResults table = part(0.8, 0.82);
  table.recordings[0].name = "t.csv";
  table.study =
      "[study]\nname = 's'\n[recording]\nlabel_column = 'the kind'\nskip = ['date', 'note']\n"
      "missing = 'mask'\nheader = false\n";
  EXPECT_EQ(next_steps(table, {})[0].commands.at(0),
            "somato suggest t.csv --label-column 'the kind' --skip date,note --missing mean "
            "--header no -o suggested.toml");
}

TEST(NextSteps, CountFewSamples) {
  EXPECT_FALSE(step_with(next_steps(part(0.97, 0.98), {}), "There are only"));
  PartResults few = part(0.97, 0.98);
  for (std::size_t i = 3; i < 12; ++i) few.protocols[0].runs[0].labels[i] = "ball";
  EXPECT_TRUE(step_with(next_steps(few, {}), "There are only 3 samples of 'cup'"));
}

TEST(NextSteps, AreForGivenRecordings) {
  PartResults simulated = part(0.8, 0.82);
  simulated.recordings[0].source = "lucs2, simulated (engine), seed 1";
  EXPECT_TRUE(next_steps(simulated, {}).empty());
  EXPECT_TRUE(next_steps({}, {}).empty());
}

}  // namespace
}  // namespace somato
