#include "bodies/hands/hand_poses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bodies/body/frame_log.h"
#include "bodies/body/motion.h"
#include "bodies/support/things.h"

namespace somato {
namespace {

HandScene scene_with(Hand hand, const Object& object, bool taxels = false) {
  SimulationParameters parameters;
  parameters.taxels = taxels;
  return HandScene::build(hand, object, parameters).value();
}

std::size_t count_role(const Scene& scene, GeomRole role) {
  return static_cast<std::size_t>(
      std::count_if(scene.geoms.begin(), scene.geoms.end(),
                    [&](const SceneGeom& geom) { return geom.role == role; }));
}

std::size_t count_taxels(const Scene& scene) {
  return static_cast<std::size_t>(
      std::count_if(scene.geoms.begin(), scene.geoms.end(),
                    [](const SceneGeom& g) { return g.taxel.has_value(); }));
}

TEST(HandPoses, ShowTheHandItsTaxelsAndWhatItHolds) {
  const Scene scene = scene_of(scene_with(Hand::kLucs2, cylinder_thing()));
  EXPECT_EQ(count_taxels(scene), 45U);
  EXPECT_EQ(count_role(scene, GeomRole::kObject), 1U);
  EXPECT_EQ(count_role(scene, GeomRole::kTable), 1U);
  for (const SceneGeom& geom : scene.geoms) {
    EXPECT_LT(geom.body.value_or(0), scene.bodies.size());
    if (geom.role != GeomRole::kObject) continue;
    EXPECT_EQ(geom.shape, GeomShape::kCylinder);
    EXPECT_NEAR(geom.size[0], 0.031, 1e-9);
    EXPECT_NEAR(geom.size[1], 0.0605, 1e-9);
  }
  EXPECT_EQ(count_taxels(scene_of(scene_with(Hand::kLucs3, cylinder_thing()))), 0U);
  EXPECT_GT(count_taxels(scene_of(scene_with(Hand::kLucs3, cylinder_thing(), true))), 0U);
}

TEST(HandPoses, ShowMeshesWithTheirCorners) {
  const Scene scene = scene_of(scene_with(Hand::kLucs2, thing(Shape::kCone, 60, 60, 90)));
  const auto mesh = std::find_if(scene.geoms.begin(), scene.geoms.end(), [](const SceneGeom& geom) {
    return geom.shape == GeomShape::kMesh;
  });
  ASSERT_NE(mesh, scene.geoms.end());
  EXPECT_EQ(mesh->vertices.size() % 3, 0U);
  EXPECT_GT(mesh->faces.size(), 3U);
  for (const std::uint32_t corner : mesh->faces) EXPECT_LT(3 * corner + 2, mesh->vertices.size());
}

double farthest(const std::vector<ScenePose>& a, const std::vector<ScenePose>& b) {
  double most = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      most = std::max(most, std::abs(a[i].position[axis] - b[i].position[axis]));
    }
  }
  return most;
}

// The hand drives somewhere and rests there: what it recorded must stand as it stood.
void expect_to_stand_as_it_stood(Hand kind, const std::vector<double>& targets, double tolerance) {
  const HandScene scene = scene_with(kind, thing(Shape::kCylinder, 20, 20, 30));
  const auto hand = SimulatedHand::create(scene, {}, 1).value();
  ASSERT_TRUE(move_to(*hand, targets, {1.0, 20.0}));
  const std::vector<ScenePose> stood = poses_of(*hand);
  FrameLog log(hand->description());
  ASSERT_TRUE(log.append(hand->state()));
  const Exploration recorded{{}, {}, std::move(log).channels()};
  ASSERT_TRUE(is_of_hand(recorded, kind));
  const auto player = play_hand(scene);
  EXPECT_EQ(player->scene().bodies.size(), stood.size());
  EXPECT_LT(farthest(player->poses(recorded, 0), stood), tolerance);
}

