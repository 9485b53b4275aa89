#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "bodies/support/fake_hand.h"
#include "hardware/boards/servo_chain.h"
#include "hardware/device_files/device_text.h"
#include "hardware/emulation/sensor_board.h"
#include "hardware/support/emulated_device.h"

namespace somato::testing {

inline constexpr const char* kFaultyDevice = R"(name = "two fingers"
explore = "closing"
[servos]
bus = "ssc32"
port = "servo port"
[servo.thumb]
channel = 0
zero = 1200
scale = 10
least = 0
most = 60
fastest = 60
[servo.index]
channel = 1
zero = 1900
scale = -10
least = 0
most = 90
fastest = 90
[frames]
format = "frames"
port = "sensor port"
elements = 2
rate = 50
[sensor.touch]
unit = "N"
from = "frames"
elements = ["thumb_1", "index_1"]
[safety]
sensor = "touch"
limit = 8
hold = 0.5
)";

/// Two fingers with taxels, at that bus and with a sensor line of that format.
inline devices::DeviceFile faulty_device(
    devices::BusKind bus, devices::FrameFormat format = devices::FrameFormat::kFrames) {
  std::string text = *devices::with_bus(kFaultyDevice, "d.toml", bus);
  if (format == devices::FrameFormat::kAnyskin) {
    text = devices::with_key(text, "frames", "elements", "3");
    text =
        devices::with_key(text, "sensor.touch", "elements", R"(["thumb_1", "index_1", "index_2"])");
  }
  text = devices::with_key(text, "frames", "format", fmt::format("\"{}\"", choice_name(format)));
  return *devices::parse_device_file(text, "d.toml");
}

inline std::unique_ptr<FakeHand> two_fingers(const devices::DeviceFile& file) {
  auto hand = std::make_unique<FakeHand>("two fingers");
  hand->add_servo({"thumb", "deg", 0.0, 60.0, 600.0}, 0.0);
  hand->add_servo({"index", "deg", 0.0, 90.0, 900.0}, 0.0);
  ChannelDescription touch;
  touch.name = "touch";
  touch.element_names = file.sensors.front().elements;
  hand->add_sensor(touch, [count = touch.element_names.size()](const auto& positions) {
    std::vector<float> forces(count, 0.5F);
    forces[0] = static_cast<float>(positions[0] / 60.0);
    forces[1] = static_cast<float>(positions[1] / 90.0);
    return forces;
  });
  return hand;
}

/// The fingers, and how far a servo was ever driven beyond its limits, in its unit.
class FaultyFingers {
 public:
  explicit FaultyFingers(const devices::DeviceFile& file)
      : FaultyFingers(file, two_fingers(file)) {}

  FaultyFingers(const devices::DeviceFile& file, std::unique_ptr<FakeHand> made)
      : hand(*made), device(file, std::move(made)) {
    device.at = [this](double now) {
      beyond_ = std::max(beyond_, beyond_now());
      if (then_ && now >= moment_) std::exchange(then_, nullptr)();
    };
  }

  FakeHand& hand;
  EmulatedDevice device;

  emulation::WireFaults& servo_line() { return device.body.wires()[0]->faults; }
  emulation::WireFaults& sensor_line() { return device.body.wires()[1]->faults; }
  emulation::EmulatedServos& servos() { return device.body.servos(); }
  emulation::SensorBoard& sensors() {
    return dynamic_cast<emulation::SensorBoard&>(*device.body.sensors());
  }
  double beyond() const { return beyond_; }

  bool are_off() {
    const double until = device.lines.now() + 0.1;
    while (device.lines.now() < until) device.lines.wait(until);
    return !servos().driven_position(0) && !servos().driven_position(1);
  }

  /// Whether the servos measure temperatures and overloads, which tests can cause.
  bool has_chain() { return dynamic_cast<emulation::ServoChain*>(&servos()) != nullptr; }

  emulation::ServoChain& chain() { return dynamic_cast<emulation::ServoChain&>(servos()); }
  void overload(std::size_t servo) { chain().overload(servo); }
  void heat(std::size_t servo, std::uint8_t temperature) { chain().heat(servo, temperature); }

  void at(double moment, std::function<void()> then) {
    moment_ = moment;
    then_ = std::move(then);
  }

 private:
  double beyond_now() {
    double beyond = 0.0;
    for (std::size_t i = 0; i < device.file.servos.size(); ++i) {
      const devices::ServoSettings& servo = device.file.servos[i];
      const auto driven = servos().driven_position(i);
      if (!driven) continue;
      const double position = servo.from_bus(*driven);
      beyond = std::max({beyond, position - servo.most, servo.least - position});
    }
    return beyond;
  }

  double beyond_ = 0.0;
  double moment_ = 0.0;
  std::function<void()> then_;
};

/// A step on the coarsest bus is 0.3 deg.
inline constexpr double kResolution = 0.3;

/// When the body stops after a fault in the middle of a movement, and with what error.
struct Outcome {
  bool stopped = false;
  double after = 0.0;  // s
  Error error;
};

inline Outcome outcome_of(FaultyFingers& fingers, const std::function<void()>& fault) {
  const auto body = devices::DeviceBody::start(fingers.device.file, fingers.device.lines);
  EXPECT_TRUE(body) << to_string(body.error());
  EXPECT_TRUE((*body)->command(std::array{60.0, 90.0}));
  EXPECT_TRUE((*body)->step(0.3));
  const double moment = fingers.device.lines.now() + 0.1;
  fingers.at(moment, fault);
  const auto stepped = (*body)->step(5.0);
  EXPECT_LE(fingers.beyond(), kResolution);
  if (stepped) return {};
  EXPECT_FALSE((*body)->is_on());
  EXPECT_FALSE(stepped.error().advice.empty());
  return {true, fingers.device.lines.now() - moment, stepped.error()};
}

}  // namespace somato::testing
