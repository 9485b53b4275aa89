#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include "base/files/embedded.h"
#include "base/files/whole_file.h"
#include "bodies/explorers/simulated_body.h"
#include "explore/device.h"
#include "explore/explore_table.h"
#include "flags/commands.h"
#include "hardware/device_files/device_text.h"
#include "hardware/devices/device_lines.h"
#include "hardware/emulation/pty_emulator.h"
#include "somato/bodies/object_table.h"
#include "terminal/terminal.h"

namespace somato::program {
namespace {

using devices::BusKind;
using devices::DeviceFile;
using emulation::PtyEmulator;

struct EmulationRequest {
  ExploringBody body = ExploringBody::kLucs2;
  std::string text;  // The text of the device file.
  DeviceFile file;
  ObjectTable things;
  std::uint64_t seed = 1;
  std::optional<double> clock;  // Empty: that of the host.
  std::string first;
};

std::vector<std::string> names_of_things(ExploringBody body, const ObjectTable& things) {
  std::vector<std::string> names;
  const bool is_hand = body == ExploringBody::kLucs2 || body == ExploringBody::kLucs3;
  if (is_hand) {
    for (const Object& object : things.objects) names.push_back(object.name);
  } else {
    for (const Material& material : things.materials) names.push_back(material.name);
  }
  return names;
}

// A device file of the user, or the one that comes with the program.
Result<std::string> device_text(const Arguments& arguments, ExploringBody body) {
  if (arguments.has("device")) return read_whole(arguments.text("device"));
  const std::string path = "devices/" + choice_name(body) + ".toml";
  for (const detail::EmbeddedFile& file : detail::embedded_files()) {
    if (file.path == path) return std::string(file.text);
  }
  return fail(ErrorKind::kUsage, "only one body can be emulated at a time", choice_name(body),
              "use lucs2, lucs3, texture or hardness");
}

Result<std::optional<double>> read_clock(const Arguments& arguments) {
  if (!arguments.has("clock")) return 1.0;
  if (arguments.text("clock") == "host") return std::optional<double>();
  devices::DeviceSettings settings;
  const auto clock = devices::DeviceSettings::declarations().find("clock");
  auto read = clock->assign(settings, value_from_text(clock->info, arguments.text("clock")));
  if (read) return settings.clock;
  read.error().where = "--clock";
  read.error().advice = "give a number from 0.01 to 1000, or 'host'";
  return fail(std::move(read.error()));
}

Result<EmulationRequest> read_emulation(const Arguments& arguments) {
  EmulationRequest request;
  SOMATO_TRY(request.body, read_body(arguments));
  SOMATO_TRY(request.text, device_text(arguments, request.body));
  const std::string where = arguments.has("device") ? arguments.text("device") : "devices";
  if (arguments.has("bus")) {
    SOMATO_TRY(const auto bus, choice_named<BusKind>("bus", arguments.text("bus"), "--bus"));
    SOMATO_TRY(request.text, devices::with_bus(request.text, where, bus));
  }
  SOMATO_TRY(request.file, devices::parse_device_file(request.text, where));
  SOMATO_TRY(const auto description, describe_body(request.body));
  SOMATO_TRY_VOID(devices::check_against(request.file, description, {}, where));
  SOMATO_TRY(request.things, arguments.has("objects") ? read_object_table(arguments.text("objects"),
                                                                          declared_materials())
                                                      : default_things(request.body));
  SOMATO_TRY(const auto seed, arguments.number("seed", 0));
  request.seed = seed.value_or(1);
  SOMATO_TRY(request.clock, read_clock(arguments));
  const std::vector<std::string> names = names_of_things(request.body, request.things);
  if (names.empty()) {
    return fail(ErrorKind::kUsage, "the table has nothing for this body", arguments.text("objects"),
                "add tables such as [object.cup] or [material.cork]");
  }
  request.first = names.front();
  return request;
}

PtyEmulator::MakeBody make_bodies(const EmulationRequest& request) {
  return [request](const std::string& thing, std::size_t trial) -> Result<std::unique_ptr<Body>> {
    const std::vector<std::string> names = names_of_things(request.body, request.things);
    const auto found = std::find(names.begin(), names.end(), thing);
    if (found == names.end()) return fail(unknown_name("thing", thing, {}, names));
    return simulated_body(request.body, request.things, {}, request.seed,
                          static_cast<std::size_t>(found - names.begin()), trial);
  };
}

std::string with_clock(std::string text, const EmulationRequest& request,
                       const PtyEmulator& emulator) {
  if (!request.clock) {
    return devices::with_key(text, "", "clock_port", fmt::format("\"{}\"", emulator.clock_port()));
  }
  text = devices::with_key(text, "", "clock", fmt::format("{:g}", *request.clock));
  if (!request.file.settings.clock_port.empty()) {
    text = devices::with_key(text, "", "clock_port", R"("")");
  }
  // Seconds of the machine, whatever the emulation's: a hand must not move blind for longer.
  constexpr double kPatience = 0.06;
  const double periods = std::ceil(kPatience * *request.clock / request.file.settings.period);
  const auto missed = std::max(static_cast<double>(request.file.safety.missed), periods);
  return devices::with_key(text, "safety", "missed", fmt::format("{:.0f}", missed));
}

// The device file with the ports of the emulator.
std::string with_ports(const EmulationRequest& request, const PtyEmulator& emulator) {
  const auto quoted = [](const std::string& text) { return fmt::format("\"{}\"", text); };
  const devices::DeviceLines lines(request.file);
  std::string text = request.text;
  text = devices::with_key(text, "", "placing", quoted(emulator.placing_port()));
  text = with_clock(std::move(text), request, emulator);
  const auto& ports = emulator.ports();
  if (lines.servos) text = devices::with_key(text, "servos", "port", quoted(ports[*lines.servos]));
  if (lines.frames) text = devices::with_key(text, "frames", "port", quoted(ports[*lines.frames]));
  if (lines.microphone) {
    text =
        devices::with_key(text, "microphone", "source", quoted("raw:" + ports[*lines.microphone]));
  }
  return text;
}

Result<void> run_emulate(const Arguments& arguments) {
  SOMATO_TRY(const auto request, read_emulation(arguments));
  SOMATO_TRY(const auto emulator,
             PtyEmulator::create(request.file, request.clock, request.first, make_bodies(request)));
  const std::string path = arguments.text("output");
  SOMATO_TRY_VOID(save_whole(path, with_ports(request, *emulator)));
  catch_stop_requests();
  fmt::print(
      "The emulated device is described by {0}. For example, in another terminal:\n"
      "somato device check {0}\n"
      "somato explore --device {0} -o recording.mcap\n",
      path);
  std::fflush(stdout);
  std::fputs("Press Ctrl-C to end the emulation.\n", stderr);
  SOMATO_TRY_VOID(emulator->run([] { return !stop_requested(); }));
  fmt::print("At the end, {} of {} servos were on.\n", emulator->body().servos_on(),
             request.file.servos.size());
  return {};
}

}  // namespace

Command emulate_command() {
  return {
      "emulate",
      "Emulate the servo controller and the sensor board of a hand or probe, at serial ports of "
      "this "
      "machine",
      {},
      {{"--body", "Simulated body that the boards move: lucs2, lucs3, texture or hardness", true},
       {"--bus", "Kind of servos: ssc32, dynamixel, sts or scs. Default: that of the device file"},
       input_flag("--device",
                  "Device file whose lines and calibration are emulated. Default: the body's own"),
       input_flag(
           "--objects",
           "TOML file with the objects and materials that can be placed. Default: the body's "
           "own table"),
       {"--seed", "Seed of placement and noise. Default: 1"},
       {"--clock",
        "Seconds of the emulation per second, or 'host': time passes only while a program waits "
        "for the device, as fast as possible, and nothing depends on the speed of the machine. "
        "Default: 1"},
       output_flag("-o,--output", "Device file that is written, with the ports of the emulator",
                   true)},
      {},
      run_emulate};
}

}  // namespace somato::program
