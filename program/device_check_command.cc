#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "commands.h"
#include "device.h"
#include "devices/device_io.h"
#include "terminal.h"
#include "wording.h"

namespace somato::program {
namespace {

using devices::DeviceFile;
using devices::DeviceIo;
using devices::ServoReport;

constexpr double kListening = 2.0;  // s

// What the lines gave while they were polled for a time.
struct Heard {
  double seconds = 0.0;
  std::vector<double> latencies;  // s, of answers of the servos.
  std::uint64_t frames = 0;
  std::uint64_t lost = 0;
  std::uint64_t rejected = 0;
  std::size_t samples = 0;
};

double newest(const DeviceIo& io) {
  double newest = -INFINITY;
  for (const ServoReport& report : io.reports()) newest = std::max(newest, report.time);
  return newest;
}

Heard counted_so_far(const DeviceIo& io) {
  Heard heard;
  if (io.stream() == nullptr) return heard;
  heard.frames = io.stream()->frames();
  heard.lost = io.stream()->lost();
  heard.rejected = io.stream()->rejected();
  return heard;
}

// Polls the servos without moving them.
Result<Heard> listen(const DeviceFile& file, DeviceIo& io) {
  const std::vector<double> nowhere(file.servos.size(), NAN);
  Heard heard;
  SOMATO_TRY_VOID(io.receive());  // What waited is older.
  if (io.samples() != nullptr) io.samples()->keep(0);
  const Heard before = counted_so_far(io);
  const double start = io.now();
  double sent_before = start;
  double last = start;
  while (io.now() < start + kListening && !stop_requested()) {
    const double sent = io.now();
    const double until = sent + file.settings.period;
    SOMATO_TRY_VOID(io.send(nowhere, file.settings.period));
    while (io.now() < until) {
      io.wait(until);
      SOMATO_TRY_VOID(io.receive());
    }
    // A bus may take an answer with its next request only.
    if (newest(io) > last) {
      last = newest(io);
      heard.latencies.push_back(last - (last >= sent ? sent : sent_before));
    }
    sent_before = sent;
    if (io.samples() != nullptr) {
      heard.samples += io.samples()->size();
      io.samples()->keep(0);
    }
  }
  heard.seconds = io.now() - start;
  const Heard after = counted_so_far(io);
  heard.frames = after.frames - before.frames;
  heard.lost = after.lost - before.lost;
  heard.rejected = after.rejected - before.rejected;
  return heard;
}

std::string servo_line(const devices::ServoSettings& servo, const ServoReport& report) {
  std::string line = fmt::format("servo \"{}\": channel {}", servo.name, servo.channel);
  if (std::isnan(report.position)) {
    return line + ", off: its position is unknown, and it will jump to its resting position\n";
  }
  const double position = servo.from_bus(report.position);
  line += fmt::format(", at {:.1f} {} ({:g} on the bus)", position, servo.unit, report.position);
  if (std::isfinite(report.current)) line += fmt::format(", {:.0f} mA", report.current);
  if (report.error != 0) line += fmt::format(", hardware error {:#04x}", report.error);
  // A servo at its limit is measured a little to either side of it.
  const double slack = 0.02 * (servo.most - servo.least);
  if (position < servo.least - slack || position > servo.most + slack) {
    line += ", outside of its limits";
  }
  return line + "\n";
}

std::string servos_text(const DeviceFile& file, const DeviceIo& io, Heard& heard) {
  if (!file.servo_line) return {};
  std::string text = fmt::format("servos: {} at {}, {} bit/s\n", choice_name(file.servo_line->bus),
                                 file.servo_line->port, file.servo_line->baud);
  for (std::size_t i = 0; i < file.servos.size(); ++i) {
    text += servo_line(file.servos[i], io.reports()[i]);
  }
  if (heard.latencies.empty()) return text + "answers: none\n";
  std::sort(heard.latencies.begin(), heard.latencies.end());
  const auto at = [&](double share) {
    return 1e3 * heard.latencies[static_cast<std::size_t>(
                     share * static_cast<double>(heard.latencies.size() - 1))];
  };
  return text + fmt::format("answers: {} within a period, median {:.1f} ms, longest {:.1f} ms\n",
                            heard.latencies.size(), at(0.5), at(1.0));
}

std::string frames_text(const DeviceFile& file, const Heard& heard) {
  std::string text;
  if (file.frame_line) {
    text +=
        fmt::format("frames: {} at {}, {:.1f} per second ({:g} expected), {} lost, {} rejected\n",
                    choice_name(file.frame_line->format), file.frame_line->port,
                    static_cast<double>(heard.frames) / heard.seconds, file.frame_line->rate,
                    heard.lost, heard.rejected);
  }
  if (file.microphone) {
    text += fmt::format("microphone: {}, {:.0f} samples per second ({:g} expected)\n",
                        file.microphone->source, static_cast<double>(heard.samples) / heard.seconds,
                        file.microphone->rate);
  }
  return text;
}

// What an exploration would stop for.
Result<void> judge(const DeviceFile& file, const DeviceIo& io, const Heard& heard) {
  SOMATO_TRY_VOID(io.check_errors());
  if (file.frame_line && heard.frames == 0) {
    return fail(ErrorKind::kSystem, "no valid sensor frame arrived", file.frame_line->port,
                "check the cable, and 'format', 'elements' and 'baud' of [frames]");
  }
  if (file.microphone && heard.samples == 0) {
    return fail(ErrorKind::kSystem, "no samples arrived", file.microphone->source,
                "check the sound device");
  }
  return io.check_fresh(io.now());
}

Result<void> run_check(const Arguments& arguments) {
  SOMATO_TRY(const auto file, read_checked_device(arguments.text("FILE")));
  catch_stop_requests();
  SOMATO_TRY(const auto lines, open_lines(file));
  DeviceIo io(file, *lines);
  const ServoGuard guard(*lines, io.relax_bytes());
  if (arguments.has("reboot")) SOMATO_TRY_VOID(io.reboot());
  SOMATO_TRY_VOID(io.start());
  auto heard = listen(file, io);
  io.relax();
  if (!heard) return fail(std::move(heard.error()));
  fmt::print("device: {}\n{}{}", file.settings.name, servos_text(file, io, *heard),
             frames_text(file, *heard));
  SOMATO_TRY_VOID(judge(file, io, *heard));
  fmt::print("The device can explore.\n");
  return {};
}

}  // namespace

Command device_check_command() {
  return {"device check",
          "Check a device without moving it: ports, servos, sensors, latency",
          {{"FILE", "The device file", true}},
          {{"--reboot", "Restart all servos first, which ends an overload", false, false}},
          {},
          run_check};
}

}  // namespace somato::program
