#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "explore/device.h"
#include "explore/device_scan.h"
#include "flags/commands.h"
#include "hardware/device_files/device_file.h"
#include "hardware/devices/device_io.h"
#include "hardware/devices/sensor_reader.h"
#include "somato/recording/element_ranges.h"
#include "terminal/still_elements.h"
#include "terminal/terminal.h"
#include "terminal/wording.h"

namespace somato::program {
namespace {

using devices::DeviceFile;
using devices::DeviceIo;
using devices::SensorOrigin;
using devices::ServoReport;

constexpr double kListening = 2.0;     // s
constexpr double kLateSamples = 0.35;  // s; ALSA's recorder writes blocks of 0.125 s

// The traffic of the lines while they are polled for a time.
struct Traffic {
  double seconds = 0.0;
  std::vector<double> latencies;  // s, of answers of the servos.
  std::uint64_t frames = 0;
  std::uint64_t lost = 0;
  std::uint64_t rejected = 0;
  double sample_rate = 0.0;
  double silence = 0.0;                // s since the last samples.
  std::vector<ElementRanges> sensors;  // In the order of the device file.
};

double newest(const DeviceIo& io) {
  double newest = -INFINITY;
  for (const ServoReport& report : io.reports()) newest = std::max(newest, report.time);
  return newest;
}

Traffic counted_so_far(const DeviceIo& io) {
  Traffic traffic;
  if (io.stream() == nullptr) return traffic;
  traffic.frames = io.stream()->frames();
  traffic.lost = io.stream()->lost();
  traffic.rejected = io.stream()->rejected();
  return traffic;
}

// Takes each frame of the sensor line once; servos are taken once a period.
class SensorWatch {
 public:
  SensorWatch(const DeviceFile& file, std::vector<ElementRanges>& ranges)
      : file_(file), reader_(file), resting_(file.servos.size(), NAN), ranges_(ranges) {
    ranges_.resize(file.sensors.size());
    reader_.prepare(readings_);
  }

  void take_frame(const DeviceIo& io) {
    if (io.stream() == nullptr || io.stream()->frames() == frames_) return;
    frames_ = io.stream()->frames();
    add(io, [](SensorOrigin from) { return from == SensorOrigin::kFrames; });
  }

  void take_servos(const DeviceIo& io) {
    add(io, [](SensorOrigin from) {
      return from == SensorOrigin::kServos || from == SensorOrigin::kCurrents;
    });
  }

 private:
  template <typename Selected>
  void add(const DeviceIo& io, const Selected& selected) {
    reader_.read(io, resting_, readings_);
    for (std::size_t i = 0; i < ranges_.size(); ++i) {
      if (selected(file_.sensors[i].from)) ranges_[i].add(readings_[i].values(), {});
    }
  }

