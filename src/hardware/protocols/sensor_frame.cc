#include "hardware/protocols/sensor_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "hardware/protocols/crc32.h"
#include "hardware/protocols/float_bytes.h"
#include "somato/core/check.h"

namespace somato::wire {
namespace {

constexpr std::size_t kSensorHead = 7;      // type, sequence, time
constexpr std::size_t kSensorChecksum = 4;  // CRC-32
constexpr std::size_t kLongestBlock = 254;  // of bytes without zero
constexpr std::size_t kMostBody = kSensorHead + 4 * kMostSensorValues + kSensorChecksum;

std::size_t width_of(SensorValueType type) {
  return type == SensorValueType::kInt16 ? 2 : 4;
}

std::size_t body_bytes(std::size_t values, SensorValueType type) {
  return kSensorHead + width_of(type) * values + kSensorChecksum;
}

void put_value(float value, std::span<std::uint8_t> bytes) {
  require(!std::isinf(value), "a sensor value is infinite");
  if (bytes.size() == 4) return put_float(value, bytes.first<4>());
  require(!std::isnan(value), "int16 cannot say that a value is missing");
  const float rounded = std::round(value);
  require(rounded >= -32768.0F && rounded <= 32767.0F, "a sensor value exceeds int16");
  put_little_endian(static_cast<std::uint32_t>(static_cast<std::int32_t>(rounded)), bytes);
}

float value_of(std::span<const std::uint8_t> bytes) {
  if (bytes.size() == 4) return float_of(bytes.first<4>());
  return static_cast<std::int16_t>(little_endian(bytes));
}

void put_body(const SensorFrame& frame, std::span<std::uint8_t> body) {
  const std::size_t width = width_of(frame.type);
  body[0] = static_cast<std::uint8_t>(frame.type);
  put_little_endian(frame.sequence, body.subspan(1, 2));
  put_little_endian(frame.microseconds, body.subspan(3, 4));
  for (std::size_t i = 0; i < frame.values.size(); ++i) {
    put_value(frame.values[i], body.subspan(kSensorHead + width * i, width));
  }
  const auto checked = body.first(body.size() - kSensorChecksum);
  put_little_endian(crc32(checked), body.last(kSensorChecksum));
}

// Consistent overhead byte stuffing: each block of bytes without zero is preceded by its length
// plus 1. Returns the number of bytes.
std::size_t stuff(std::span<const std::uint8_t> body, std::span<std::uint8_t> bytes) {
  std::size_t code = 0;
  std::size_t size = 1;
  const auto end_block = [&] {
    bytes[code] = static_cast<std::uint8_t>(size - code);
    code = size++;
  };
  for (const std::uint8_t byte : body) {
    if (byte != 0) bytes[size++] = byte;
    if (byte == 0 || size - code > kLongestBlock) end_block();
  }
  bytes[code] = static_cast<std::uint8_t>(size - code);
  return size;
}

}  // namespace

std::size_t sensor_frame_bytes(std::size_t values, SensorValueType type) {
  const std::size_t body = body_bytes(values, type);
  return body + body / kLongestBlock + 3;
}

std::size_t encode_sensor_frame(const SensorFrame& frame, std::span<std::uint8_t> bytes) {
  require(!frame.values.empty() && frame.values.size() <= kMostSensorValues,
          "a sensor frame has 1 to 1024 values");
  require(bytes.size() >= sensor_frame_bytes(frame.values.size(), frame.type),
          "the memory for a sensor frame is too small");
  std::array<std::uint8_t, kMostBody> memory{};
  const auto body = std::span(memory).first(body_bytes(frame.values.size(), frame.type));
  put_body(frame, body);
  bytes[0] = 0;
  const std::size_t size = stuff(body, bytes.subspan(1));
  bytes[size + 1] = 0;
  return size + 2;
}

SensorFrameDecoder::SensorFrameDecoder(std::size_t values)
    : values_(values), candidate_(values), body_(body_bytes(values, SensorValueType::kFloat32)) {
  require(values > 0 && values <= kMostSensorValues, "a sensor frame has 1 to 1024 values");
  frame_.values = values_;
}

bool SensorFrameDecoder::take(std::uint8_t byte) {
  if (byte == 0) return finish();
  unpack(byte);
  return false;
}

void SensorFrameDecoder::unpack(std::uint8_t byte) {
  empty_ = false;
  if (left_ > 0) {
    --left_;
    return put(byte);
  }
  if (zero_follows_) put(0);
  left_ = byte - std::size_t{1};
  zero_follows_ = left_ < kLongestBlock;
}

// A byte that does not fit is only counted, so that the frame has a wrong length.
void SensorFrameDecoder::put(std::uint8_t byte) {
  if (size_ < body_.size()) body_[size_] = byte;
  ++size_;
}

bool SensorFrameDecoder::finish() {
  if (empty_) return false;
  std::optional<Fault> fault = fault_in_whole();
  if (!fault) fault = read();
  if (fault) {
    ++rejected_;
    fault_ = *fault;
    fault_bytes_ = size_;
  }
  size_ = 0;
  left_ = 0;
  zero_follows_ = false;
  empty_ = true;
  return !fault;
}

std::optional<SensorFrameDecoder::Fault> SensorFrameDecoder::fault_in_whole() const {
  if (left_ > 0 || size_ < kSensorHead + kSensorChecksum) return Fault::kCut;
  const auto type = static_cast<SensorValueType>(body_[0]);
  const bool is_known = type == SensorValueType::kInt16 || type == SensorValueType::kFloat32;
  if (!is_known) return Fault::kType;
  if (size_ > body_.size() || size_ != body_bytes(values_.size(), type)) return Fault::kLength;
  const auto body = std::span(body_).first(size_);
  const bool is_right =
      crc32(body.first(size_ - kSensorChecksum)) == little_endian(body.last(kSensorChecksum));
  return is_right ? std::nullopt : std::optional(Fault::kChecksum);
}

std::optional<SensorFrameDecoder::Fault> SensorFrameDecoder::read() {
  const auto body = std::span<const std::uint8_t>(body_);
  const auto type = static_cast<SensorValueType>(body[0]);
  const std::size_t width = width_of(type);
  for (std::size_t i = 0; i < candidate_.size(); ++i) {
    candidate_[i] = value_of(body.subspan(kSensorHead + width * i, width));
    if (std::isinf(candidate_[i])) return Fault::kInfinite;
  }
  std::copy(candidate_.begin(), candidate_.end(), values_.begin());
  frame_ = {static_cast<std::uint16_t>(little_endian(body.subspan(1, 2))),
            little_endian(body.subspan(3, 4)), type, values_};
  return std::nullopt;
}

std::string SensorFrameDecoder::complaint() const {
  if (rejected_ == 0) return {};
  const std::size_t values = values_.size();
  switch (fault_) {
    case Fault::kCut:
      return fmt::format("the last frame was cut after {} bytes", fault_bytes_);
    case Fault::kLength:
      return fmt::format("the last frame had {} bytes instead of {} or {} for {} values",
                         fault_bytes_, body_bytes(values, SensorValueType::kInt16),
                         body_bytes(values, SensorValueType::kFloat32), values);
    case Fault::kType:
      return "the last frame had an unknown type of values";
    case Fault::kChecksum:
      return "the last frame had a wrong checksum";
    case Fault::kInfinite:
      break;
  }
  return "the last frame had an infinite value";
}

}  // namespace somato::wire
