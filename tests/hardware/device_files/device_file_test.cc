#include "hardware/device_files/device_file.h"

#include <gtest/gtest.h>

#include <string>

namespace somato::devices {
namespace {

const std::string kHand = R"(name = "my hand"
explore = "closing"
[servos]
bus = "ssc32"
port = "/dev/ttyUSB0"
[servo.thumb]
channel = 3
zero = 1500
scale = -10
least = -20
most = 60
[servo.index]
channel = 4
least = 0
most = 90
rest = 10
[frames]
port = "/dev/ttyACM0"
elements = 5
[sensor.joints]
unit = "deg"
from = "driver"
servos = ["thumb", "index"]
[sensor.touch]
unit = "N"
from = "frames"
first = 1
gain = 0.5
elements = ["thumb_1..3", "index_1"]
[safety]
sensor = "touch"
limit = 20
)";

std::string with(const std::string& old, const std::string& text) {
  std::string changed = kHand;
  changed.replace(changed.find(old), old.size(), text);
  return changed;
}

std::string error_of(const std::string& text) {
  const auto file = parse_device_file(text, "d.toml");
  if (file) return "none";
  EXPECT_EQ(file.error().kind, ErrorKind::kUsage);
  return to_string(file.error());
}

TEST(DeviceFile, DescribesABody) {
  const auto file = parse_device_file(kHand, "d.toml");
  ASSERT_TRUE(file) << to_string(file.error());
  const BodyDescription body = describe(*file);
  EXPECT_EQ(body.name, "my hand");
  ASSERT_EQ(body.degrees_of_freedom.size(), 2U);
  EXPECT_EQ(body.degrees_of_freedom[0].name, "thumb");
  EXPECT_EQ(body.degrees_of_freedom[0].least, -20.0);
  EXPECT_EQ(body.degrees_of_freedom[1].most, 90.0);
  ASSERT_EQ(body.sensors.size(), 2U);
  EXPECT_EQ(body.sensors[0].element_names, (std::vector<std::string>{"thumb", "index"}));
  EXPECT_EQ(body.sensors[1].element_names,
            (std::vector<std::string>{"thumb_1", "thumb_2", "thumb_3", "index_1"}));
  EXPECT_EQ(file->servos[0].on_bus(60.0), 900.0);
  EXPECT_EQ(file->servos[0].from_bus(900.0), 60.0);
  EXPECT_EQ(file->servos[0].resting(), -20.0);
  EXPECT_EQ(file->servos[1].resting(), 10.0);
}

TEST(DeviceFile, RefusesMistakesWithTheirLine) {
  EXPECT_EQ(error_of(with("channel = 4", "channel = 3")),
            "d.toml:12: 'thumb' and 'index' have the same channel 3; give each servo its own "
            "channel");
  EXPECT_EQ(error_of(with("channel = 4", "channel = 32")),
            "d.toml:12: the bus has no channel 32; use 0 to 31");
  EXPECT_EQ(error_of(with("most = 60", "most = 160")),
            "d.toml:6: the limit 160 deg is -100 on the bus, which goes from 500 to 2500; correct "
            "zero and scale, or narrow the limits");
  EXPECT_EQ(error_of(with("least = -20", "least = 60")),
            "d.toml:6: 'least' must be below 'most'; give the range in which the servo may move");
  EXPECT_EQ(error_of(with("rest = 10", "rest = 91")),
            "d.toml:12: 'rest' is outside of the servo's limits; choose a position from least to "
            "most");
  EXPECT_EQ(error_of(with("first = 1", "first = 2")),
            "d.toml:24: the sensor ends at value 6 of a frame of 5; correct 'first', or the "
            "elements of [frames]");
  EXPECT_EQ(error_of(with("\"thumb\", \"index\"", "\"thumb\", \"indx\"")),
            "d.toml:20: unknown servo 'indx'; did you mean 'index'?");
  EXPECT_EQ(error_of(with("thumb_1..3", "thumb_3..1")),
            "d.toml:29: 'thumb_3..1' is no range of names; write for example "
            "\"finger1_proximal_1..7\"");
  EXPECT_EQ(error_of(with("limit = 20\n", "")),
            "d.toml:30: a limit requires a sensor, and a sensor a limit; write for example sensor "
            "= \"touch\" and limit = 20");
  EXPECT_EQ(error_of(with("from = \"driver\"", "from = \"servos\"")),
            "d.toml:20: the SSC-32 cannot measure positions and currents of servos; use from = "
            "\"driver\", or sensors at another line");
  EXPECT_EQ(error_of(with("[safety]", "[savety]")),
            "d.toml:30: unknown table 'savety'; did you mean 'safety'?");
  EXPECT_EQ(error_of(with("scale = -10", "scael = -10")),
            "d.toml:9: unknown key 'scael'; did you mean 'scale'?");
  EXPECT_EQ(error_of(with("scale = -10", "scale = 0")),
            "d.toml:6: 'scale' must not be 0; give the change on the bus per unit");
  EXPECT_EQ(error_of(with("name = \"my hand\"\n", "")),
            "d.toml:1: 'name' is missing; write for example name = \"my hand\"");
}

TEST(DeviceFile, RefusesLimitsThatAreNoNumbers) {
  for (const std::string value : {"nan", "inf", "-inf"}) {
    for (const std::string key : {"least = -20", "most = 60"}) {
      const std::string name = key.substr(0, key.find(' '));
      const std::string error = error_of(with(key, name + " = " + value));
      EXPECT_TRUE(error.starts_with("d.toml:")) << error;
      EXPECT_NE(error.find("'" + name + "'"), std::string::npos) << error;
    }
  }
}

TEST(DeviceFile, RefusesKeysThatHaveNoEffect) {
  EXPECT_EQ(error_of(with("servos = [\"thumb\", \"index\"]\n",
                          "servos = [\"thumb\", \"index\"]\nfirst = 1\n")),
            "d.toml:24: 'first' has no effect with from = \"driver\"; remove it");
}

TEST(DeviceFile, OwnFilesAreValid) {
  for (const char* name : {"lucs2", "lucs3", "texture", "hardness", "leap", "anyskin"}) {
    const auto file = own_device_file(name);
    EXPECT_TRUE(file) << to_string(file.error());
  }
  EXPECT_EQ(own_device_file("lucs4").error().advice, "did you mean 'lucs2'?");
}

BodyDescription body_of_hand() {
  return describe(*parse_device_file(kHand, "d.toml"));
}

std::string difference(const BodyDescription& body, const std::vector<std::string>& needed = {}) {
  const auto checked = check_against(*parse_device_file(kHand, "d.toml"), body, needed, "d.toml");
  return checked ? "none" : checked.error().what;
}

TEST(DeviceFile, IsCheckedAgainstABody) {
  EXPECT_EQ(difference(body_of_hand()), "none");
  BodyDescription body = body_of_hand();
  body.name = "a hand";
  body.degrees_of_freedom[0].most = 50.0;
  EXPECT_EQ(
      difference(body),
      "the servo 'thumb' may move from -20 to 60 deg, but that of a hand only from -20 to 50");
  body = body_of_hand();
  body.degrees_of_freedom.push_back({"wrist", "deg", -10.0, 10.0, 1.0});
  EXPECT_EQ(difference(body), "my hand has a servo 'wrist', the device does not");
  body = body_of_hand();
  body.degrees_of_freedom.pop_back();
  EXPECT_EQ(difference(body), "my hand has no servo 'index'");
  body = body_of_hand();
  body.sensors[1].unit = "mN";
  EXPECT_EQ(difference(body), "the sensor 'touch' of my hand has the unit mN, not N");
  body = body_of_hand();
  body.sensors[1].element_names[0] = "thumb_0";
  EXPECT_EQ(difference(body), "the elements of the sensor 'touch' are not those of my hand");
  body = body_of_hand();
  body.sensors.push_back({"sound", "", {}, {}, 8192.0, true});
  EXPECT_EQ(difference(body), "none");
  EXPECT_EQ(difference(body, {"sound"}),
            "exploring requires the sensor 'sound', which the device does not have");
}

}  // namespace
}  // namespace somato::devices
