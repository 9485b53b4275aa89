#pragma once

#include <cstdint>
#include <vector>

#include "hardware/boards/emulated_board.h"

namespace somato::emulation {

/// The microphone of an emulated body: samples of 16 bits, little-endian, as soon as they are
/// there.
class SoundBoard : public EmulatedBoard {
 public:
  /// Appends a sample, in counts; one that 16 bits cannot express is clipped.
  void add(float sample);

  void receive(std::span<const std::uint8_t> /*bytes*/) override {}
  void advance(double now, std::vector<std::uint8_t>& sent) override;
  void restart() override { bytes_.clear(); }

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace somato::emulation
