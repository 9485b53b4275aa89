#include "hardware/protocols/anyskin_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "hardware/protocols/float_bytes.h"
#include "somato/core/check.h"

namespace somato::wire {
namespace {

constexpr std::size_t kEnding = 2;  // CR LF
constexpr std::size_t kValues = 4;  // of a magnetometer: temperature, x, y and z

bool is_ending(std::span<const std::uint8_t> bytes) {
  return bytes[0] == '\r' && bytes[1] == '\n';
}

// A window on the stream: the end of the frame before, and a frame.
std::size_t window_bytes(std::size_t magnetometers) {
  return kEnding + anyskin_frame_bytes(magnetometers);
}

}  // namespace

std::size_t encode_anyskin_frame(std::span<const float> values, std::span<std::uint8_t> bytes) {
  require(!values.empty() && values.size() % 4 == 0, "a magnetometer has four values");
  const std::size_t size = anyskin_frame_bytes(values.size() / 4);
  require(bytes.size() >= size, "the memory for an AnySkin frame is too small");
  for (std::size_t i = 0; i < values.size(); ++i) {
    put_float(values[i], bytes.subspan(4 * i).first<4>());
  }
  bytes[size - 2] = '\r';
  bytes[size - 1] = '\n';
  return size;
}

AnySkinDecoder::AnySkinDecoder(std::size_t magnetometers, const AnySkinLimits& limits)
    : limits_(limits),
      values_(4 * magnetometers),
      bytes_(2 * window_bytes(magnetometers)),
      end_(window_bytes(magnetometers)) {
  require(magnetometers > 0, "an AnySkin sensor without magnetometers");
}

std::span<const std::uint8_t> AnySkinDecoder::window() const {
  const std::size_t size = bytes_.size() / 2;
  return std::span(bytes_).subspan(end_ - size, size);
}

void AnySkinDecoder::append(std::uint8_t byte) {
  if (end_ == bytes_.size()) {
    const auto kept = window();
    std::copy(kept.begin(), kept.end(), bytes_.begin());
    end_ = kept.size();
  }
  bytes_[end_++] = byte;
}

bool AnySkinDecoder::take(std::uint8_t byte) {
  const std::size_t frame = 4 * values_.size() + kEnding;
  append(byte);
  ++since_frame_;
  if (byte == '\n' && since_frame_ >= frame && accepts()) {
    since_frame_ = 0;
    take_values();
    return true;
  }
  // A frame with a byte more or less counts once.
  if (since_frame_ > frame && since_frame_ % frame == frame / 2) ++rejected_;
  return false;
}

bool AnySkinDecoder::accepts() {
  if (!is_ending(window().first(kEnding)) || !is_ending(window().last(kEnding))) return false;
  for (std::size_t i = 0; i < values_.size() / kValues; ++i) {
    const std::optional<std::size_t> wrong = implausible(i);
    if (!wrong) continue;
    wrong_ = wrong;
    wrong_value_ = read(*wrong);
    return false;
  }
  return true;
}

bool AnySkinDecoder::has_no_reading(std::size_t magnetometer) const {
  const auto all = [&](auto is_none) {
    return is_none(read(kValues * magnetometer + 1)) && is_none(read(kValues * magnetometer + 2)) &&
           is_none(read(kValues * magnetometer + 3));
  };
  return all([](float field) { return field == 0.0F; }) ||
         all([](float field) { return std::isnan(field); });
}

// A magnetometer without a reading may have no temperature either.
std::optional<std::size_t> AnySkinDecoder::implausible(std::size_t magnetometer) const {
  const std::size_t first = kValues * magnetometer;
  const bool has_none = has_no_reading(magnetometer);
  if (!is_plausible(first) && !(has_none && std::isnan(read(first)))) return first;
  for (std::size_t i = 1; !has_none && i < kValues; ++i) {
    if (!is_plausible(first + i)) return first + i;
  }
  return std::nullopt;
}

void AnySkinDecoder::take_values() {
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const bool is_field = i % kValues != 0;
    values_[i] =
        is_field && has_no_reading(i / kValues) ? std::numeric_limits<float>::quiet_NaN() : read(i);
  }
}

float AnySkinDecoder::read(std::size_t value) const {
  return float_of(window().subspan(kEnding + 4 * value).first<4>());
}

bool AnySkinDecoder::is_plausible(std::size_t value) const {
  const float number = read(value);
  if (value % kValues == 0) {
    return number >= limits_.least_temperature && number <= limits_.most_temperature;
  }
  const float magnitude = std::abs(number);
  return magnitude == 0.0F || (magnitude >= limits_.least_field && magnitude <= limits_.most_field);
}

std::string AnySkinDecoder::complaint() const {
  constexpr std::array<const char*, kValues> kNames{"temperature", "field x", "field y", "field z"};
  if (rejected_ == 0) return {};
  if (!wrong_) {
    return fmt::format("no frame of {} bytes stood between two CR LF",
                       anyskin_frame_bytes(values_.size() / kValues));
  }
  return fmt::format("in the last frame the {} of magnetometer {} was {:g}",
                     kNames.at(*wrong_ % kValues), *wrong_ / kValues + 1, wrong_value_);
}

}  // namespace somato::wire
