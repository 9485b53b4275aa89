#include "hardware/device_files/device_text.h"

#include <gtest/gtest.h>

#include "base/files/embedded.h"

namespace somato::devices {
namespace {

const std::string kText = R"(# A hand.
name = "hand"

# The wrist.
[servo.wrist]
zero = 1500  # in us
least = -10

# The index.
[servo.index]
zero = 1400
)";

TEST(DeviceText, ChangesOnlyTheGivenKey) {
  std::string expected = kText;
  expected.replace(expected.find("1500"), 4, "1512");
  EXPECT_EQ(with_key(kText, "servo.wrist", "zero", "1512"), expected);
}

TEST(DeviceText, AddsWhatIsMissingToItsTable) {
  std::string expected = kText;
  expected.insert(expected.find("\n# The index."), "most = 20\n");
  EXPECT_EQ(with_key(kText, "servo.wrist", "most", "20"), expected);
  expected = kText;
  expected.insert(expected.find("\n# The wrist."), "clock = 2\n");
  EXPECT_EQ(with_key(kText, "", "clock", "2"), expected);
  EXPECT_EQ(with_key(kText, "safety", "hold", "1"), kText + "\n[safety]\nhold = 1\n");
}

std::string own_text(const std::string& name) {
  return std::string(somato::detail::embedded_text("devices/" + name + ".toml"));
}

// Every bus can express the limits of every body.
TEST(DeviceText, GivesABodyOtherServos) {
  for (const char* name : {"lucs2", "lucs3", "texture", "hardness"}) {
    for (const auto& [bus, bus_name] : Choices<BusKind>::all()) {
      const auto text = with_bus(own_text(name), name, bus);
      ASSERT_TRUE(text) << to_string(text.error());
      const auto file = parse_device_file(*text, name);
      ASSERT_TRUE(file) << to_string(file.error());
      EXPECT_EQ(file->servo_line->bus, bus);
      EXPECT_EQ(file->servos.size(), own_device_file(name)->servos.size());
    }
  }
}

}  // namespace
}  // namespace somato::devices
