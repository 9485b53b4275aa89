#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"

namespace somato::devices {

/// The kinds of servo buses; traits_of() gives what distinguishes them.
enum class BusKind {
  kSsc32,      ///< Lynxmotion SSC-32: positions are pulse widths in us.
  kDynamixel,  ///< Robotis, protocol 2, X series: 4096 steps per turn.
  kSts,        ///< Feetech STS and SMS: 4096 steps per turn.
  kScs,        ///< Feetech SCS: 1024 steps in 300 degrees.
};

/// A kind of bus, as far as device files depend on it. Positions are in the unit of the bus.
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
};

const BusTraits& traits_of(BusKind kind);

}  // namespace somato::devices

namespace somato {

template <>
struct Choices<devices::BusKind> {
  static const std::vector<std::pair<devices::BusKind, std::string>>& all();
};

}  // namespace somato
