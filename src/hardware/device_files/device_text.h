#pragma once

#include <string>
#include <string_view>

#include "hardware/device_files/device_file.h"

namespace somato::devices {

/// The text of a device file in which the key of a table, such as "servo.wrist", has the given
/// value in TOML notation; everything else, comments included, is unchanged. A key that is missing
/// is added to its table, and a missing table at the end. `table` is empty for the keys of the file
/// itself.
std::string with_key(std::string_view text, std::string_view table, std::string_view key,
                     std::string_view value);

/// The text of a device file for the same body with servos of another kind: the bus, the speed of
/// its line, and the channels and calibration of all servos. Errors: those of parse_device_file().
Result<std::string> with_bus(std::string_view text, std::string_view where, BusKind bus);

}  // namespace somato::devices
