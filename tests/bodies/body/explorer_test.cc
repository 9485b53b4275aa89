#include "somato/bodies/explorer.h"

#include <gtest/gtest.h>

#include "bodies/support/fake_hand.h"
#include "somato/core/check.h"

namespace somato {
namespace {

// Two steps of a hand, of which the second is recorded; the second thing slips.
class TwoSteps : public Explorer {
 public:
  TwoSteps() : Explorer({{"ball", {}, {}}, {"soap", {}, {}}}, "a table") {}

 protected:
  Result<Exploration> explore_thing(std::size_t thing, std::size_t trial,
                                    const ExploreOptions& options) override {
    if (thing == 1) return fail(ErrorKind::kData, "it slipped away");
    FakeHand hand("hand");
    Scene scene;
    scene.bodies = {"finger"};
    ScenePose pose;
    auto moved = prepare_body(
                     hand, options, [&] { return scene; },
                     [&] {
                       pose.position[0] = hand.state().time;
                       return std::vector<ScenePose>{pose};
                     })
                     .and_then([&] { return hand.step(1.0); })
                     .and_then([&] { return hand.step(0.5, Readings::kRecorded); });
    if (!moved) return fail(std::move(moved.error()));
    return Exploration{{{"trial", std::to_string(trial + 1)}}, "", {}};
  }
};

TEST(Explorer, NamesItsSourceAndTheThingThatFailed) {
  TwoSteps explorer;
  const auto explored = explorer.explore(0, 4).value();
  EXPECT_EQ(explored.source, "a table");
  EXPECT_EQ(explored.labels[0].value, "5");
  EXPECT_EQ(explorer.explore(1, 0).error().where, "soap");
  EXPECT_THROW((void)explorer.explore(2, 0), InvalidArgument);
}

TEST(Explorer, LabelsAThingOfWhichOnlyTheNameIsKnown) {
  EXPECT_EQ(TwoSteps().labels(1, 2), (std::vector<Label>{{"object", "soap"}, {"trial", "3"}}));
}

// A class that says nothing else is a real body.
TEST(Explorer, MovesARealBodyUnlessItsTypeIsSimulated) {
  class Simulated : public SimulatedExplorer {
   public:
    Simulated() : SimulatedExplorer({{"ball", {}, {}}}, "a simulation") {}

   protected:
    Result<Exploration> simulate(std::size_t, std::size_t trial,
                                 const ExploreOptions&) const override {
      if (trial == 1) return fail(ErrorKind::kData, "it fell");
      return Exploration{};
    }
  };
  EXPECT_TRUE(TwoSteps().moves_real_body());
  const Simulated constant;
  EXPECT_FALSE(constant.moves_real_body());
  EXPECT_EQ(constant.explore(0, 0).value().source, "a simulation");
  EXPECT_EQ(constant.explore(0, 1).error().where, "ball");
  EXPECT_THROW((void)constant.explore(1, 0), InvalidArgument);
  Simulated simulated;
  Explorer& any = simulated;
  EXPECT_EQ(any.explore(0, 0).value().source, "a simulation");
}

TEST(Explorer, ShowsItsObserverTheSceneAndEachStep) {
  std::vector<std::string> bodies;
  std::vector<std::pair<double, Readings>> steps;
  ExploreOptions options;
  options.observer.on_begin = [&](const BodyDescription& body, const Scene& scene) -> Result<void> {
    EXPECT_EQ(body.name, "hand");
    bodies = scene.bodies;
    return {};
  };
  options.observer.on_step = [&](const ExplorationStep& step) -> Result<void> {
    EXPECT_EQ(step.poses.at(0).position[0], step.state.time);
    steps.emplace_back(step.state.time, step.readings);
    return {};
  };
  ASSERT_TRUE(TwoSteps().explore(0, 0, options));
  EXPECT_EQ(bodies, (std::vector<std::string>{"finger"}));
  EXPECT_EQ(steps, (std::vector<std::pair<double, Readings>>{{1.0, Readings::kLeftOut},
                                                             {1.5, Readings::kRecorded}}));
}

TEST(Explorer, EndsWithTheErrorOfItsObserverOrItsLimits) {
  ExploreOptions options;
  options.observer.on_begin = [](const BodyDescription&, const Scene&) -> Result<void> {
    return fail(ErrorKind::kInterrupted, "not now");
  };
  EXPECT_EQ(TwoSteps().explore(0, 0, options).error().what, "not now");
  options.observer = {};
  options.limits.longest = 1.2;
  EXPECT_EQ(TwoSteps().explore(0, 0, options).error().kind, ErrorKind::kData);
}

}  // namespace
}  // namespace somato
