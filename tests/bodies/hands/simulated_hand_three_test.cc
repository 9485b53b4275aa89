// Properties of Hand III in particular: tendons, potentiometers, an object against its palm.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "bodies/hands/simulated_hand_impl.h"
#include "bodies/support/things.h"
#include "somato/bodies/explore_by.h"

namespace somato {
namespace {

SimulationParameters quiet_three() {
  SimulationParameters parameters;
  parameters.taxels = true;
  parameters.sensor_noise = 0.0;
  parameters.joint_noise = 0.0;
  parameters.servo_play = 0.0;
  return parameters;
}

std::unique_ptr<SimulatedHand> three_with(const Object& object,
                                          const SimulationParameters& parameters = quiet_three()) {
  const auto scene = HandScene::build(Hand::kLucs3, object, parameters);
  EXPECT_TRUE(scene) << scene.error().what;
  return std::move(SimulatedHand::create(*scene, {}, 1).value());
}

Object tube(double diameter) {
  return thing(Shape::kCylinder, diameter, diameter, 130);
}

std::vector<float> reading(const SimulatedHand& hand, const char* sensor) {
  const auto row = hand.state().readings[*find_sensor(hand.description(), sensor)].row(0);
  return {row.begin(), row.end()};
}

double felt(const SimulatedHand& hand) {
  const auto touch = reading(hand, "touch");
  return std::accumulate(touch.begin(), touch.end(), 0.0);
}

void close(SimulatedHand& hand) {
  const auto exploration = explore_by_closing(hand, {});
  ASSERT_TRUE(exploration) << to_string(exploration.error());
}

TEST(SimulatedHandThree, HasThePapersServosAndElevenPotentiometers) {
  const auto hand = three_with(tube(60));
  EXPECT_EQ(hand->description().degrees_of_freedom.size(), 12U);
  EXPECT_EQ(hand->description().degrees_of_freedom[0].name, "wrist");
  EXPECT_EQ(reading(*hand, "joints").size(), 11U);
}

TEST(SimulatedHandThree, AClosedHandIsAtRestAndFeelsWhatItHolds) {
  for (const bool free : {false, true}) {
    SimulationParameters parameters = quiet_three();
    parameters.free = free;
    const auto hand = three_with(tube(60), parameters);
    close(*hand);
    EXPECT_GT(felt(*hand), 10.0);
    ASSERT_TRUE(hand->step(0.5));
    const auto before = reading(*hand, "joints");
    ASSERT_TRUE(hand->step(0.25));
    const auto after = reading(*hand, "joints");
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(after[i], before[i], 0.5F) << i;
  }
}

TEST(SimulatedHandThree, PotentiometersTellTheSizeOfWhatIsHeld) {
  std::vector<float> before;
  int monotone = 0;
  for (const double diameter : {40.0, 60.0, 80.0}) {
    const auto hand = three_with(tube(diameter));
    close(*hand);
    const auto joints = reading(*hand, "joints");
    if (!before.empty()) {
      for (std::size_t i = 0; i < joints.size(); ++i) monotone += joints[i] < before[i] ? 1 : 0;
    }
    before = joints;
  }
  // A wider thing stops a finger earlier: of 2 x 11 comparisons nearly all.
  EXPECT_GE(monotone, 18);
}

TEST(SimulatedHandThree, ServosNeverExceedTheirTorqueAndSpeed) {
  for (const bool free : {false, true}) {
    SimulationParameters parameters = quiet_three();
    parameters.free = free;
    const auto hand = three_with(tube(70), parameters);
    const auto& impl = hand->impl();
    const mjModel& model = *impl.scene->model;
    const auto& servos = hand->description().degrees_of_freedom;
    std::vector<double> targets(servos.size(), 0.0);
    double fastest = 0.0;
    double pressed = 0.0;  // The share of its greatest torque that a servo used.
    for (const bool closed : {false, true, false}) {
      for (std::size_t i = 1; i < servos.size(); ++i)
        targets[i] = closed ? servos[i].most : servos[i].least;
      ASSERT_TRUE(hand->command(targets));
      for (int step = 0; step < 3000; ++step) {
        ASSERT_TRUE(hand->step(0.001));
        for (int i = 0; i < static_cast<int>(model.nu); ++i) {
          const double most = detail::row_of(model.actuator_forcerange, i, 2)[1];
          pressed = std::max(pressed, std::abs(impl.data->actuator_force[i]) / most);
          fastest = std::max(fastest, std::abs(impl.data->actuator_velocity[i]));
        }
      }
    }
    EXPECT_LE(pressed, 1.0 + 1e-12);
    EXPECT_GT(pressed, 0.9);
    // The motor's own limit is 2.33 rad/s; a finger that snaps off an edge adds a
    // little.
    EXPECT_LE(fastest, 2.5);
    EXPECT_GT(fastest, 1.0);
  }
}

TEST(SimulatedHandThree, NoTaxelReadsWithoutContactOfItsOwn) {
  const auto hand = three_with(thing(Shape::kBlock, 70, 45, 120));
  close(*hand);
  const auto& impl = hand->impl();
  std::vector<bool> has_contact(impl.forces.size(), false);
  for (int i = 0; i < impl.data->ncon; ++i) {
    for (const int geom : detail::contact_geoms(impl.data->contact[i])) {
      const int taxel = impl.scene->taxels.taxel_of_geom[static_cast<std::size_t>(geom)];
      if (taxel >= 0) has_contact[static_cast<std::size_t>(taxel)] = true;
    }
  }
  for (std::size_t i = 0; i < has_contact.size(); ++i) {
    if (!has_contact[i]) {
      EXPECT_EQ(impl.forces[i], 0.0) << i;
    }
  }
  EXPECT_GT(std::count(has_contact.begin(), has_contact.end(), true), 2);
}

TEST(SimulatedHandThree, HalvingTheTimeStepHardlyChangesWhatIsFelt) {
  std::vector<double> changes;
  for (const double diameter : {40.0, 50.0, 60.0, 70.0, 80.0}) {
    SimulationParameters parameters = quiet_three();
    const auto coarse = three_with(tube(diameter), parameters);
    close(*coarse);
    parameters.time_step /= 2;
    const auto fine = three_with(tube(diameter), parameters);
    close(*fine);
    changes.push_back(std::abs(felt(*fine) / felt(*coarse) - 1.0));
  }
  std::sort(changes.begin(), changes.end());
  EXPECT_LT(changes[2], 0.03);
}

TEST(SimulatedHandThree, ATurnedBlockStandsAgainstThePalmWithItsCorner) {
  const auto scene =
      HandScene::build(Hand::kLucs3, thing(Shape::kBlock, 90, 60, 130), quiet_three());
  ASSERT_TRUE(scene);
  for (const double turn : {0.0, 6.0, -15.0, 40.0}) {
    const auto hand = SimulatedHand::create(*scene, {.x = 0, .y = 0, .turn = turn}, 1);
    EXPECT_TRUE(hand) << turn << ": " << hand.error().what;
  }
  const auto away = detail::object_pose(*scene->shared_impl(), {.x = 0, .y = -5.0, .turn = 0});
  const auto back = detail::object_pose(*scene->shared_impl(), {});
  EXPECT_NEAR(away.position[1] - back.position[1], 0.005, 1e-9);  // never into the palm
}

}  // namespace
}  // namespace somato
