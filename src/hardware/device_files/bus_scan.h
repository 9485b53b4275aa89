#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hardware/buses/bus_kind.h"
#include "hardware/lines/exchange.h"
#include "somato/core/result.h"

namespace somato::devices {

/// A servo that answered.
struct FoundServo {
  std::uint8_t id = 0;
  std::optional<unsigned> model;  ///< Its number; none if the answer could not be read.
  std::string name;               ///< The name of the model; empty if it is unknown.
};

/// Requests the model of each possible id, one after the other, and returns the servos that answer,
/// which takes about 13 s. Nothing is written to a servo: none moves, and torques stay as they are.
/// Errors (kUsage): the bus cannot be searched, such as an SSC-32, whose servos have no ids;
/// (kInterrupted): `should_continue` has returned false; (kSystem): the line has hung up.
Result<std::vector<FoundServo>> scan_bus(BusKind kind, wire::Exchange& exchange,
                                         const std::function<bool()>& should_continue);

}  // namespace somato::devices
