#pragma once

#include <memory>
#include <string>
#include <utility>

#include "hardware/device_files/device_file.h"
#include "hardware/devices/device_body.h"
#include "hardware/emulation/emulated_body.h"
#include "hardware/emulation/emulated_lines.h"

namespace somato::testing {

/// A body behind emulated boards in the same process: time passes only while its host waits.
struct EmulatedDevice {
  EmulatedDevice(devices::DeviceFile device, std::unique_ptr<Body> simulated)
      : file(std::move(device)),
        body(file, std::move(simulated)),
        lines(body.wires(), [this](double now) { advance(now); }) {}

  /// An event at a moment of the emulation, such as a fault.
  std::function<void(double now)> at;

  devices::DeviceFile file;
  emulation::EmulatedBody body;
  emulation::EmulatedLines lines;
  Result<void> state;  ///< The error of the simulated body, if it had one.

 private:
  void advance(double now) {
    if (at) at(now);
    if (state) state = body.advance(now);
  }
};

}  // namespace somato::testing
