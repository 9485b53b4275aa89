#include "bodies/probes/probe_poses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bodies/objects/exploration_source.h"
#include "bodies/objects/material_colour.h"
#include "somato/simulation/simulated_explorer.h"

namespace somato {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

Exploration explored(ExploringBody body, std::size_t thing = 0) {
  const auto things = default_things(body).value();
  return simulated_explorer(body, things, {}, 3).value()->explore(thing, 0).value();
}

double lever_degrees(const ScenePose& pose) {
  return 2.0 * std::atan2(pose.turn[3], pose.turn[0]) / kDegree + 18.0;
}

// Twice as large as it is; the tip is a millimetre above the material at 0.
double stick_millimetres(const ScenePose& pose) {
  return 1.0 - pose.position[2] / 0.002;
}

std::array<double, 4> slab_colour(const Scene& scene) {
  for (const SceneGeom& geom : scene.geoms) {
    if (geom.role == GeomRole::kObject) return geom.colour;
  }
  return {};
}

// The poses of a body at each reading, with the frames until then.
struct Looking {
  Scene scene;
  std::vector<std::pair<std::size_t, std::vector<ScenePose>>> felt_poses;
};

Exploration look(ExploringBody body, Looking& seen) {
  std::size_t frames = 0;
  ExploreOptions options;
  options.observer.on_begin = [&](const BodyDescription&, const Scene& scene) -> Result<void> {
    seen.scene = scene;
    return {};
  };
  options.observer.on_step = [&](const ExplorationStep& step) -> Result<void> {
    if (step.readings == Readings::kLeftOut) return {};
    frames += step.state.readings.front().rows();
    seen.felt_poses.emplace_back(frames, step.poses);
    return {};
  };
  const auto explorer = simulated_explorer(body, default_things(body).value(), {}, 3).value();
  return explorer->explore(2, 0, options).value();
}

TEST(ProbePoses, TurnTheLeverAsItTurned) {
  Looking seen;
  const Exploration recorded = look(ExploringBody::kTexture, seen);
  const auto player = play_probes(recorded);
  ASSERT_TRUE(player);
  EXPECT_EQ(player->scene().bodies, seen.scene.bodies);
  ASSERT_EQ(seen.felt_poses.size(), 10U);
  for (const auto& [frames, poses] : seen.felt_poses) {
    const auto played = player->poses(recorded, frames - 1);
    ASSERT_EQ(played.size(), 1U);
    EXPECT_NEAR(lever_degrees(played[0]), lever_degrees(poses[0]), 0.01);  // two frames of sound
    EXPECT_EQ(played[0].position, poses[0].position);
  }
  EXPECT_NEAR(lever_degrees(player->poses(recorded, 8191)[0]), 36.0, 1e-9);
}

TEST(ProbePoses, PutTheStickWhereItsPotentiometerReads) {
  Looking seen;
  const Exploration recorded = look(ExploringBody::kHardness, seen);
  const double counts{recorded.channels.front().frames(0, 0)};
  const auto player = play_probes(recorded);
  ASSERT_TRUE(player);
  EXPECT_EQ(player->scene().bodies, seen.scene.bodies);
  const ScenePose pose = player->poses(recorded, 0).at(0);
  EXPECT_NEAR(stick_millimetres(pose), 10.0 * counts / 262143.0, 1e-9);
  EXPECT_GT(stick_millimetres(pose), 1.0);
  EXPECT_EQ(pose.position, seen.felt_poses.back().second.at(0).position);
}

// The only reading of the potentiometer lasts as long as the sound.
TEST(ProbePoses, ShowBothProbesBesideEachOther) {
  const Exploration recorded = explored(ExploringBody::kProbes);
  const auto player = play_probes(recorded);
  ASSERT_TRUE(player);
  EXPECT_EQ(player->scene().bodies, (std::vector<std::string>{"lever", "stick"}));
  const double counts{recorded.channels.back().frames(0, 0)};
  for (const std::size_t frame : {0U, 4095U, 8191U, 9000U}) {
    const auto poses = player->poses(recorded, frame);
    ASSERT_EQ(poses.size(), 2U);
    const double seen = std::min(static_cast<double>(frame + 1), 8192.0);
    EXPECT_NEAR(lever_degrees(poses[0]), 36.0 * seen / 8192.0, 1e-9);
    EXPECT_NEAR(stick_millimetres(poses[1]), 10.0 * counts / 262143.0, 1e-9);
    EXPECT_NE(poses[0].position, poses[1].position);
  }
}

TEST(ProbePoses, ShowTheMaterialInItsColour) {
  Exploration recorded = explored(ExploringBody::kHardness, 7);
  const auto colour = material_colour("sponge").value();
  const std::array<double, 4> grey{0.6, 0.6, 0.6, 1.0};
  const std::array<double, 4> sponge{colour[0], colour[1], colour[2], 1.0};
  EXPECT_EQ(slab_colour(play_probes(recorded)->scene()), sponge);
  Exploration other = recorded;
  other.source = device_source("my probe");
  EXPECT_EQ(slab_colour(play_probes(other)->scene()), grey);
  recorded.labels.front().value = "cork";
  EXPECT_EQ(slab_colour(play_probes(recorded)->scene()), grey);
  recorded.labels.clear();
  EXPECT_EQ(slab_colour(play_probes(recorded)->scene()), grey);
}

Exploration with_channel(const char* name, const char* unit, Matrix<float> frames, double rate) {
  Channel channel;
  channel.name = name;
  channel.unit = unit;
  channel.frames = std::move(frames);
  channel.rate = rate;
  return {{}, {}, {std::move(channel)}};
}

// A stroke of another length, or a reading that no potentiometer of these bits gives.
TEST(ProbePoses, RestIfThePoseIsUnknown) {
  const Exploration shorter = with_channel("sound", "counts", Matrix<float>(4096, 1), 8192.0);
  const auto lever = play_probes(shorter);
  ASSERT_TRUE(lever);
  for (const std::size_t frame : {0U, 4095U, 9000U}) {
    EXPECT_NEAR(lever_degrees(lever->poses(shorter, frame).at(0)), 0.0, 1e-9);
  }
  for (const float counts : {-1.0F, 262144.0F, INFINITY, NAN}) {
    const Exploration beyond =
        with_channel("potentiometer", "counts", Matrix<float>(1, 1, counts), 0.0);
    const auto stick = play_probes(beyond);
    ASSERT_TRUE(stick);
    EXPECT_NEAR(stick_millimetres(stick->poses(beyond, 0).at(0)), 0.0, 1e-9);
    EXPECT_NEAR(stick_millimetres(stick->poses({}, 0).at(0)), 0.0, 1e-9);
  }
}

TEST(ProbePoses, AreNotThoseOfOthers) {
  for (const Exploration& other :
       {Exploration{}, with_channel("sound", "counts", Matrix<float>(8192, 2), 8192.0),
        with_channel("sound", "counts", Matrix<float>(0, 1), 8192.0),
        with_channel("sound", "counts", Matrix<float>(44100, 1), 44100.0),
        with_channel("sound", "counts", Matrix<float>(8192, 1), 0.0),
        with_channel("sound", "", Matrix<float>(8192, 1), 8192.0),
        with_channel("potentiometer", "counts", Matrix<float>(1, 5), 0.0),
        with_channel("potentiometer", "deg", Matrix<float>(1, 1), 0.0),
        with_channel("potentiometer", "counts", Matrix<float>(0, 1), 0.0)}) {
    EXPECT_FALSE(play_probes(other));
  }
}

}  // namespace
}  // namespace somato
