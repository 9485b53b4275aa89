#include "bodies/hands/hand_scene.h"

#include <gtest/gtest.h>

#include <string>

#include "base/files/embedded.h"
#include "bodies/support/things.h"

namespace somato {
namespace {

std::shared_ptr<mjModel> model_of(const std::string& path) {
  auto model = detail::compile_model(std::string(detail::embedded_text(path)), path);
  EXPECT_TRUE(model) << to_string(model.error());
  return *model;
}

HandScene scene_of(Hand hand, const Object& object, const SimulationParameters& parameters = {}) {
  auto scene = HandScene::build(hand, object, parameters);
  EXPECT_TRUE(scene) << to_string(scene.error());
  return *scene;
}

TEST(HandScene, ModelsStandByThemselvesForAnyViewer) {
  for (const char* path : {"models/lucs_haptic_hand_2.xml", "models/lucs_haptic_hand_3.xml"}) {
    SCOPED_TRACE(path);
    const auto model = model_of(path);
    EXPECT_GE(detail::find_in(*model, mjOBJ_CAMERA, "view"), 0);
    EXPECT_GE(detail::find_in(*model, mjOBJ_GEOM, "table"), 0);
    EXPECT_GT(model->nlight, 0);
    const auto data = detail::make_data(model);
    while ((*data)->time < 0.5) mj_step(model.get(), data->get());
    EXPECT_TRUE(detail::check_stable(**data));
  }
}

TEST(HandScene, HandTwoHasThePapersNumbers) {
  const auto model = model_of("models/lucs_haptic_hand_2.xml");
  EXPECT_EQ(model->nu, 8);
  EXPECT_EQ(detail::find_taxels(*model).names.size(), 45U);
}

TEST(HandScene, HandThreeHasThePapersNumbers) {
  const auto model = model_of("models/lucs_haptic_hand_3.xml");
  EXPECT_EQ(model->nu, 12);
  EXPECT_EQ(model->nsensor, 11);
  EXPECT_EQ(detail::find_in(*model, mjOBJ_SENSOR, "wrist"), -1);
}

TEST(HandScene, LimitsAndPacesComeFromTheModel) {
  const HandScene scene = scene_of(Hand::kLucs2, cylinder_thing());
  const auto& servos = scene.shared_impl()->description.degrees_of_freedom;
  EXPECT_EQ(servos[0].least, 100.0);
  EXPECT_EQ(servos[0].most, 250.0);
  EXPECT_NEAR(servos[0].fastest, 100.0, 1e-9);
  EXPECT_NEAR(servos[2].fastest, 2.6 * 180 / 3.14159265358979, 1e-6);
}

TEST(HandScene, ASoftMaterialGivesWayMore) {
  const auto time_constant = [](double stiffness) {
    Object object = block_thing();
    object.material.stiffness = stiffness;
    const HandScene scene = scene_of(Hand::kLucs2, object);
    const auto& parts = *scene.shared_impl();
    return parts.model->geom_solref[mjNREF * parts.object_geom];
  };
  EXPECT_NEAR(time_constant(1e6), 0.01, 1e-5);                // only that of the skin
  EXPECT_NEAR(time_constant(20.0), 0.01 * 1.41421356, 1e-6);  // as stiff as the skin
  EXPECT_GT(time_constant(1.0), 0.04);
}

TEST(HandScene, TheObjectsFrictionCountsUnlessTheCallerSaysOtherwise) {
  Object object = block_thing();
  object.material.friction = 0.7;
  SimulationParameters parameters;
  const auto friction = [&] {
    const HandScene scene = scene_of(Hand::kLucs2, object, parameters);
    const auto& parts = *scene.shared_impl();
    return parts.model->geom_friction[3 * parts.object_geom];
  };
  EXPECT_EQ(friction(), 0.7);
  parameters.friction = 0.2;
  EXPECT_EQ(friction(), 0.2);
}

TEST(HandScene, TheWiderSideGoesAgainstThePalm) {
  const HandScene wide = scene_of(Hand::kLucs3, thing(Shape::kBlock, 70, 45, 120));
  const HandScene deep = scene_of(Hand::kLucs3, thing(Shape::kBlock, 45, 70, 120));
  EXPECT_FALSE(wide.shared_impl()->turn_to_palm);
  EXPECT_TRUE(deep.shared_impl()->turn_to_palm);
  EXPECT_FALSE(scene_of(Hand::kLucs2, thing(Shape::kBlock, 45, 70, 100)).shared_impl()->at_palm);
}

TEST(HandScene, HandThreeHasTaxelsOnRequest) {
  SimulationParameters parameters;
  const auto count = [&] {
    const HandScene scene = scene_of(Hand::kLucs3, cylinder_thing(), parameters);
    return scene.shared_impl()->taxels.names.size();
  };
  // Those that can touch something.
  const auto touchable = [&] {
    const HandScene scene = scene_of(Hand::kLucs3, cylinder_thing(), parameters);
    const mjModel& model = *scene.shared_impl()->model;
    const auto geoms = detail::find_taxels(model).taxel_of_geom;
    int found = 0;
    for (std::size_t geom = 0; geom < geoms.size(); ++geom)
      found += geoms[geom] >= 0 && model.geom_contype[geom] != 0 ? 1 : 0;
    return found;
  };
  EXPECT_EQ(count(), 0U);
  EXPECT_EQ(touchable(), 0);
  parameters.taxels = true;
  EXPECT_EQ(count(), 37U);
  EXPECT_EQ(touchable(), 37);
}

TEST(HandScene, AnObjectIsPutIntoTheModelsText) {
  EXPECT_EQ(detail::scene_mjcf("<mujoco><worldbody>A</worldbody>B</mujoco>", "C", "D"),
            "<mujoco><worldbody>AD</worldbody><asset>C</asset>B</mujoco>");
  EXPECT_EQ(detail::scene_mjcf("<mujoco><worldbody></worldbody></mujoco>", "", "D"),
            "<mujoco><worldbody>D</worldbody></mujoco>");
}

}  // namespace
}  // namespace somato
