#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hardware/boards/emulated_board.h"
#include "hardware/buses/servo_bus.h"
#include "somato/core/parameter.h"

namespace somato::devices {

/// The kinds of servo buses; traits_of() gives what distinguishes them.
enum class BusKind {
  kSsc32,      ///< Lynxmotion SSC-32: positions are pulse widths in us.
  kDynamixel,  ///< Robotis, protocol 2, X series: 4096 steps per turn.
  kSts,        ///< Feetech STS and SMS: 4096 steps per turn.
  kScs,        ///< Feetech SCS: 1024 steps in 300 degrees.
};

/// A servo of a device file, as its bus and its emulator know it.
struct BusServo {
  std::size_t channel = 0;  ///< Or id.
  double resting = 0.0;     ///< The position between explorations, in the unit of the bus.
};

struct BusInquiry;

/// A kind of bus: all that other rooms know of it. Positions are in the unit of the bus.
struct BusTraits {
  const char* name;   ///< In device files.
  double lowest;      ///< Position.
  double highest;     ///< Position.
  double middle;      ///< Position that `somato emulate` gives the middle of a servo's limits.
  double swing;       ///< Positions between the middle and a limit that is not an angle.
  double per_degree;  ///< Positions.
  std::size_t first_channel;  ///< That `somato emulate` uses: ids of servos begin with 1.
  std::size_t channels;       ///< Channels or ids are below this number.
  std::size_t baud;           ///< The usual rate of the line.
  BusKind kind;
  bool measures;  ///< Whether servos report their positions.

  /// The bus of these servos, of which there is at least one.
  std::unique_ptr<ServoBus> (*bus)(std::span<const BusServo> servos);

  /// The board or servos at the other end of the line, in `somato emulate` and in tests.
  std::unique_ptr<emulation::EmulatedServos> (*emulated)(std::span<const BusServo> servos);

  /// The rates at which servos of that kind can be set to answer, in bit/s.
  std::span<const std::size_t> rates;

  /// The requests of scan_bus(); null if the bus cannot be searched, for the reason of `no_scan`.
  BusInquiry (*inquiry)() = nullptr;
  const char* no_scan = nullptr;
};

const BusTraits& traits_of(BusKind kind);

}  // namespace somato::devices

namespace somato {

template <>
struct Choices<devices::BusKind> {
  static const std::vector<std::pair<devices::BusKind, std::string>>& all();
};

}  // namespace somato