  const DeviceFile& file_;
  devices::SensorReader reader_;
  std::vector<double> resting_;
  std::vector<Matrix<float>> readings_;
  std::vector<ElementRanges>& ranges_;
  std::size_t frames_ = 0;
};

// Polls the servos without moving them.
Result<Traffic> listen(const DeviceFile& file, DeviceIo& io) {
  const std::vector<double> nowhere(file.servos.size(), NAN);
  Traffic traffic;
  SensorWatch watch(file, traffic.sensors);
  SOMATO_TRY_VOID(io.wait_for_samples());
  SOMATO_TRY_VOID(io.receive());  // Older input is discarded.
  if (io.sound() != nullptr) io.sound()->begin();
  const Traffic before = counted_so_far(io);
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
      watch.take_frame(io);
    }
    watch.take_servos(io);
    // A bus may take an answer with its next request only.
    if (newest(io) > last) {
      last = newest(io);
      traffic.latencies.push_back(last - (last >= sent ? sent : sent_before));
    }
    sent_before = sent;
  }
  traffic.seconds = io.now() - start;
  if (io.sound() != nullptr) {
    traffic.sample_rate = io.sound()->rate();
    traffic.silence = io.sound()->age(io.now());
  }
  const Traffic after = counted_so_far(io);
  traffic.frames = after.frames - before.frames;
  traffic.lost = after.lost - before.lost;
  traffic.rejected = after.rejected - before.rejected;
  return traffic;
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

std::string servos_text(const DeviceFile& file, const DeviceIo& io, Traffic& traffic) {
  if (!file.servo_line) return {};
  std::string text = fmt::format("servos: {} at {}, {} bit/s\n", choice_name(file.servo_line->bus),
                                 file.servo_line->port, file.servo_line->baud);
  for (std::size_t i = 0; i < file.servos.size(); ++i) {
    text += servo_line(file.servos[i], io.reports()[i]);
  }
  if (traffic.latencies.empty()) return text + "answers: none\n";
  std::sort(traffic.latencies.begin(), traffic.latencies.end());
  const auto at = [&](double share) {
    return 1e3 * traffic.latencies[static_cast<std::size_t>(
                     share * static_cast<double>(traffic.latencies.size() - 1))];
  };
  return text + fmt::format("answers: {} within a period, median {:.1f} ms, longest {:.1f} ms\n",
                            traffic.latencies.size(), at(0.5), at(1.0));
}

std::string frames_text(const DeviceFile& file, const Traffic& traffic) {
  std::string text;
  if (file.frame_line) {
    text +=
        fmt::format("frames: {} at {}, {:.1f} per second ({:g} expected), {} lost, {} rejected\n",
                    choice_name(file.frame_line->format), file.frame_line->port,
                    static_cast<double>(traffic.frames) / traffic.seconds, file.frame_line->rate,
                    traffic.lost, traffic.rejected);
  }
  if (file.microphone) {
    text += fmt::format("microphone: {}, {:.0f} samples per second ({:g} expected)\n",
                        file.microphone->source, traffic.sample_rate, file.microphone->rate);
  }
  return text;
}

// A hand at rest, and a sensor with coarse steps that is not touched, may well not change.
std::string sensors_text(const DeviceFile& file, const Traffic& traffic) {
  std::string text;
  for (std::size_t i = 0; i < file.sensors.size(); ++i) {
    const devices::SensorSettings& sensor = file.sensors[i];
    text += text_of(still_elements(traffic.sensors[i].elements()), sensor.elements,
                    fmt::format("sensor \"{}\": ", sensor.name));
  }
  return text;
}

// Returns the error for which an exploration would stop.
Result<void> judge(const DeviceFile& file, DeviceIo& io, const Traffic& traffic) {
  SOMATO_TRY_VOID(io.check_errors());
  if (file.frame_line && traffic.frames == 0) {
    return fail(ErrorKind::kSystem, io.with_complaint("no valid sensor frame arrived"),
                file.frame_line->port,
                "check the cable, and 'format', 'elements' and 'baud' of [frames]");
  }
  if (file.microphone && (traffic.sample_rate == 0.0 || traffic.silence > kLateSamples)) {
    return fail(ErrorKind::kSystem, fmt::format("no samples arrived for {:.1f} s", traffic.silence),
                file.microphone->source, "check the sound device");
  }
  if (file.microphone) SOMATO_TRY_VOID(io.sound()->check_rate());
  return io.check_fresh(io.now());
}

Result<void> run_check(const Arguments& arguments) {
  SOMATO_TRY(const auto file, read_checked_device(arguments.text("FILE")));
  catch_stop_requests();
  if (arguments.has("scan") && arguments.has("reboot")) {
    return fail(ErrorKind::kUsage, "has no effect with --scan", "--reboot", "omit one of them");
  }
  if (arguments.has("scan")) return scan_device(file);
  SOMATO_TRY(const auto lines, open_lines(file));
  DeviceIo io(file, *lines);
  const ServoGuard guard(*lines, io.relax_bytes());
  if (arguments.has("reboot")) SOMATO_TRY_VOID(io.reboot());
  SOMATO_TRY_VOID(io.start());
  auto traffic = listen(file, io);
  io.relax();
  if (!traffic) return fail(std::move(traffic.error()));
  fmt::print("device: {}\n{}{}{}", file.settings.name, servos_text(file, io, *traffic),
             frames_text(file, *traffic), sensors_text(file, *traffic));
  SOMATO_TRY_VOID(judge(file, io, *traffic));
  fmt::print("The device can explore.\n");
  return {};
}

std::vector<KeySection> key_sections_of_devices() {
  return {
      {"Device files",
       "A hand or probe at serial lines ([your hand](../your-hand.md)). These keys stand before "
       "the tables:",
       {key_table<devices::DeviceSettings>("device"),
        key_table<devices::ServoLine>("`[servos]`",
                                      "The lines, the servos, the sensors and the safety:"),
        key_table<devices::ServoSettings>("`[servo.NAME]`"),
        key_table<devices::FrameLine>("`[frames]`"),
        key_table<devices::SensorSettings>("`[sensor.NAME]`"),
        key_table<devices::MicrophoneSettings>("`[microphone]`"),
        key_table<devices::SafetySettings>("`[safety]`")}}};
}

}  // namespace

Command device_check_command() {
  return {"device check",
          "Check a device without moving it: ports, servos, sensors, latency",
          {{"FILE", "The device file", true}},
          {{"--reboot", "Restart all servos first, which ends an overload", false, false},
           {"--scan",
            "Only list the servos that answer at the servo line, with their ids, models and baud "
            "rate",
            false, false}},
          {},
          run_check,
          {},
          key_sections_of_devices};
}

}  // namespace somato::program
