#include "hardware/emulation/sensor_board.h"

#include <algorithm>
#include <cmath>

#include "hardware/protocols/anyskin_frame.h"
#include "hardware/protocols/number_line.h"
#include "somato/core/check.h"

namespace somato::emulation {
namespace {

using devices::FrameFormat;

SensorBoardSettings checked_settings(const SensorBoardSettings& settings) {
  require(settings.elements > 0, "a sensor board without elements");
  require(settings.rate > 0.0 && std::isfinite(settings.rate), "the rate must be positive");
  require(settings.format != FrameFormat::kAnyskin || settings.elements % 3 == 0,
          "a magnetometer has three elements");
  require(settings.format != FrameFormat::kFrames || settings.elements <= wire::kMostSensorValues,
          "a sensor frame has 1 to 1024 values");
  return settings;
}

std::size_t most_bytes(const SensorBoardSettings& settings) {
  switch (settings.format) {
    case FrameFormat::kAnyskin:
      return wire::anyskin_frame_bytes(settings.elements / 3);
    case FrameFormat::kLines:
      return wire::kMostNumberBytes * settings.elements;
    case FrameFormat::kFrames:
      break;
  }
  return wire::sensor_frame_bytes(settings.elements, settings.values);
}

}  // namespace

SensorBoard::SensorBoard(const SensorBoardSettings& settings)
    : settings_(checked_settings(settings)),
      values_(settings.elements),
      faults_(settings.elements),
      bytes_(most_bytes(settings)) {
  reported_.reserve(4 * settings.elements);
}

void SensorBoard::receive(std::span<const std::uint8_t> /*bytes*/) {}

// The addend sends a frame at its time in spite of rounding.
void SensorBoard::advance(double now, std::vector<std::uint8_t>& sent) {
  require(now >= now_, "the time of an emulated board went back");
  now_ = now;
  const double due = std::floor((now_ - switched_on_) * settings_.rate + 1e-6);
  while (static_cast<double>(frames_) < due) {
    send(static_cast<double>(frames_ + 1) / settings_.rate, sent);
    ++frames_;
  }
}

void SensorBoard::send(double time, std::vector<std::uint8_t>& sent) {
  const std::size_t size = encode(time);
  sent.insert(sent.end(), bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(size));
}

std::size_t SensorBoard::encode(double time) {
  if (settings_.format == FrameFormat::kAnyskin) return encode_anyskin();
  reported_.clear();
  for (std::size_t i = 0; i < values_.size(); ++i) reported_.push_back(reported(i));
  if (settings_.format == FrameFormat::kLines) return wire::encode_number_line(reported_, bytes_);
  return encode_frame(time);
}

std::size_t SensorBoard::encode_anyskin() {
  reported_.clear();
  for (std::size_t i = 0; i < values_.size(); ++i) {
    if (i % 3 == 0) reported_.push_back(settings_.temperature);
    reported_.push_back(reported(i));
  }
  return wire::encode_anyskin_frame(reported_, bytes_);
}

std::size_t SensorBoard::encode_frame(double time) {
  if (settings_.values == wire::SensorValueType::kInt16) {
    for (float& value : reported_) value = std::clamp(value, -32768.0F, 32767.0F);
  }
  const auto microseconds = static_cast<std::uint64_t>(std::round(time * 1e6));
  return wire::encode_sensor_frame(
      {static_cast<std::uint16_t>(frames_), static_cast<std::uint32_t>(microseconds),
       settings_.values, reported_},
      bytes_);
}

void SensorBoard::restart() {
  switched_on_ = now_;
  frames_ = 0;
}

void SensorBoard::set_values(std::span<const float> values) {
  require(values.size() == values_.size(), "as many values as elements are required");
  std::copy(values.begin(), values.end(), values_.begin());
}

float SensorBoard::reported(std::size_t element) const {
  return faults_[element].value_or(values_[element]);
}

void SensorBoard::stick(std::size_t element) {
  faults_.at(element) = reported(element);
}

void SensorBoard::kill(std::size_t element) {
  faults_.at(element) = 0.0F;
}

void SensorBoard::repair(std::size_t element) {
  faults_.at(element).reset();
}

}  // namespace somato::emulation
