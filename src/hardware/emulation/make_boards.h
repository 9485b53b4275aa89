#pragma once

#include <memory>

#include "hardware/device_files/device_file.h"
#include "hardware/emulation/emulated_board.h"

namespace somato::emulation {

/// The emulated servos of a device file, in its order.
std::unique_ptr<EmulatedServos> make_servos(const devices::DeviceFile& file);

/// The emulated sensor board of a device file.
std::unique_ptr<EmulatedSensors> make_sensors(const devices::FrameLine& line);

}  // namespace somato::emulation
