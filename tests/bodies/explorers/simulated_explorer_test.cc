#include "somato/simulation/simulated_explorer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "bodies/support/things.h"
#include "somato/bodies/exploring.h"
#include "somato/core/check.h"

namespace somato {
namespace {

Object named(std::string name, Object object) {
  object.name = std::move(name);
  object.material = declared_materials().front();
  return object;
}

ObjectTable two_objects() {
  return {{named("tube", cylinder_thing()), named("brick", block_thing())}, {}};
}

// Two grasps instead of nine.
ExploringParameters short_plan() {
  ExploringParameters parameters;
  parameters.plan.grasps = 2;
  return parameters;
}

std::unique_ptr<SimulatedExplorer> built(ExploringBody body, const ObjectTable& things,
                                         const ExploringParameters& parameters = short_plan(),
                                         std::uint64_t seed = 1) {
  auto explorer = simulated_explorer(body, things, parameters, seed);
  EXPECT_TRUE(explorer) << to_string(explorer.error());
  return std::move(*explorer);
}

std::vector<std::string> names_of(const SimulatedExplorer& explorer) {
  std::vector<std::string> names;
  for (const ExploredThing& thing : explorer.things()) names.push_back(thing.name);
  return names;
}

Exploration explored(const SimulatedExplorer& explorer, std::size_t thing, std::size_t trial) {
  auto exploration = explorer.explore(thing, trial);
  EXPECT_TRUE(exploration) << to_string(exploration.error());
  Recording single;
  single.explorations.push_back(*exploration);
  EXPECT_TRUE(validate(single));
  return *exploration;
}

std::map<std::string, std::size_t> widths(const Exploration& exploration) {
  std::map<std::string, std::size_t> widths;
  for (const Channel& channel : exploration.channels)
    widths[channel.name] = channel.frames.columns();
  return widths;
}

std::string label(const Exploration& exploration, const std::string& name) {
  const auto found = find_label(exploration, name);
  EXPECT_TRUE(found);
  return *found;
}

double sum_of(const Exploration& exploration, const std::string& channel) {
  double sum = 0.0;
  const Matrix<float>& frames = (*find_channel(exploration, channel))->frames;
  for (std::size_t row = 0; row < frames.rows(); ++row)
    sum = std::accumulate(frames.row(row).begin(), frames.row(row).end(), sum);
  return sum;
}

TEST(SimulatedExplorer, EveryBodyHasTheThingsOfItsOwnTable) {
  const auto names = [](ExploringBody body) {
    const auto things = default_things(body);
    EXPECT_TRUE(things);
    return names_of(*built(body, *things));
  };
  EXPECT_EQ(names(ExploringBody::kLucs2),
            (std::vector<std::string>{"boccia", "boule", "cylinder", "metal_cylinder", "block_1",
                                      "block_2"}));
  EXPECT_EQ(names(ExploringBody::kLucs3).size(), 10U);
  EXPECT_EQ(names(ExploringBody::kAllSenses).size(), 10U);
  EXPECT_EQ(names(ExploringBody::kTexture).size(), 8U);
  EXPECT_EQ(names(ExploringBody::kHardness), names(ExploringBody::kTexture));
  EXPECT_EQ(names(ExploringBody::kProbes), names(ExploringBody::kTexture));
}

std::string effect_error(ExploringBody body, const std::string& parameter) {
  const auto checked = check_effect(body, {"", {{parameter, "--flag", Value{true}}}});
  return checked ? "none" : to_string(checked.error());
}

TEST(SimulatedExplorer, ParametersWithoutEffectAreRefused) {
  EXPECT_EQ(effect_error(ExploringBody::kLucs3, "taxels"), "none");
  EXPECT_EQ(effect_error(ExploringBody::kAllSenses, "taxels"), "none");
  EXPECT_EQ(effect_error(ExploringBody::kLucs2, "placement_noise"), "none");
  EXPECT_EQ(effect_error(ExploringBody::kLucs2, "taxels"),
            "--flag: has no effect on the body lucs2; omit it");
  for (const auto& [body, name] : Choices<ExploringBody>::all()) {
    EXPECT_EQ(effect_error(body, "placement_noise") == "none", !is_probe(body)) << name;
  }
}

TEST(SimulatedExplorer, HandTwoFeelsWithThePapersChannels) {
  const Exploration exploration = explored(*built(ExploringBody::kLucs2, two_objects()), 1, 2);
  EXPECT_EQ(widths(exploration),
            (std::map<std::string, std::size_t>{
                {"height", 1}, {"wrist", 1}, {"joints", 6}, {"touch", 45}, {"touch_change", 45}}));
  EXPECT_EQ(label(exploration, "object"), "brick");
  EXPECT_EQ(label(exploration, "shape"), "block");
  EXPECT_EQ(label(exploration, "trial"), "3");
  EXPECT_GT(sum_of(exploration, "touch"), 10.0);
}

TEST(SimulatedExplorer, HandTwoGraspsAtThePlansHeightsAndAngles) {
  ExploringParameters parameters;
  parameters.plan.grasps = 9;
  const Exploration exploration =
      explored(*built(ExploringBody::kLucs2, two_objects(), parameters), 0, 0);
  std::vector<std::pair<float, float>> poses;
  const Matrix<float>& height = (*find_channel(exploration, "height"))->frames;
  const Matrix<float>& wrist = (*find_channel(exploration, "wrist"))->frames;
  for (std::size_t frame = 0; frame < height.rows(); ++frame) {
    const std::pair pose(height.row(frame)[0], wrist.row(frame)[0]);
    if (poses.empty() || poses.back() != pose) poses.push_back(pose);
  }
  EXPECT_EQ(poses.size(), 9U);
  std::set<float> heights;
  std::set<float> angles;
  for (const auto& [at, turned] : poses) {
    heights.insert(at);
    angles.insert(turned);
  }
  EXPECT_EQ(heights.size(), 2U);
  EXPECT_EQ(angles.size(), 5U);
}

TEST(SimulatedExplorer, HandThreeReadsElevenPotentiometersAndTaxelsIfItHasThem) {
  ExploringParameters parameters;
  const Exploration plain =
      explored(*built(ExploringBody::kLucs3, two_objects(), parameters), 0, 0);
  EXPECT_EQ(widths(plain), (std::map<std::string, std::size_t>{{"joints", 11}}));
  parameters.simulation.taxels = true;
  const Exploration feeling =
      explored(*built(ExploringBody::kLucs3, two_objects(), parameters), 0, 0);
  EXPECT_EQ(widths(feeling).at("joints"), 11U);
  EXPECT_GT(widths(feeling).at("touch"), 11U);
  EXPECT_GT(sum_of(feeling, "touch"), 10.0);
}

TEST(SimulatedExplorer, ProbesTryMaterialsOrThoseOfObjects) {
  const auto strokes = built(ExploringBody::kTexture, two_objects());
  EXPECT_EQ(names_of(*strokes), (std::vector<std::string>{declared_materials().front().name}));
  const Exploration sound = explored(*strokes, 0, 0);
  EXPECT_EQ(sound.channels.front().name, "sound");
  EXPECT_EQ(sound.channels.front().frames.rows(), 8192U);
  EXPECT_EQ(label(sound, "material"), strokes->things().front().name);
  const ObjectTable own{two_objects().objects, {declared_materials()[2], declared_materials()[5]}};
  const auto presses = built(ExploringBody::kHardness, own);
  EXPECT_EQ(presses->things().size(), 2U);
  const Exploration pressed = explored(*presses, 1, 0);
  EXPECT_EQ(pressed.channels.front().name, "potentiometer");
  EXPECT_EQ(pressed.channels.front().frames.rows(), 1U);
  EXPECT_EQ(label(pressed, "hardness"), choice_name(declared_materials()[5].hardness));
}

// An exploration by both probes equals the two explorations by the single probes.
TEST(SimulatedExplorer, ProbesTogetherFeelWhatEachFeels) {
  const ObjectTable own{{}, {declared_materials()[2], declared_materials()[5]}};
  const Exploration both = explored(*built(ExploringBody::kProbes, own), 1, 3);
  const Exploration sound = explored(*built(ExploringBody::kTexture, own), 1, 3);
  const Exploration pressed = explored(*built(ExploringBody::kHardness, own), 1, 3);
  ASSERT_EQ(both.channels.size(), 2U);
  EXPECT_EQ(both.channels[0], sound.channels.at(0));
  EXPECT_EQ(both.channels[1], pressed.channels.at(0));
  EXPECT_EQ(both.labels, sound.labels);
  EXPECT_EQ(both.labels, pressed.labels);
}

TEST(SimulatedExplorer, AllSensesTellOfOneThing) {
  const Exploration exploration = explored(*built(ExploringBody::kAllSenses, two_objects()), 1, 0);
  const auto found = widths(exploration);
  for (const char* name : {"joints", "touch", "touch_change", "sound", "potentiometer"})
    EXPECT_TRUE(found.contains(name)) << name;
  EXPECT_EQ(label(exploration, "object"), "brick");
  EXPECT_EQ(label(exploration, "material"), declared_materials().front().name);
}

TEST(SimulatedExplorer, AnExplorationDependsOnlyOnItsSeedThingAndTrial) {
  const auto explorer = built(ExploringBody::kLucs2, two_objects());
  const Exploration first = explored(*explorer, 0, 0);
  const Exploration other_trial = explored(*explorer, 0, 1);
  EXPECT_EQ(explored(*explorer, 0, 0).channels, first.channels);
  EXPECT_NE(other_trial.channels, first.channels);
  EXPECT_NE(explored(*built(ExploringBody::kLucs2, two_objects(), short_plan(), 2), 0, 0).channels,
            first.channels);
}

TEST(SimulatedExplorer, ThreadsGiveTheSameRecording) {
  const auto explorer = built(ExploringBody::kLucs2, two_objects());
  const auto recorded = [&](std::size_t threads) {
    std::vector<Exploration> explorations;
    const auto outcome =
        explore_all(*explorer, {2}, threads, {}, [&](Exploration&& exploration) -> Result<void> {
          explorations.push_back(std::move(exploration));
          return {};
        });
    EXPECT_TRUE(outcome);
    return explorations;
  };
  const auto single = recorded(1);
  EXPECT_EQ(single.size(), 4U);
  EXPECT_EQ(recorded(2), single);
  EXPECT_EQ(recorded(4), single);
}

TEST(SimulatedExplorer, HalvingTheTimeStepHardlyChangesWhatIsFelt) {
  std::vector<double> changes;
  for (const bool free : {false, true}) {
    ExploringParameters parameters = short_plan();
    parameters.simulation.free = free;
    parameters.simulation.sensor_noise = 0.0;
    const auto things = default_things(ExploringBody::kLucs2);
    const auto coarse = built(ExploringBody::kLucs2, *things, parameters);
    parameters.simulation.time_step /= 2;
    const auto fine = built(ExploringBody::kLucs2, *things, parameters);
    for (std::size_t thing = 0; thing < coarse->things().size(); ++thing) {
      const double felt = sum_of(explored(*coarse, thing, 0), "touch");
      changes.push_back(std::abs(sum_of(explored(*fine, thing, 0), "touch") / felt - 1.0));
    }
  }
  std::sort(changes.begin(), changes.end());
  EXPECT_LT(changes[changes.size() / 2], 0.03);
}

TEST(SimulatedExplorer, WhatDoesNotFitIsRefusedBeforeAnythingMoves) {
  const auto refusal = [](ExploringBody body, const Object& object) {
    const auto refused = simulated_explorer(body, {{named("misfit", object)}, {}}, {}, 1);
    EXPECT_FALSE(refused);
    return refused ? std::string() : to_string(refused.error());
  };
  // Clears the lifted hand, but not the palm at the lower of the plan's heights.
  EXPECT_NE(refusal(ExploringBody::kLucs2, thing(Shape::kCylinder, 60, 60, 150)).find("misfit"),
            std::string::npos);
  EXPECT_NE(refusal(ExploringBody::kLucs2, thing(Shape::kBlock, 200, 50, 50)).find("misfit"),
            std::string::npos);
  EXPECT_NE(refusal(ExploringBody::kLucs3, thing(Shape::kBlock, 90, 500, 130)).find("misfit"),
            std::string::npos);
}

TEST(SimulatedExplorer, APlanBeyondTheHandsLimitsIsRefusedBeforeAnythingMoves) {
  ExploringParameters parameters;
  parameters.plan.heights = {126.0, 300.0};
  const auto refused = simulated_explorer(ExploringBody::kLucs2, two_objects(), parameters, 1);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().where, "height");
}

TEST(SimulatedExplorer, AThingTooSmallToBeFeltIsNoExploration) {
  const auto explorer =
      built(ExploringBody::kLucs2, {{named("pea", thing(Shape::kSphere, 8, 8, 8))}, {}});
  const auto exploration = explorer->explore(0, 0);
  ASSERT_FALSE(exploration);
  EXPECT_EQ(exploration.error().kind, ErrorKind::kData);
  EXPECT_NE(to_string(exploration.error()).find("never touched"), std::string::npos);
  EXPECT_NE(to_string(exploration.error()).find("pea"), std::string::npos);
}

TEST(SimulatedExplorer, TablesWithoutThingsAreRefused) {
  for (const auto& [body, name] : Choices<ExploringBody>::all()) {
    const auto refused = simulated_explorer(body, {}, {}, 1);
    ASSERT_FALSE(refused) << name;
    EXPECT_EQ(refused.error().kind, ErrorKind::kUsage) << name;
  }
  EXPECT_THROW((void)built(ExploringBody::kLucs2, two_objects())->explore(2, 0), InvalidArgument);
}

// Counts what it observes.
struct Counting {
  Scene scene;
  std::size_t bodies = 0;
  std::size_t steps = 0;
  std::size_t recorded = 0;
  std::size_t most_steps = 1000000;

