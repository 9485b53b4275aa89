#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "flags/command_line.h"
#include "hardware/device_files/device_file.h"
#include "hardware/lines/lines.h"
#include "somato/bodies/explorer.h"
#include "somato/simulation/simulated_explorer.h"

namespace somato::program {

/// The flag `--device`.
Flag device_flag();

/// The flag `--unattended`.
Flag unattended_flag();

/// Errors (kUsage): --unattended without a device, or with names of things.
Result<void> check_unattended(const Arguments& arguments);

/// The servos and sensors of a simulated body. Errors: several bodies.
Result<BodyDescription> describe_body(ExploringBody body);

/// The device file at `path`, checked against the body that it stands for. Errors: kUsage.
Result<devices::DeviceFile> read_checked_device(const std::string& path);

/// The lines of a device, open. Errors: kSystem.
Result<std::unique_ptr<wire::Lines>> open_lines(const devices::DeviceFile& file);

/// While it lives, a signal that ends the program first switches the servos at the first of these
/// lines off.
class ServoGuard {
 public:
  ServoGuard(const wire::Lines& lines, std::span<const std::uint8_t> relax_bytes);
  ServoGuard(const ServoGuard&) = delete;
  ServoGuard(ServoGuard&&) = delete;
  ServoGuard& operator=(const ServoGuard&) = delete;
  ServoGuard& operator=(ServoGuard&&) = delete;
  ~ServoGuard();
};

/// Where a person lets a device move again after a fault: at the terminal, or in a page, which
/// calls Explorer::resume().
enum class PermittedBy { kTerminal, kPage };

/// An explorer of the device `file` at `path`, for the objects or materials of --objects, or of the
/// body that it stands for; the parameters of --settings. Nothing moves before it explores. A
/// person is requested to place each thing, unless an emulator does. With --unattended, one thing
/// without a name is there already, and no person is waited for. `output` names the file
/// beside which the last states of a stopped device are saved. Errors (kUsage): no table of
/// objects; things without the shape that a hand requires; servos that would move unattended.
Result<std::unique_ptr<Explorer>> device_explorer(const Arguments& arguments,
                                                  const std::string& output, PermittedBy permitted);

}  // namespace somato::program
