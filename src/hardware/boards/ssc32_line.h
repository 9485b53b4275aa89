#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace somato::emulation {

/// An SSC-32's interpretation of a line: commands of one type. With mixed types the last wins.
struct Ssc32Line {
  enum class Type {
    kNothing,
    kMove,     ///< Channel, pulse (0: off) and speed (0: not limited); `milliseconds` for all.
    kOffset,   ///< Channel and offset.
    kOutput,   ///< Bank and value.
    kStop,     ///< Channel.
    kPulse,    ///< Queries the pulse of a channel.
    kAnalog,   ///< Queries the analog input `channel`.
    kDigital,  ///< Queries the digital input `channel`.
    kMoving,   ///< Queries whether the last group moves.
    kVersion,
    kWrite,  ///< Writes a register.
    kBoot,
  };
  struct Item {
    int channel = 0;
    int value = 0;
    int speed = 0;
  };

  Type type = Type::kNothing;
  std::vector<Item> items;
  int milliseconds = 0;
};

/// Pulses are clipped at 500 and 2500 us. Empty: the board does not understand the line.
std::optional<Ssc32Line> understood_by_ssc32(std::string_view text);

}  // namespace somato::emulation
