#include "somato/simulation/watched_explorer.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

class Counting : public ExplorationWatcher {
 public:
  void begins(const BodyDescription& /*body*/, const Scene& seen) override { scene = seen; }
  Result<void> moved(const BodyState& /*state*/, const std::vector<ScenePose>& poses) override {
    EXPECT_EQ(poses.size(), scene.bodies.size());
    ++steps;
    if (stop_after > 0 && steps == stop_after) return fail(ErrorKind::kInterrupted, "enough");
    return {};
  }
  Result<void> felt(const BodyState& /*state*/) override {
    ++frames;
    return {};
  }

  Scene scene;
  std::size_t steps = 0;
  std::size_t frames = 0;
  std::size_t stop_after = 0;
};

// Few grasps, and none off its place: a placement is the caller's here.
ExploringParameters short_exploring() {
  ExploringParameters parameters;
  parameters.simulation.placement_noise = 0.0;
  parameters.plan.grasps = 1;
  return parameters;
}

void expect_same_as_explorer(ExploringBody body) {
  const auto things = default_things(body).value();
  const auto explorer = Explorer::build(body, things, short_exploring(), 3).value();
  const auto watched = watch_body(body, things, short_exploring(), 3).value();
  ASSERT_EQ(watched->things().size(), explorer.things().size());
  EXPECT_EQ(watched->things()[1].name, explorer.things()[1]);
  Counting watcher;
  const auto seen = watched->explore({1, 2, {}}, watcher).value();
  const auto alone = explorer.explore(1, 2).value();
  EXPECT_EQ(seen.channels, alone.channels);
  EXPECT_EQ(seen.labels, alone.labels);
  EXPECT_FALSE(watcher.scene.geoms.empty());
  EXPECT_GT(watcher.steps, watcher.frames);
  EXPECT_GT(watcher.frames, 0U);
}

TEST(WatchedExplorer, FeelsWhatItFeelsUnwatched) {
  for (const auto body : {ExploringBody::kLucs2, ExploringBody::kLucs3, ExploringBody::kTexture}) {
    expect_same_as_explorer(body);
  }
}

// Each reading of the hardness probe is felt; the last one is recorded.
TEST(WatchedExplorer, PressesAsItDoesUnwatched) {
  const auto things = default_things(ExploringBody::kHardness).value();
  const auto explorer = Explorer::build(ExploringBody::kHardness, things, {}, 3).value();
  const auto watched = watch_body(ExploringBody::kHardness, things, {}, 3).value();
  Counting watcher;
  EXPECT_EQ(watched->explore({2, 0, {}}, watcher).value().channels,
            explorer.explore(2, 0).value().channels);
  EXPECT_EQ(watcher.steps, watcher.frames);
}

TEST(WatchedExplorer, EndsWhenTheWatcherHasEnough) {
  const auto things = default_things(ExploringBody::kLucs3).value();
  const auto watched = watch_body(ExploringBody::kLucs3, things, short_exploring(), 3).value();
  Counting watcher;
  watcher.stop_after = 2;
  const auto explored = watched->explore({0, 0, {}}, watcher);
  ASSERT_FALSE(explored);
  EXPECT_EQ(explored.error().kind, ErrorKind::kInterrupted);
  EXPECT_EQ(watcher.steps, 2U);
}

TEST(WatchedExplorer, TakesThePlacement) {
  const auto things = default_things(ExploringBody::kLucs3).value();
  const auto watched = watch_body(ExploringBody::kLucs3, things, short_exploring(), 3).value();
  EXPECT_TRUE(watched->takes_placement());
  Counting watcher;
  const auto here = watched->explore({3, 0, {}}, watcher).value();
  const auto there = watched->explore({3, 0, {4.0, 3.0, 5.0}}, watcher).value();
  EXPECT_NE(here.channels, there.channels);
}

TEST(WatchedExplorer, IsOneBody) {
  const auto things = default_things(ExploringBody::kProbes).value();
  EXPECT_EQ(watch_body(ExploringBody::kProbes, things, {}, 1).error().kind, ErrorKind::kUsage);
}

}  // namespace
}  // namespace somato
