#include "bodies/hands/object_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "bodies/support/things.h"

namespace somato::detail {
namespace {

HandScene scene_with(const Object& object, bool free) {
  SimulationParameters parameters;
  parameters.free = free;
  const auto scene = HandScene::build(Hand::kLucs2, object, parameters);
  EXPECT_TRUE(scene) << scene.error().what;
  return *scene;
}

struct Placed {
  explicit Placed(const HandScene& scene, const Placement& placement = {})
      : parts(*scene.shared_impl()),
        pose(object_pose(parts, placement)),
        data(mj_makeData(parts.model.get())) {
    put_object(parts, pose, *data);
    mj_forward(parts.model.get(), data.get());
  }

  // Where the free object's joint keeps its position.
  mjtNum* at() {
    const mjModel& model = *parts.model;
    return data->qpos + model.jnt_qposadr[model.body_jntadr[parts.object_body]];
  }

  Result<void> check() {
    mj_kinematics(parts.model.get(), data.get());
    return check_object(parts, pose, *data);
  }

  const HandScene::Impl& parts;
  Pose pose;
  PhysicsData data;
};

TEST(ObjectMotion, AnObjectStandsWhereItIsPlaced) {
  for (const bool free : {false, true}) {
    const HandScene scene = scene_with(block_thing(), free);
    const Placed placed(scene, {.x = 3.0, .y = -2.0, .turn = 30.0});
    const mjtNum* position = placed.data->xpos + 3 * placed.parts.object_body;
    EXPECT_NEAR(position[0], 0.003, 1e-9);
    EXPECT_NEAR(position[1], -0.002, 1e-9);
    EXPECT_NEAR(position[2], 0.0, 1e-9);
    const mjtNum* rotation = placed.data->xmat + 9 * placed.parts.object_body;
    EXPECT_NEAR(rotation[0], std::cos(std::numbers::pi / 6), 1e-9);
    EXPECT_NEAR(rotation[3], std::sin(std::numbers::pi / 6), 1e-9);
  }
}

TEST(ObjectMotion, AFreeObjectThatStaysIsFine) {
  const HandScene scene = scene_with(cylinder_thing(), true);
  Placed placed(scene);
  EXPECT_TRUE(placed.check());
  placed.at()[0] = 0.055;
  EXPECT_TRUE(placed.check());
}

TEST(ObjectMotion, ALostFreeObjectIsReportedWithItsMotion) {
  const HandScene scene = scene_with(cylinder_thing(), true);
  const auto said = [&](auto&& move) {
    Placed placed(scene);
    move(placed.at());
    const auto checked = placed.check();
    EXPECT_FALSE(checked);
    EXPECT_EQ(checked.error().where, "thing");
    EXPECT_EQ(checked.error().kind, ErrorKind::kData);
    return checked.error().what;
  };
  EXPECT_NE(said([](mjtNum* at) { at[0] = 0.065; }).find("flew away"), std::string::npos);
  EXPECT_NE(said([](mjtNum* at) { at[2] = 0.1; }).find("flew away"), std::string::npos);
  EXPECT_NE(said([](mjtNum* at) { at[2] = -0.01; }).find("sank"), std::string::npos);
  EXPECT_NE(said([](mjtNum* at) {
              at[3] = std::cos(0.5);  // turned by 1 rad about x
              at[4] = std::sin(0.5);
            }).find("fell over"),
            std::string::npos);
}

TEST(ObjectMotion, AHeldObjectIsNeverLost) {
  const HandScene scene = scene_with(cylinder_thing(), false);
  Placed placed(scene);
  EXPECT_TRUE(placed.check());
}

TEST(ObjectMotion, OnlyWhatTouchesTheHandIsInItsWay) {
  const HandScene free_block = scene_with(block_thing(), true);
  Placed placed(free_block);
  placed.at()[2] = -0.001;  // into the table, which is not the hand
  mj_forward(placed.parts.model.get(), placed.data.get());
  ASSERT_GT(placed.data->ncon, 0);
  EXPECT_TRUE(check_apart(placed.parts, *placed.data));
  placed.at()[2] = 0.15;  // up into the palm
  mj_forward(placed.parts.model.get(), placed.data.get());
  const auto apart = check_apart(placed.parts, *placed.data);
  ASSERT_FALSE(apart);
  EXPECT_NE(apart.error().what.find("'thing' does not fit the hand"), std::string::npos);
}

TEST(ObjectMotion, AFreeSphereComesToRestOnItsBeads) {
  const HandScene scene = scene_with(sphere_thing(), true);
  Placed placed(scene);
  while (placed.data->time < 1.0) mj_step(placed.parts.model.get(), placed.data.get());
  // Its middle is where three beads (radius a ninth, ring 0.55 of its own) carry it.
  const double expected = 0.004 + std::sqrt(0.040 * 0.040 - 0.0198 * 0.0198) - 0.036;
  EXPECT_NEAR(placed.at()[2], expected, 0.001);  // contacts give way by less than 1 mm
  EXPECT_NEAR(std::hypot(placed.at()[0], placed.at()[1]), 0.0, 0.0005);
  const mjtNum* speed =
      placed.data->qvel +
      placed.parts.model->jnt_dofadr[placed.parts.model->body_jntadr[placed.parts.object_body]];
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(speed[i], 0.0, 1e-3);
  EXPECT_TRUE(placed.check());
}

}  // namespace
}  // namespace somato::detail
