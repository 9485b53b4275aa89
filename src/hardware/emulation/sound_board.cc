#include "hardware/emulation/sound_board.h"

#include <algorithm>
#include <cmath>

namespace somato::emulation {

void SoundBoard::add(float sample) {
  const float clipped = std::clamp(std::round(sample), -32768.0F, 32767.0F);
  const auto bits = static_cast<std::uint16_t>(static_cast<std::int16_t>(clipped));
  bytes_.push_back(static_cast<std::uint8_t>(bits & 0xFFU));
  bytes_.push_back(static_cast<std::uint8_t>(bits >> 8U));
}

void SoundBoard::advance(double /*now*/, std::vector<std::uint8_t>& sent) {
  sent.insert(sent.end(), bytes_.begin(), bytes_.end());
  bytes_.clear();
}

}  // namespace somato::emulation
