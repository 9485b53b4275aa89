#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "explore/device.h"
#include "flags/commands.h"
#include "hardware/devices/device_io.h"
#include "hardware/devices/sensor_reader.h"
#include "terminal/terminal.h"

namespace somato::program {
namespace {

using devices::DeviceFile;
using devices::DeviceIo;

constexpr double kInterval = 0.1;  // s between two pictures

std::string values_of(const devices::SensorSettings& sensor, const Matrix<float>& reading) {
  std::string text = fmt::format("{}", sensor.name);
  if (!sensor.unit.empty()) text += fmt::format(" [{}]", sensor.unit);
  for (const float value : reading.values()) text += fmt::format(" {:.4g}", value);
  return text;
}

std::string picture_of(const DeviceFile& file, const DeviceIo& io,
                       const std::vector<Matrix<float>>& readings) {
  std::string text;
  for (std::size_t i = 0; i < file.servos.size(); ++i) {
    const devices::ServoSettings& servo = file.servos[i];
    const devices::ServoReport& report = io.reports()[i];
    if (std::isnan(report.position)) continue;
    text +=
        fmt::format("{} [{}] {:.1f}\n", servo.name, servo.unit, servo.from_bus(report.position));
  }
  for (std::size_t i = 0; i < file.sensors.size(); ++i) {
    if (file.sensors[i].from == devices::SensorOrigin::kMicrophone) continue;
    text += values_of(file.sensors[i], readings[i]) + "\n";
  }
  return text;
}

// Rewrites the picture on a terminal; in a pipe, pictures follow each other.
void show(const std::string& picture) {
  const bool is_terminal = isatty(STDOUT_FILENO) == 1;
  fmt::print("{}{}", is_terminal ? "\033[H\033[J" : "", picture);
  std::fflush(stdout);
}

// The last line of a board that prints text, valid or not, and why a frame was rejected.
std::string line_text(const DeviceIo& io) {
  if (io.stream() == nullptr) return {};
  const std::string line = io.stream()->last_line();
  std::string text = line.empty() ? std::string() : fmt::format("line {}\n", line);
  if (io.stream()->rejected() == 0) return text;
  return text + fmt::format("rejected {}: {}\n", io.stream()->rejected(), io.stream()->complaint());
}

Result<void> watch(const DeviceFile& file, DeviceIo& io, double seconds) {
  const devices::SensorReader reader(file);
  std::vector<Matrix<float>> readings;
  reader.prepare(readings);
  const std::vector<double> nowhere(file.servos.size(), NAN);
  std::vector<double> positions(file.servos.size(), 0.0);
  for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = file.servos[i].resting();
  const double end = io.now() + seconds;
  for (double shown = io.now(); io.now() < end && !stop_requested();) {
    const double until = io.now() + file.settings.period;
    SOMATO_TRY_VOID(io.send(nowhere, file.settings.period));
    while (io.now() < until) {
      io.wait(until);
      SOMATO_TRY_VOID(io.receive());
    }
    if (io.samples() != nullptr) io.samples()->keep(0);
    const bool has_frame = io.stream() == nullptr || io.stream()->frames() > 0;
    // Without a valid frame, a person looks for the reason in what arrives.
    if (has_frame) SOMATO_TRY_VOID(io.check_fresh(io.now()));
    if (io.now() < shown + kInterval) continue;
    shown = io.now();
    reader.read(io, positions, readings);
    show(line_text(io) + (has_frame ? picture_of(file, io, readings) : std::string()));
  }
  return {};
}

Result<void> check_frames(const DeviceFile& file, const DeviceIo& io) {
  if (io.stream() == nullptr || io.stream()->frames() > 0 || stop_requested()) return {};
  return fail(ErrorKind::kSystem, io.with_complaint("no valid sensor frame arrived"),
              file.frame_line->port,
              "check the cable, and 'format', 'elements' and 'baud' of [frames]");
}

Result<void> run_monitor(const Arguments& arguments) {
  SOMATO_TRY(const auto file, read_checked_device(arguments.text("FILE")));
  SOMATO_TRY(const auto seconds, arguments.number("seconds", 1));
  catch_stop_requests();
  SOMATO_TRY(const auto lines, open_lines(file));
  DeviceIo io(file, *lines);
  const ServoGuard guard(*lines, io.relax_bytes());
  SOMATO_TRY_VOID(io.start());
  auto watched = watch(file, io, seconds ? static_cast<double>(*seconds) : INFINITY).and_then([&] {
    return check_frames(file, io);
  });
  io.relax();
  return watched;
}

}  // namespace

Command device_monitor_command() {
  return {"device monitor",
          "Show what the servos and sensors of a device measure, without moving it",
          {{"FILE", "The device file", true}},
          {{"--seconds", "Duration. Default: until Ctrl-C"}},
          {},
          run_monitor};
}

}  // namespace somato::program
