#include "explore/device_scan.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "hardware/device_files/bus_scan.h"
#include "hardware/lines/serial_lines.h"
#include "terminal/terminal.h"
#include "terminal/wording.h"

namespace somato::program {
namespace {

using devices::DeviceFile;
using devices::FoundServo;

const devices::ServoSettings* declared_with(const DeviceFile& file, std::uint8_t id) {
  const auto found = std::ranges::find_if(
      file.servos, [&](const devices::ServoSettings& servo) { return servo.channel == id; });
  return found == file.servos.end() ? nullptr : &*found;
}

std::string line_of(const FoundServo& found, const DeviceFile& file) {
  std::string text = fmt::format("id {}: ", found.id);
  if (!found.model) {
    return text + "an unreadable answer: several servos have this id, or another baud rate\n";
  }
  text += found.name.empty() ? "an unknown model" : found.name;
  text += fmt::format(" ({})", *found.model);
  const auto* const declared = declared_with(file, found.id);
  return text + (declared ? fmt::format(", the servo \"{}\"\n", declared->name)
                          : ", not in the device file\n");
}

// Servos of the file that did not answer.
std::string missing_text(const DeviceFile& file, const std::vector<FoundServo>& found) {
  std::string text;
  for (const devices::ServoSettings& servo : file.servos) {
    const bool answers =
        std::ranges::any_of(found, [&](const FoundServo& one) { return one.id == servo.channel; });
    if (!answers) {
      text += fmt::format("id {}: no answer, the servo \"{}\"\n", servo.channel, servo.name);
    }
  }
  return text;
}

Result<std::vector<FoundServo>> scan_at(const DeviceFile& file, std::size_t baud) {
  SOMATO_TRY(const auto lines,
             wire::SerialLines::open({{file.servo_line->port, baud}}, file.settings.clock,
                                     file.settings.clock_port));
  wire::Exchange exchange(*lines, 0);
  return devices::scan_bus(file.servo_line->bus, exchange, [] { return !stop_requested(); });
}

// Whether a servo answered.
Result<bool> scan_and_print(const DeviceFile& file, std::size_t baud) {
  SOMATO_TRY(const auto found, scan_at(file, baud));
  fmt::print("{} at {}, {} bit/s: {}\n", choice_name(file.servo_line->bus), file.servo_line->port,
             baud, counted(found.size(), "servo"));
  for (const FoundServo& servo : found) fmt::print("{}", line_of(servo, file));
  if (!found.empty()) fmt::print("{}", missing_text(file, found));
  return !found.empty();
}

}  // namespace

Result<void> scan_device(const DeviceFile& file) {
  if (!file.servo_line) {
    return fail(ErrorKind::kUsage, "the device has no servos", "--scan", "omit it");
  }
  const std::size_t own = file.servo_line->baud;
  SOMATO_TRY(const bool answers, scan_and_print(file, own));
  if (answers) return {};
  for (const std::size_t baud : devices::traits_of(file.servo_line->bus).rates) {
    if (baud == own) continue;
    const auto other = scan_and_print(file, baud);
    if (!other && other.error().kind == ErrorKind::kInterrupted) return fail(other.error());
    if (!other) fmt::print("{} bit/s: {}\n", baud, other.error().what);  // The port may refuse it.
    if (!other || !*other) continue;
    fmt::print("Set baud = {} of [servos].\n", baud);
    return {};
  }
  return fail(ErrorKind::kSystem, "no servo answers at any speed", file.servo_line->port,
              "check the power and the cable of the servos, 'port' and 'bus' of [servos]");
}

}  // namespace somato::program
