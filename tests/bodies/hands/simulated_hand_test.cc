#include "somato/simulation/simulated_hand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "bodies/hands/simulated_hand_impl.h"
#include "bodies/support/things.h"

namespace somato {
namespace {

SimulationParameters quiet() {
  SimulationParameters parameters;
  parameters.sensor_noise = 0.0;
  parameters.servo_play = 0.0;
  parameters.touch_threshold = 0.0;
  parameters.piezo_converter = PiezoConverter::kBipolar;
  return parameters;
}

std::unique_ptr<SimulatedHand> hand_with(const Object& object,
                                         const SimulationParameters& parameters = quiet(),
                                         std::uint64_t seed = 1) {
  const auto scene = HandScene::build(Hand::kLucs2, object, parameters);
  EXPECT_TRUE(scene) << scene.error().what;
  auto hand = SimulatedHand::create(*scene, {}, seed);
  EXPECT_TRUE(hand) << hand.error().what;
  return std::move(*hand);
}

// Height and wrist, and the same angles for all three fingers.
std::vector<double> posture(double height, double proximal, double distal) {
  return {height, 0, proximal, distal, proximal, distal, proximal, distal};
}

void go(SimulatedHand& hand, const std::vector<double>& targets, double seconds) {
  ASSERT_TRUE(hand.command(targets));
  for (double passed = 0.0; passed < seconds - 1e-9; passed += 0.1) {
    const auto stepped = hand.step(0.1);
    ASSERT_TRUE(stepped) << stepped.error().what;
  }
}

void grasp(SimulatedHand& hand) {
  go(hand, posture(130, 0, -75), 2.0);
  go(hand, posture(130, 21, -75), 1.0);
  go(hand, posture(130, 21, -20), 2.0);
}

std::span<const float> touch(const SimulatedHand& hand) {
  return hand.state().readings[*find_sensor(hand.description(), "touch")].row(0);
}

double sum(std::span<const float> values) {
  double total = 0.0;
  for (const float value : values) total += value;
  return total;
}

TEST(SimulatedHand, HasThePapersServosAndSensors) {
  const auto hand = hand_with(cylinder_thing());
  const BodyDescription& description = hand->description();
  ASSERT_EQ(description.degrees_of_freedom.size(), 8U);
  EXPECT_EQ(description.degrees_of_freedom[0].name, "height");
  EXPECT_EQ(description.degrees_of_freedom[0].unit, "mm");
  EXPECT_EQ(description.degrees_of_freedom[1].name, "wrist");
  EXPECT_EQ(description.degrees_of_freedom[7].name, "finger3_distal");
  EXPECT_EQ(description.degrees_of_freedom[7].least, -75.0);
  EXPECT_EQ(description.degrees_of_freedom[7].most, 30.0);
  std::vector<std::string> names;
  std::vector<std::size_t> widths;
  for (std::size_t i = 0; i < description.sensors.size(); ++i) {
    names.push_back(description.sensors[i].name);
    widths.push_back(hand->state().readings[i].columns());
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"height", "wrist", "joints", "touch", "touch_change"}));
  EXPECT_EQ(widths, (std::vector<std::size_t>{1, 1, 6, 45, 45}));
}

TEST(SimulatedHand, SevenTaxelsAreOnEachProximalAndEightOnEachDistalSegment) {
  const auto hand = hand_with(cylinder_thing());
  const auto& names = hand->description().sensors[3].element_names;
  for (const int finger : {1, 2, 3}) {
    const std::string prefix = "finger" + std::to_string(finger);
    const auto count = [&](const std::string& segment) {
      return std::count_if(names.begin(), names.end(), [&](const std::string& name) {
        return name.starts_with(prefix + "_" + segment + "_");
      });
    };
    EXPECT_EQ(count("proximal"), 7);
    EXPECT_EQ(count("distal"), 8);
  }
}

