#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace somato::emulation {

/// What an SSC-32 understands of a line: commands of one type. With mixed types the last wins.
struct Ssc32Line {
  enum class Type {
    kNothing,
    kMove,     ///< Channel, pulse (0: off) and speed (0: not limited); `milliseconds` for all.
    kOffset,   ///< Channel and offset.
    kOutput,   ///< Bank and value.
    kStop,     ///< Channel.
    kPulse,    ///< Asks for the pulse of a channel.
    kAnalog,   ///< Asks for the analog input `channel`.
    kDigital,  ///< Asks for the digital input `channel`.
    kMoving,   ///< Asks whether the last group moves.
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