  ExplorationObserver observer() {
    return {[this](const BodyDescription&, const Scene& seen) -> Result<void> {
              scene = seen;
              ++bodies;
              return {};
            },
            [this](const ExplorationStep& step) -> Result<void> {
              EXPECT_EQ(step.poses.size(), scene.bodies.size());
              if (step.readings == Readings::kRecorded) ++recorded;
              if (++steps < most_steps) return {};
              return fail(ErrorKind::kInterrupted, "enough");
            }};
  }
};

TEST(SimulatedExplorer, FeelsTheSameWhileItIsObserved) {
  for (const auto body : {ExploringBody::kLucs2, ExploringBody::kLucs3, ExploringBody::kTexture,
                          ExploringBody::kHardness}) {
    SCOPED_TRACE(choice_name(body));
    const auto explorer = built(body, default_things(body).value());
    Counting counting;
    const auto seen = explorer->explore(1, 2, {.observer = counting.observer()}).value();
    EXPECT_EQ(seen, explored(*explorer, 1, 2));
    EXPECT_EQ(counting.bodies, 1U);
    EXPECT_FALSE(counting.scene.geoms.empty());
    EXPECT_GT(counting.recorded, 0U);
    // A probe that presses records every reading, of which the last is kept.
    EXPECT_EQ(counting.steps > counting.recorded, body != ExploringBody::kHardness);
  }
}

TEST(SimulatedExplorer, ShowsEachBodyOfSeveral) {
  Counting counting;
  const auto explorer =
      built(ExploringBody::kProbes, default_things(ExploringBody::kProbes).value());
  ASSERT_TRUE(explorer->explore(0, 0, {.observer = counting.observer()}));
  EXPECT_EQ(counting.bodies, 2U);
  EXPECT_EQ(counting.scene.bodies, (std::vector<std::string>{"stick"}));
}

TEST(SimulatedExplorer, EndsWithTheErrorOfItsObserver) {
  const auto explorer = built(ExploringBody::kLucs3, two_objects());
  Counting counting;
  counting.most_steps = 2;
  const auto ended = explorer->explore(0, 0, {.observer = counting.observer()});
  ASSERT_FALSE(ended);
  EXPECT_EQ(ended.error().kind, ErrorKind::kInterrupted);
  EXPECT_EQ(counting.steps, 2U);
}

TEST(SimulatedExplorer, TakesThePlacement) {
  const auto explorer = built(ExploringBody::kLucs3, two_objects());
  const auto placed = [&](const Placement& placement) {
    return explorer->explore(1, 0, {.placement = placement}).value();
  };
  EXPECT_NE(placed({}).channels, placed({4.0, 3.0, 5.0}).channels);
  ExploringParameters steady = short_plan();
  steady.simulation.placement_noise = 0.0;
  EXPECT_EQ(placed({}), explored(*built(ExploringBody::kLucs3, two_objects(), steady), 1, 0));
}

}  // namespace
}  // namespace somato