TEST(SimulatedHand, ServosArriveWhereTheyAreDriven) {
  const auto hand = hand_with(cylinder_thing());
  go(*hand, {150, 30, 5, -40, 5, -40, 5, -40}, 3.0);
  const std::vector<double> expected{150, 30, 5, -40, 5, -40, 5, -40};
  for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(hand->state().positions[i], expected[i], 1e-9);
  // The servos are springs: gravity and friction leave the joints off by a little.
  const auto& impl = hand->impl();
  EXPECT_NEAR(impl.data->qpos[0], 0.150, 0.002);
  EXPECT_NEAR(impl.data->qpos[1], 30 * std::numbers::pi / 180, 0.005);
  EXPECT_NEAR(impl.data->qpos[3], -40 * std::numbers::pi / 180, 0.02);
}

TEST(SimulatedHand, AnEmptyHandFeelsNothing) {
  const auto hand = hand_with(thing(Shape::kSphere, 10, 10, 10));
  grasp(*hand);
  EXPECT_EQ(sum(touch(*hand)), 0.0);
}

TEST(SimulatedHand, AGraspIsFeltAndComesToRest) {
  for (const bool free : {false, true}) {
    for (const Object& object : {cylinder_thing(), block_thing()}) {
      SimulationParameters parameters = quiet();
      parameters.free = free;
      const auto hand = hand_with(object, parameters);
      grasp(*hand);
      EXPECT_GT(sum(touch(*hand)), 2.0);
      go(*hand, posture(130, 21, -20), 2.0);
      const auto& data = *hand->impl().data;
      for (int i = 0; i < static_cast<int>(hand->impl().scene->model->nv); ++i)
        EXPECT_NEAR(data.qvel[i], 0.0, 2e-3) << i << (free ? " free" : " held");
      const double before = sum(touch(*hand));
      go(*hand, posture(130, 21, -20), 1.0);
      EXPECT_NEAR(sum(touch(*hand)), before, 0.01 * before);
    }
  }
}

TEST(SimulatedHand, ForcesOfAHeldGraspBalanceThoseOfTheServos) {
  // The forces on the taxels and bare plates of a finger must balance its joints: the
  // torque about the distal hinge that its contacts make equals its servo's, but for its own weight
  // and friction.
  const auto hand = hand_with(cylinder_thing());
  grasp(*hand);
  go(*hand, posture(130, 21, 0), 2.0);
  const auto& impl = hand->impl();
  const mjModel& model = *impl.scene->model;
  const mjData& data = *impl.data;
  const int joint = mj_name2id(&model, mjOBJ_JOINT, "finger1_distal");
  double torque = 0.0;
  for (int i = 0; i < data.ncon; ++i) {
    const auto& contact = data.contact[i];
    const auto geoms = detail::contact_geoms(contact);
    const bool second = model.geom_bodyid[geoms[1]] == model.jnt_bodyid[joint];
    if (!second && model.geom_bodyid[geoms[0]] != model.jnt_bodyid[joint]) continue;
    std::array<mjtNum, 6> local{};
    mj_contactForce(&model, &data, i, local.data());
    std::array<mjtNum, 3> force{};
    mju_mulMatTVec(force.data(), contact.frame, local.data(), 3, 3);
    std::array<mjtNum, 3> arm{};
    mju_sub3(arm.data(), contact.pos, data.xanchor + 3 * joint);
    std::array<mjtNum, 3> moment{};
    mju_cross(moment.data(), arm.data(), force.data());
    torque += (second ? 1 : -1) * mju_dot3(moment.data(), data.xaxis + 3 * joint);
  }
  const int servo = mj_name2id(&model, mjOBJ_ACTUATOR, "finger1_distal");
  EXPECT_GT(data.actuator_force[servo], 0.2);
  EXPECT_NEAR(torque + data.actuator_force[servo], 0.0, 0.02 + 0.03);
}

