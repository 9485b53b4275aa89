#include "hardware/protocols/anyskin_frame.h"

#include <algorithm>
#include <cmath>

#include "hardware/protocols/float_bytes.h"
#include "somato/core/check.h"

namespace somato::wire {
namespace {

constexpr std::size_t kEnding = 2;  // CR LF

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
    for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = read(i);
    return true;
  }
  // A frame with a byte more or less counts once.
  if (since_frame_ > frame && since_frame_ % frame == frame / 2) ++rejected_;
  return false;
}

bool AnySkinDecoder::accepts() const {
  if (!is_ending(window().first(kEnding)) || !is_ending(window().last(kEnding))) return false;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    if (!is_plausible(i)) return false;
  }
  return true;
}

float AnySkinDecoder::read(std::size_t value) const {
  return float_of(window().subspan(kEnding + 4 * value).first<4>());
}

bool AnySkinDecoder::is_plausible(std::size_t value) const {
  const float number = read(value);
  if (value % 4 == 0) {
    return number >= limits_.least_temperature && number <= limits_.most_temperature;
  }
  const float magnitude = std::abs(number);
  return magnitude == 0.0F || (magnitude >= limits_.least_field && magnitude <= limits_.most_field);
}

}  // namespace somato::wire
