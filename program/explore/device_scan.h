#pragma once

#include "hardware/device_files/device_file.h"
#include "somato/core/result.h"

namespace somato::program {

/// Prints the servos that answer at the servo line of the device, at its own speed, or if none does
/// at the other speeds of such servos. Nothing moves. Errors: kUsage if the device has no servos
/// with ids; kSystem if none answers at any speed.
Result<void> scan_device(const devices::DeviceFile& file);

}  // namespace somato::program