TEST(SimulatedHand, ServosNeverExceedTheirTorqueAndSpeed) {
  for (const bool free : {false, true}) {
    SimulationParameters parameters;
    parameters.free = free;
    const auto hand = hand_with(cylinder_thing(), parameters);
    const auto& impl = hand->impl();
    double fastest = 0.0;
    double strongest = 0.0;
    const auto watch = [&](const std::vector<double>& targets) {
      ASSERT_TRUE(hand->command(targets));
      for (int step = 0; step < 1500; ++step) {
        ASSERT_TRUE(hand->step(0.001));
        for (int i = 2; i < 8; ++i) {
          strongest = std::max(strongest, std::abs(impl.data->actuator_force[i]));
          fastest = std::max(fastest, std::abs(impl.data->actuator_velocity[i]));
        }
      }
    };
    // As hard as it can: from open to closed on the object, and back.
    watch(posture(130, 0, -75));
    watch(posture(130, 30, 30));
    watch(posture(130, 0, -75));
    EXPECT_LE(strongest, 0.54 + 1e-12);
    EXPECT_GT(strongest, 0.5);
    // Torque over damping, and what the fingers' weight adds.
    EXPECT_LE(fastest, 3.0);
    EXPECT_GT(fastest, 2.0);
  }
}

TEST(SimulatedHand, TheTimeBetweenReadingsChangesNoPhysics) {
  const auto coarse = hand_with(cylinder_thing());
  const auto fine = hand_with(cylinder_thing());
  grasp(*coarse);
  for (const auto& [targets, seconds] :
       std::vector<std::pair<std::vector<double>, int>>{{posture(130, 0, -75), 2000},
                                                        {posture(130, 21, -75), 1000},
                                                        {posture(130, 21, -20), 2000}}) {
    ASSERT_TRUE(fine->command(targets));
    for (int step = 0; step < seconds / 5; ++step) ASSERT_TRUE(fine->step(0.005));
  }
  EXPECT_EQ(coarse->impl().forces, fine->impl().forces);
  EXPECT_NEAR(coarse->state().time, fine->state().time, 1e-9);
}

TEST(SimulatedHand, OneSeedGivesTheSameReadingsAndAnotherDoesNot) {
  const auto reading = [](std::uint64_t seed) {
    SimulationParameters parameters;
    parameters.sensor_noise = 0.1;
    const auto hand = hand_with(cylinder_thing(), parameters, seed);
    grasp(*hand);
    const auto row = touch(*hand);
    return std::vector<float>(row.begin(), row.end());
  };
  EXPECT_EQ(reading(5), reading(5));
  EXPECT_NE(reading(5), reading(6));
}

TEST(SimulatedHand, NoiseHasItsSpreadAndForceIsNeverBelowZero) {
  SimulationParameters parameters = quiet();
  parameters.sensor_noise = 0.5;
  const auto hand = hand_with(thing(Shape::kSphere, 10, 10, 10), parameters);
  double squares = 0.0;
  double least = 0.0;
  double count = 0.0;
  for (int step = 0; step < 100; ++step) {
    ASSERT_TRUE(hand->step(0.01));
    for (const float value : touch(*hand)) least = std::min<double>(least, value);
    for (const float value : hand->state().readings[4].row(0)) {
      squares += value * value;
      count += 1.0;
    }
  }
  EXPECT_EQ(least, 0.0);
  EXPECT_NEAR(std::sqrt(squares / count), 0.5, 0.02);
}

// Each reading of touch (3) and touch_change (4) while a hand closes on a thing and opens again.
std::vector<std::vector<float>> readings_of(SimulationParameters parameters) {
  parameters.sensor_noise = 0.02;
  const auto hand = hand_with(cylinder_thing(), parameters);
  std::vector<std::vector<float>> all(2);
  for (const auto& [distal, seconds] : {std::pair(-75, 2.0), {-20, 2.0}, {-75, 2.0}}) {
    EXPECT_TRUE(hand->command(posture(130, 21, distal)));
    for (double passed = 0.0; passed < seconds; passed += 0.1) {
      EXPECT_TRUE(hand->step(0.1));
      for (std::size_t i = 0; i < 2; ++i) {
        const auto row = hand->state().readings[3 + i].row(0);
        all[i].insert(all[i].end(), row.begin(), row.end());
      }
    }
  }
  return all;
}

