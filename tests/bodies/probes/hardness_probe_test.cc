#include "bodies/probes/hardness_probe.h"

#include <gtest/gtest.h>

#include <cmath>

#include "somato/bodies/explore_by.h"

namespace somato {
namespace {

using P = HardnessProbeParameters;

Material of_stiffness(double stiffness) {
  Material material;
  material.name = "some";
  material.stiffness = stiffness;
  return material;
}

P noiseless() {
  P parameters;
  parameters.force_noise = 0.0;
  parameters.potentiometer_noise = 0.0;
  return parameters;
}

double counts_at(double millimetres) {
  return std::round(millimetres / 10.0 * 262143.0);
}

double press(double stiffness, const P& parameters, std::uint64_t seed = 1) {
  auto probe = make_hardness_probe(of_stiffness(stiffness), parameters, seed);
  EXPECT_TRUE(probe);
  const auto exploration = explore_by_pressing(**probe);
  EXPECT_TRUE(exploration);
  if (!exploration) return std::nan("");
  return static_cast<double>(exploration->channels.at(0).frames(0, 0));
}

// The reading after each step, on the way down to the limit.
std::vector<float> readings(double stiffness, const P& parameters,
                            const std::vector<double>& steps) {
  auto probe = make_hardness_probe(of_stiffness(stiffness), parameters, 1);
  EXPECT_TRUE((*probe)->command(std::vector<double>{10.0}));
  std::vector<float> all;
  for (const double seconds : steps) {
    EXPECT_TRUE((*probe)->step(seconds));
    all.push_back((*probe)->state().readings.at(0)(0, 0));
  }
  return all;
}

struct Spread {
  double mean = 0.0;
  double deviation = 0.0;
};

Spread spread_of(const std::vector<double>& values) {
  Spread spread;
  for (const double value : values) spread.mean += value / static_cast<double>(values.size());
  double squares = 0.0;
  for (const double value : values) squares += (value - spread.mean) * (value - spread.mean);
  spread.deviation = std::sqrt(squares / static_cast<double>(values.size() - 1));
  return spread;
}

TEST(HardnessProbe, TheStickComesToRestWhereForceAndMaterialBalance) {
  EXPECT_NEAR(press(2.5, noiseless()), counts_at(1.0 + 2.0), 2.0);
  EXPECT_NEAR(press(100.0, noiseless()), counts_at(1.0 + 0.05), 2.0);
  P stronger = noiseless();
  stronger.force = 15.0;
  stronger.clearance = 2.0;
  EXPECT_NEAR(press(3.0, stronger), counts_at(2.0 + 5.0), 2.0);
}

TEST(HardnessProbe, AMaterialTooSoftLetsTheStickThroughToTheEndOfItsStroke) {
  EXPECT_EQ(press(0.1, noiseless()), 262143.0);
}

TEST(HardnessProbe, TheReadingIsOneFrameOfCounts) {
  auto probe = make_hardness_probe(of_stiffness(5.0), {}, 1);
  const auto exploration = explore_by_pressing(**probe);
  ASSERT_TRUE(exploration);
  ASSERT_EQ(exploration->channels.size(), 1U);
  EXPECT_EQ(exploration->channels[0].name, "potentiometer");
  EXPECT_EQ(exploration->channels[0].unit, "counts");
  EXPECT_EQ(exploration->channels[0].frames.rows(), 1U);
  EXPECT_EQ(exploration->channels[0].frames.columns(), 1U);
}

TEST(HardnessProbe, ItApproachesAtItsSpeedAndThenExponentially) {
  // 1 mm at 20 mm/s, then a balance 2 mm deeper with a time constant of 2 mm / (20 mm/s).
  const auto all = readings(2.5, noiseless(), {0.03, 0.02, 0.1, 0.1});
  EXPECT_NEAR(all[0], counts_at(0.6), 2.0);
  EXPECT_NEAR(all[1], counts_at(1.0), 2.0);
  EXPECT_NEAR(all[2], counts_at(3.0 - 2.0 * std::exp(-1.0)), 2.0);
  EXPECT_NEAR(all[3], counts_at(3.0 - 2.0 * std::exp(-2.0)), 2.0);
}

TEST(HardnessProbe, ItStaysWhereItIsSentWhenThatIsLessDeep) {
  auto probe = make_hardness_probe(of_stiffness(1.0), noiseless(), 1);
  PressParameters shallow;
  shallow.to = 2.5;
  const auto exploration = explore_by_pressing(**probe, shallow);
  ASSERT_TRUE(exploration);
  EXPECT_EQ(exploration->channels[0].frames(0, 0), static_cast<float>(counts_at(2.5)));
}

TEST(HardnessProbe, ItComesBackWithTheServo) {
  auto probe = make_hardness_probe(of_stiffness(1.0), noiseless(), 1);
  ASSERT_TRUE((*probe)->command(std::vector<double>{10.0}));
  ASSERT_TRUE((*probe)->step(3.0));
  ASSERT_TRUE((*probe)->command(std::vector<double>{0.5}));
  ASSERT_TRUE((*probe)->step(1.0));
  EXPECT_EQ((*probe)->state().readings[0](0, 0), static_cast<float>(counts_at(0.5)));
}

TEST(HardnessProbe, TheCuttingOfTimeChangesNoReading) {
  const float whole = readings(2.5, {}, {1.0}).back();
  EXPECT_EQ(readings(2.5, {}, std::vector<double>(10, 0.1)).back(), whole);
  EXPECT_EQ(readings(2.5, {}, std::vector<double>(1000, 0.001)).back(), whole);
  EXPECT_EQ(readings(2.5, {}, {0.3333, 0.00001, 0.6, 0.06669}).back(), whole);
}

TEST(HardnessProbe, NoiseHasItsSpread) {
  P parameters = noiseless();
  parameters.potentiometer_noise = 0.02;
  std::vector<double> pressed;
  for (std::uint64_t seed = 0; seed < 200; ++seed) pressed.push_back(press(5.0, parameters, seed));
  EXPECT_NEAR(spread_of(pressed).deviation, counts_at(0.02), 0.15 * counts_at(0.02));
  EXPECT_NEAR(spread_of(pressed).mean, counts_at(2.0), 4.0 * counts_at(0.02) / std::sqrt(200.0));
}

TEST(HardnessProbe, ForceVariesFromProbeToProbe) {
  P parameters = noiseless();
  parameters.force_noise = 0.02;
  std::vector<double> pressed;
  for (std::uint64_t seed = 0; seed < 200; ++seed) pressed.push_back(press(1.0, parameters, seed));
  const double expected = counts_at(5.0 * 0.02);
  EXPECT_NEAR(spread_of(pressed).deviation, expected, 0.15 * expected);
}

TEST(HardnessProbe, OneSeedGivesTheSameReading) {
  EXPECT_EQ(press(5.0, {}, 42), press(5.0, {}, 42));
  EXPECT_NE(press(5.0, {}, 42), press(5.0, {}, 43));
  EXPECT_EQ(press(5.0, {}, 42), 52975.0);  // two compilers agree on it
}

TEST(HardnessProbe, AStickThatIsTooSlowNeverRests) {
  P parameters;
  parameters.stick_speed = 0.1;
  auto probe = make_hardness_probe(of_stiffness(1.0), parameters, 1);
  const auto refused = explore_by_pressing(**probe);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kData);
  EXPECT_EQ(refused.error().where, "stick");
}

TEST(HardnessProbe, WhatLiesBeyondItsLimitsIsRefused) {
  auto probe = make_hardness_probe(of_stiffness(1.0), {}, 1);
  for (const double target : {-0.1, 10.1}) {
    const auto refused = (*probe)->command(std::vector<double>{target});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().where, "stick");
  }
}

TEST(HardnessProbe, WhatDoesNotFitIsRefused) {
  P parameters;
  parameters.clearance = 10.0;
  const auto refused = make_hardness_probe(of_stiffness(1.0), parameters, 1);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kUsage);
  EXPECT_NE(refused.error().what.find("clearance"), std::string::npos);
  EXPECT_FALSE(make_hardness_probe(of_stiffness(0.0), {}, 1));
  parameters = {};
  parameters.force = std::nan("");
  EXPECT_FALSE(make_hardness_probe(of_stiffness(1.0), parameters, 1));
}

TEST(HardnessProbe, EveryParameterSaysWhatThePaperGives) {
  for (const auto& parameter : P::declarations().all()) {
    const std::string& text = parameter.info.text;
    EXPECT_TRUE(text.find("ot given in the paper") != std::string::npos ||
                text.find("P11") != std::string::npos)
        << parameter.info.name;
  }
}

}  // namespace
}  // namespace somato
