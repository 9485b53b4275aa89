#include "bodies/physics/physics.h"

#include <gtest/gtest.h>

#include <limits>

#include "bodies/hands/simulated_hand_impl.h"
#include "bodies/support/things.h"

namespace somato::detail {
namespace {

constexpr const char* kBall =
    R"(<mujoco><worldbody><body name="ball"><freejoint/><geom size="0.1"/></body></worldbody></mujoco>)";

TEST(Physics, CompilesAModelAndKnowsItsParts) {
  const auto model = compile_model(kBall, "ball");
  ASSERT_TRUE(model);
  EXPECT_EQ(find_in(**model, mjOBJ_BODY, "ball"), 1);
  EXPECT_EQ(find_in(**model, mjOBJ_BODY, "cube"), -1);
}

TEST(Physics, ModelsThatTheEngineRefusesAreReportedByName) {
  for (const char* text : {"", "<mujoco>", "no markup",
                           R"(<mujoco><worldbody><geom size="-1"/></worldbody></mujoco>)"}) {
    const auto model = compile_model(text, "thing.xml");
    ASSERT_FALSE(model) << text;
    EXPECT_EQ(model.error().kind, ErrorKind::kData);
    EXPECT_EQ(model.error().where, "thing.xml");
    EXPECT_NE(model.error().what.find("physics engine"), std::string::npos);
  }
}

TEST(Physics, ASimulationThatDivergesIsNoticed) {
  const auto model = compile_model(kBall, "ball");
  for (const double speed : {1e20, std::numeric_limits<double>::quiet_NaN()}) {
    const auto data = make_data(*model);
    mj_step(model->get(), data->get());
    EXPECT_TRUE(check_stable(**data));
    (*data)->qvel[0] = speed;
    mj_step(model->get(), data->get());
    const auto stable = check_stable(**data);
    ASSERT_FALSE(stable);
    EXPECT_EQ(stable.error().kind, ErrorKind::kData);
    EXPECT_NE(stable.error().what.find("diverged"), std::string::npos);
  }
}

TEST(Physics, AHandWhoseSimulationDivergesEndsItsStepWithTheObjectsName) {
  const auto scene = HandScene::build(Hand::kLucs2, cylinder_thing());
  ASSERT_TRUE(scene);
  const auto hand = SimulatedHand::create(*scene, {}, 1);
  ASSERT_TRUE(hand);
  ASSERT_TRUE((*hand)->step(0.1));
  (*hand)->impl().data->qvel[3] = 1e20;
  const auto step = (*hand)->step(0.1);
  ASSERT_FALSE(step);
  EXPECT_EQ(step.error().where, "thing");
  EXPECT_NE(step.error().what.find("diverged"), std::string::npos);
}

}  // namespace
}  // namespace somato::detail