// The noise is drawn alike, so that only what is reported of it differs.
TEST(SimulatedHand, ReportsNothingBelowTheThreshold) {
  SimulationParameters parameters = quiet();
  const auto whole = readings_of(parameters);
  parameters.touch_threshold = 0.1;
  const auto reported = readings_of(parameters);
  for (std::size_t channel = 0; channel < 2; ++channel) {
    std::size_t silenced = 0;
    for (std::size_t i = 0; i < whole[channel].size(); ++i) {
      const float read = whole[channel][i];
      EXPECT_EQ(reported[channel][i], std::abs(read) < 0.1F ? 0.0F : read);
      silenced += read != 0.0F && reported[channel][i] == 0.0F ? 1 : 0;
    }
    EXPECT_GT(silenced, whole[channel].size() / 4);
    EXPECT_GT(*std::max_element(reported[channel].begin(), reported[channel].end()), 0.5F);
  }
}

TEST(SimulatedHand, AUnipolarConverterReadsRisingLoadsOnly) {
  SimulationParameters parameters = quiet();
  const auto both_ways = readings_of(parameters);
  parameters.piezo_converter = PiezoConverter::kUnipolar;
  const auto rising = readings_of(parameters);
  EXPECT_EQ(rising[0], both_ways[0]);
  EXPECT_LT(*std::min_element(both_ways[1].begin(), both_ways[1].end()), -0.5F);
  for (std::size_t i = 0; i < rising[1].size(); ++i) {
    EXPECT_EQ(rising[1][i], std::max(0.0F, both_ways[1][i]));
  }
}

TEST(SimulatedHand, ThePiezoChannelForgetsASteadyGrasp) {
  const auto hand = hand_with(cylinder_thing());
  grasp(*hand);
  go(*hand, posture(130, 21, -20), 3.0);
  EXPECT_GT(sum(touch(*hand)), 2.0);
  EXPECT_NEAR(sum(hand->state().readings[4].row(0)), 0.0, 0.01);
}

TEST(SimulatedHand, ThingsThatDoNotFitAreRefusedBeforeAnythingMoves) {
  const auto wide = HandScene::build(Hand::kLucs2, thing(Shape::kBlock, 500, 50, 50), quiet());
  ASSERT_FALSE(wide);
  EXPECT_NE(wide.error().what.find("does not fit the hand"), std::string::npos);
  const auto tall = HandScene::build(Hand::kLucs2, thing(Shape::kCylinder, 60, 60, 300), quiet());
  ASSERT_TRUE(tall);
  const auto hand = SimulatedHand::create(*tall, {}, 1);
  ASSERT_FALSE(hand);
  EXPECT_NE(hand.error().what.find("does not fit the hand"), std::string::npos);
}

TEST(SimulatedHand, APostureThatMeetsTheObjectIsFoundWithoutMoving) {
  const auto hand = hand_with(thing(Shape::kCylinder, 60, 60, 150));
  EXPECT_TRUE(hand->check_clear(posture(180, 0, -75)));
  const auto low = hand->check_clear(posture(126, 0, -75));  // the palm is at 145 mm
  ASSERT_FALSE(low);
  EXPECT_NE(low.error().what.find("'palm'"), std::string::npos);
  EXPECT_EQ(hand->state().time, 0.0);
}

TEST(SimulatedHand, PlacementsHaveTheSpreadTheyAreSaidTo) {
  SimulationParameters parameters;
  parameters.placement_noise = 3.0;
  Random random(11);
  double xx = 0.0;
  double yy = 0.0;
  double turns = 0.0;
  constexpr int kDraws = 4000;
  for (int i = 0; i < kDraws; ++i) {
    const Placement placement = draw_placement(parameters, random);
    xx += placement.x * placement.x;
    yy += placement.y * placement.y;
    turns += placement.turn * placement.turn;
  }
  EXPECT_NEAR(std::sqrt(xx / kDraws), 3.0, 0.1);
  EXPECT_NEAR(std::sqrt(yy / kDraws), 3.0, 0.1);
  EXPECT_NEAR(std::sqrt(turns / kDraws), 6.0, 0.2);  // 2 deg a mm
  parameters.placement_turn = 0.0;
  EXPECT_EQ(draw_placement(parameters, random).turn, 0.0);
}

}  // namespace
}  // namespace somato
