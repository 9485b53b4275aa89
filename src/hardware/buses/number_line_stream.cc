#include "hardware/buses/number_line_stream.h"

#include <algorithm>

namespace somato::devices {

NumberLineStream::NumberLineStream(std::size_t values, const std::vector<wire::LineName>& names)
    : SensorStream(values), decoder_(values, names) {}

void NumberLineStream::receive(std::span<const std::uint8_t> bytes, double now) {
  for (const std::uint8_t byte : bytes) {
    if (!decoder_.take(byte)) continue;
    std::copy(decoder_.values().begin(), decoder_.values().end(), values_.begin());
    end_frame(now);
  }
}

}  // namespace somato::devices