TEST(HandPoses, StandAsTheHandStood) {
  expect_to_stand_as_it_stood(Hand::kLucs2, {160.0, 30.0, 10.0, -40.0, 20.0, -30.0, 5.0, -60.0},
                              0.004);
  // Wrist, thumb (three), then proximal and coupled of each finger.
  expect_to_stand_as_it_stood(
      Hand::kLucs3, {0.0, 10.0, 20.0, 30.0, 30.0, 40.0, 20.0, 50.0, 40.0, 30.0, 35.0, 45.0}, 0.006);
}

// A slow channel of joints beside a fast one: each frame of the fast one has a pose.
TEST(HandPoses, SpreadSlowChannelsOverTheSameTime) {
  Exploration exploration;
  Channel joints;
  joints.name = "joints";
  joints.frames = Matrix<float>(2, 11);
  for (float& angle : joints.frames.row(1)) angle = 20.0F;
  Channel sound;
  sound.name = "sound";
  sound.frames = Matrix<float>(100, 1);
  exploration.channels = {joints, sound};
  const auto player = play_hand(scene_with(Hand::kLucs3, sphere_thing()));
  const auto first = player->poses(exploration, 0);
  EXPECT_EQ(farthest(player->poses(exploration, 49), first), 0.0);
  EXPECT_GT(farthest(player->poses(exploration, 50), first), 0.0);
  EXPECT_GT(farthest(player->poses(exploration, 99), first), 0.0);
  EXPECT_THROW(player->poses(exploration, 100), InvalidArgument);
}

// A value that is missing is recorded as 0, which is a pose that the hand did not have.
TEST(HandPoses, StayWhereAMissingJointWasLastKnown) {
  Exploration exploration;
  Channel joints;
  joints.name = "joints";
  joints.frames = Matrix<float>(4, 11);
  joints.valid = Matrix<std::uint8_t>(4, 11, 1);
  const auto set = [&](std::size_t row, float angle) {
    for (float& value : joints.frames.row(row)) value = angle;
  };
  set(1, 20.0F);
  set(3, 40.0F);
  for (const std::size_t missing : {std::size_t{0}, std::size_t{2}}) joints.valid(missing, 4) = 0;
  exploration.channels = {joints};
  exploration.channels[0].frames(0, 4) = 0.0F;
  Exploration known = exploration;
  known.channels[0].valid = {};
  known.channels[0].frames(0, 4) = 20.0F;
  known.channels[0].frames(2, 4) = 20.0F;
  const HandScene scene = scene_with(Hand::kLucs3, sphere_thing());
  const auto player = play_hand(scene);
  const auto oracle = play_hand(scene);
  for (std::size_t frame = 0; frame < 4; ++frame) {
    EXPECT_EQ(farthest(player->poses(exploration, frame), oracle->poses(known, frame)), 0.0)
        << frame;
  }
  for (std::uint8_t& mark : exploration.channels[0].valid.values()) mark = 0;
  known.channels[0].frames = Matrix<float>(4, 11);
  EXPECT_EQ(farthest(player->poses(exploration, 3), oracle->poses(known, 3)), 0.0);
}

TEST(HandPoses, KnowWhichHandRecorded) {
  Exploration exploration;
  EXPECT_FALSE(is_of_hand(exploration, Hand::kLucs2));
  Channel joints;
  joints.name = "joints";
  joints.frames = Matrix<float>(1, 11);
  exploration.channels.push_back(joints);
  EXPECT_TRUE(is_of_hand(exploration, Hand::kLucs3));
  EXPECT_FALSE(is_of_hand(exploration, Hand::kLucs2));
  const auto player = play_hand(scene_with(Hand::kLucs2, sphere_thing()), false);
  EXPECT_EQ(count_role(player->scene(), GeomRole::kObject), 0U);
  EXPECT_THROW(player->poses(exploration, 0), InvalidArgument);
}

}  // namespace
}  // namespace somato
