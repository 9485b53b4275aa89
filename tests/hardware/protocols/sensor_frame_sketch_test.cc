// The sketch examples/arduino/touch_hand/touch_hand.ino, compiled with replacements for the
// functions of an Arduino.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "../../../examples/arduino/touch_hand/sensor_frame_writer.h"  // Outside of the namespace.
#include "hardware/protocols/sensor_frame.h"

namespace sketch {

constexpr int OUTPUT = 1;  // NOLINT(readability-identifier-naming): the names of the Arduino.
constexpr int HIGH = 1;
constexpr int LOW = 0;
constexpr std::uint8_t A0 = 54, A1 = 55, A2 = 56, A3 = 57, A4 = 58, A5 = 59, A6 = 60, A7 = 61,
                       A8 = 62, A9 = 63, A10 = 64, A11 = 65, A12 = 66, A13 = 67;

// The parts connected to the pins.
std::array<int, 70> pins{};
unsigned long clock_in_microseconds = 0;

struct SerialPort {
  void begin(unsigned long baud) { rate = baud; }
  void write(std::uint8_t byte) { bytes.push_back(byte); }
  unsigned long rate = 0;
  std::vector<std::uint8_t> bytes;
} Serial;

void pinMode(int pin, int mode) {
  pins.at(static_cast<std::size_t>(pin)) = mode - OUTPUT;
}
void digitalWrite(int pin, int level) {
  pins.at(static_cast<std::size_t>(pin)) = level;
}
void delayMicroseconds(unsigned /*time*/) {}
unsigned long micros() {
  return clock_in_microseconds & 0xFFFFFFFF;
}

// A touch sensor reads 100 for each multiplexer and 1 for each input; a potentiometer 900 and more.
int analogRead(int pin) {
  const int input = pins[22] + 2 * pins[23] + 4 * pins[24] + 8 * pins[25];
  return pin <= A2 ? 100 * (pin - A0) + input : 900 + (pin - A3);
}

#include "../../../examples/arduino/touch_hand/touch_hand.ino"

}  // namespace sketch

namespace somato::wire {
namespace {

TEST(TouchHandSketch, SendsFramesOfAllSensorsAtItsRate) {
  sketch::clock_in_microseconds = 4'294'500'000;  // It begins anew after 467,296 us.
  sketch::setup();
  EXPECT_EQ(sketch::Serial.rate, 115'200U);
  SensorFrameDecoder decoder(56);
  std::size_t frames = 0;
  for (int i = 0; i < 1000; ++i, sketch::clock_in_microseconds += 1000) {
    sketch::loop();
    for (const std::uint8_t byte : sketch::Serial.bytes) frames += decoder.take(byte) ? 1 : 0;
    sketch::Serial.bytes.clear();
  }
  EXPECT_EQ(frames, 50U);
  EXPECT_EQ(decoder.rejected(), 0U);
  EXPECT_EQ(decoder.frame().sequence, 49);
  EXPECT_EQ(decoder.frame().microseconds, 980'000U - 467'296U);
  const auto values = decoder.frame().values;
  for (int i = 0; i < 45; ++i) {
    EXPECT_EQ(values[static_cast<std::size_t>(i)], static_cast<float>(100 * (i / 15) + i % 15))
        << i;
  }
  for (int i = 0; i < 11; ++i) {
    EXPECT_EQ(values[static_cast<std::size_t>(45 + i)], static_cast<float>(900 + i)) << i;
  }
}

}  // namespace
}  // namespace somato::wire
