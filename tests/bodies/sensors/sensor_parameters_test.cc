#include "bodies/sensors/sensor_parameters.h"

#include <gtest/gtest.h>

#include <set>

namespace somato {
namespace {

Table table_with(const std::string& name, Value value) {
  return {"", {{name, "--flag", std::move(value)}}};
}

Exploration with_channels(const std::vector<std::string>& names) {
  Exploration exploration;
  for (const std::string& name : names) {
    exploration.channels.emplace_back();
    exploration.channels.back().name = name;
  }
  return exploration;
}

TEST(SensorParameters, HaveDifferentNamesAndAllAreRead) {
  std::set<std::string> names;
  for (const ParameterInfo& info : sensor_parameters()) {
    EXPECT_TRUE(names.insert(info.name).second) << info.name;
  }
  for (const char* name : {"sensor_noise", "touch_bits", "joint_spread", "sensitivity",
                           "ambient_sound", "potentiometer_path", "press_spread", "true_values"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
  EXPECT_FALSE(names.contains("placement_noise"));
  EXPECT_FALSE(names.contains("force"));
}

TEST(SensorParameters, GoToTheirTables) {
  const Table given{"",
                    {{"joint_noise", "a", Value{0.5}},
                     {"adc_bits", "b", Value{std::int64_t{8}}},
                     {"press_spread", "c", Value{0.25}}}};
  const auto read = read_sensor_parameters(given, {});
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_EQ(read->simulation.joint_noise, 0.5);
  EXPECT_EQ(read->texture_probe.adc_bits, 8U);
  EXPECT_EQ(read->hardness_probe.press_spread, 0.25);
  EXPECT_EQ(read->simulation.sensor_noise, SimulationParameters{}.sensor_noise);
}

// The settings of every exploration that can be played have true_values = true.
TEST(SensorParameters, KeepTrueValuesOnlyIfGiven) {
  ExploringParameters of_file;
  of_file.simulation.true_values = true;
  of_file.simulation.joint_noise = 0.5;
  const auto read = read_sensor_parameters({}, of_file);
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_FALSE(read->simulation.true_values);
  EXPECT_EQ(read->simulation.joint_noise, 0.5);
  const auto given = read_sensor_parameters(table_with("true_values", Value{true}), of_file);
  ASSERT_TRUE(given) << to_string(given.error());
  EXPECT_TRUE(given->simulation.true_values);
}

TEST(SensorParameters, UnknownNamesAndValuesOutOfRangeAreRefused) {
  EXPECT_NE(to_string(read_sensor_parameters(table_with("sensor_nose", Value{0.5}), {}).error())
                .find("did you mean 'sensor_noise'"),
            std::string::npos);
  EXPECT_FALSE(read_sensor_parameters(table_with("placement_noise", Value{0.5}), {}));
  EXPECT_NE(to_string(read_sensor_parameters(table_with("sensor_noise", Value{-1.0}), {}).error())
                .find("--flag"),
            std::string::npos);
}

TEST(SensorParameters, HaveAnEffectOnlyWhereTheirSensorIs) {
  const Exploration press = with_channels({"potentiometer", "true_stick", "true_draws"});
  EXPECT_TRUE(check_sensor_effect(table_with("press_spread", Value{0.1}), press));
  EXPECT_TRUE(check_sensor_effect(table_with("true_values", Value{true}), press));
  EXPECT_EQ(to_string(check_sensor_effect(table_with("joint_noise", Value{0.1}), press).error()),
            "--flag: has no effect, because the recording has no true values of its sensor; omit "
            "it");
  // sense() explains that there are no true values at all.
  EXPECT_TRUE(
      check_sensor_effect(table_with("joint_noise", Value{0.1}), with_channels({"joints"})));
}

}  // namespace
}  // namespace somato
