#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "hardware/boards/emulated_board.h"
#include "hardware/protocols/frame_format.h"
#include "hardware/protocols/sensor_frame.h"

namespace somato::emulation {

struct SensorBoardSettings {
  devices::FrameFormat format = devices::FrameFormat::kFrames;
  std::size_t elements = 1;
  double rate = 100.0;        ///< Frames a second.
  float temperature = 25.0F;  ///< Degrees Celsius; AnySkin only.

  /// The values of the format `frames`; int16 are rounded and clipped.
  wire::SensorValueType values = wire::SensorValueType::kFloat32;
};

/// A board that sends frames at its own rate, the first one period after it was switched on.
class SensorBoard : public EmulatedSensors {
 public:
  explicit SensorBoard(const SensorBoardSettings& settings);

  /// Ignored: the board only sends.
  void receive(std::span<const std::uint8_t> bytes) override;

  void advance(double now, std::vector<std::uint8_t>& sent) override;

  /// Sequence and clock begin at 0. Values and faults, which are those of the sensors, remain.
  void restart() override;

  void set_values(std::span<const float> values) override;

  /// From now on the element keeps its value.
  void stick(std::size_t element);

  /// From now on the element reports 0.
  void kill(std::size_t element);

  /// Ends the element's fault.
  void repair(std::size_t element);

  /// Frames sent since the board was switched on.
  std::uint64_t frames() const { return frames_; }

 private:
  void send(double time, std::vector<std::uint8_t>& sent);
  std::size_t encode(double time);
  std::size_t encode_anyskin();
  std::size_t encode_frame(double time);
  float reported(std::size_t element) const;

  SensorBoardSettings settings_;
  std::vector<float> values_;
  std::vector<std::optional<float>> faults_;  // The values that faulty elements report.
  std::vector<float> reported_;
  std::vector<std::uint8_t> bytes_;
  double switched_on_ = 0.0;
  double now_ = 0.0;
  std::uint64_t frames_ = 0;
};

}  // namespace somato::emulation
