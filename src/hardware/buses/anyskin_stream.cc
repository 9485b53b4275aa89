#include "hardware/buses/anyskin_stream.h"

#include <algorithm>

namespace somato::devices {

AnySkinStream::AnySkinStream(std::size_t magnetometers, const wire::AnySkinLimits& limits)
    : SensorStream(3 * magnetometers),
      decoder_(magnetometers, limits),
      temperatures_(magnetometers, std::numeric_limits<float>::quiet_NaN()) {}

void AnySkinStream::receive(std::span<const std::uint8_t> bytes, double now) {
  for (const std::uint8_t byte : bytes) {
    if (!decoder_.take(byte)) continue;
    for (std::size_t i = 0; i < temperatures_.size(); ++i) {
      const auto read = decoder_.values().subspan(4 * i, 4);
      temperatures_[i] = read[0];
      std::copy(read.begin() + 1, read.end(), values_.begin() + static_cast<std::ptrdiff_t>(3 * i));
    }
    end_frame(now);
  }
}

}  // namespace somato::devices
