#include "somato/simulation/simulation_parameters.h"

#include <gtest/gtest.h>

#include "base/files/toml_file.h"

namespace somato {
namespace {

Result<ExploringParameters> read(const std::string& text) {
  return parse_toml(text, "settings.toml").and_then([](const Table& table) {
    return read_exploring_parameters(table);
  });
}

TEST(ExploringParameters, EveryTableIsReadAndTheRestStaysAsItWas) {
  const auto parameters = read(R"([simulation]
free = true
[plan]
grasps = 2
[grasp]
threshold = 2.5
[closing]
share = 0.5
[texture_probe]
servo_noise = 7.0
[stroke]
to = 18.0
[hardness_probe]
force = 3.0
[press]
readings = 4
)");
  ASSERT_TRUE(parameters) << parameters.error().what;
  EXPECT_TRUE(parameters->simulation.free);
  EXPECT_EQ(parameters->simulation.placement_noise, SimulationParameters{}.placement_noise);
  EXPECT_EQ(parameters->plan.grasps, 2U);
  EXPECT_EQ(parameters->grasp.threshold, 2.5);
  EXPECT_EQ(parameters->closing.share, 0.5);
  EXPECT_EQ(parameters->texture_probe.servo_noise, 7.0);
  EXPECT_EQ(parameters->stroke.to, 18.0);
  EXPECT_EQ(parameters->hardness_probe.force, 3.0);
  EXPECT_EQ(parameters->press.readings, 4U);
}

TEST(ExploringParameters, UndeclaredKeysAreRefusedWithTheirLocation) {
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"[simulatoin]\nfree = true\n", "simulation"},
      {"[simulation]\nfreee = true\n", "free"},
      {"grasp = 3\n", "[grasp]"},
      {"[grasp]\nthreshold = -1.0\n", "threshold"},
  };
  for (const auto& [text, word] : wrong) {
    const auto refused = read(text);
    ASSERT_FALSE(refused) << text;
    EXPECT_EQ(refused.error().kind, ErrorKind::kUsage) << text;
    EXPECT_TRUE(refused.error().where.starts_with("settings.toml:")) << refused.error().where;
    EXPECT_NE(to_string(refused.error()).find(word), std::string::npos)
        << to_string(refused.error());
  }
}

}  // namespace
}  // namespace somato
