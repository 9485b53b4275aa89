#include "bodies/sensors/touch_sensors.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace somato::detail {
namespace {

SimulationParameters noiseless_touch() {
  SimulationParameters parameters;
  parameters.sensor_noise = 0.0;
  parameters.touch_threshold = 0.0;
  return parameters;
}

std::vector<float> readings_of(const SimulationParameters& parameters, PiezoConverter converter,
                               const std::vector<double>& sensed) {
  Random hand(1);
  Random noise(2);
  std::vector<float> readings(sensed.size());
  TouchSensors(parameters, converter, sensed.size(), hand).read(sensed, noise, readings);
  return readings;
}

// 2 bits over 3 N: 0, 1, 2 and 3 N; with both signs -3, -1.5, 0 and 1.5 N.
TEST(TouchSensors, AConverterHasItsCodesAndNoOthers) {
  SimulationParameters parameters = noiseless_touch();
  parameters.touch_bits = 2;
  parameters.touch_range = 3.0;
  const std::vector<double> sensed{-9.0, -1.0, 0.4, 0.6, 2.4, 9.0};
  EXPECT_EQ(readings_of(parameters, PiezoConverter::kUnipolar, sensed),
            (std::vector<float>{0, 0, 0, 1, 2, 3}));
  EXPECT_EQ(readings_of(parameters, PiezoConverter::kBipolar, sensed),
            (std::vector<float>{-3, -1.5, 0, 0, 1.5, 1.5}));
}

TEST(TouchSensors, ReadingsBelowTheThresholdAreReportedAsNothing) {
  SimulationParameters parameters = noiseless_touch();
  parameters.touch_threshold = 0.5;
  EXPECT_EQ(readings_of(parameters, PiezoConverter::kBipolar, {-0.6, -0.4, 0.4, 0.5}),
            (std::vector<float>{-0.6F, 0, 0, 0.5F}));
}

TEST(TouchSensors, DrawingsOfOnePropertyDoNotShiftTheOthers) {
  SimulationParameters parameters = noiseless_touch();
  parameters.touch_gain_spread = 0.2;
  const auto gains = readings_of(parameters, PiezoConverter::kUnipolar, {1.0, 1.0, 1.0});
  parameters.touch_rest = 0.25;
  const auto resting = readings_of(parameters, PiezoConverter::kUnipolar, {1.0, 1.0, 1.0});
  for (std::size_t i = 0; i < gains.size(); ++i) EXPECT_FLOAT_EQ(resting[i], gains[i] + 0.25F);
  EXPECT_NE(gains[0], gains[1]);
}

}  // namespace
}  // namespace somato::detail
