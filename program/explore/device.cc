#include "explore/device.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/files/toml_file.h"
#include "base/files/whole_file.h"
#include "bodies/explorers/recorded_scenes.h"
#include "bodies/explorers/simulated_body.h"
#include "explore/placing.h"
#include "explore/servo_switch.h"
#include "hardware/devices/device_explorer.h"
#include "hardware/devices/device_lines.h"
#include "hardware/devices/placing.h"
#include "hardware/lines/serial_lines.h"
#include "somato/bodies/object_table.h"
#include "terminal/terminal.h"
#include "version.h"

namespace somato::program {
namespace {

void guard(const wire::Lines& lines, std::span<const std::uint8_t> relax_bytes) {
  const auto& serial = dynamic_cast<const wire::SerialLines&>(lines);
  switch_off_at_the_end(serial.descriptor(0), relax_bytes);
}

using devices::DeviceFile;
using devices::ExploringMethod;

// The sensors without which a body does not explore.
std::vector<std::string> needed_sensors(ExploringMethod method) {
  switch (method) {
    case ExploringMethod::kGrasping:
      return {"touch"};
    case ExploringMethod::kClosing:
      return {"joints"};
    case ExploringMethod::kStroking:
      return {"sound"};
    case ExploringMethod::kPressing:
      return {"potentiometer"};
    case ExploringMethod::kHolding:
      break;
  }
  return {};
}

bool is_hand(ExploringMethod method) {
  return method != ExploringMethod::kStroking && method != ExploringMethod::kPressing;
}

Result<ObjectTable> things_of(const Arguments& arguments, const DeviceFile& file) {
  if (arguments.has("objects")) {
    return read_object_table(arguments.text("objects"), declared_materials());
  }
  if (!file.settings.body.empty()) {
    return choice_named<ExploringBody>("body", file.settings.body, "body").and_then(default_things);
  }
  return fail(ErrorKind::kUsage, "the device stands for no simulated body, whose objects are known",
              "--objects", "give a table of the objects that it explores (docs/objects.md)");
}

// One thing without a name: the device does not know what touches it. Servos only move after a
// person has permitted it.
Result<std::vector<ExploredThing>> unattended_things(const DeviceFile& file) {
  if (file.servos.empty()) return std::vector<ExploredThing>{{"unknown", {}, {}}};
  return fail(ErrorKind::kUsage,
              fmt::format("{} has servos, and they move only after a person has pressed Enter",
                          file.settings.name),
              "--unattended", "omit it, or use a device that only has sensors");
}

Result<std::vector<ExploredThing>> explored_things(const Arguments& arguments,
                                                   const DeviceFile& file) {
  if (arguments.has("unattended")) return unattended_things(file);
  SOMATO_TRY(const auto table, things_of(arguments, file));
  std::vector<ExploredThing> things;
  for (const Object& object : table.objects) {
    if (is_hand(file.settings.explore)) things.push_back({object.name, object, object.material});
  }
  for (const Material& material : table.materials) {
    if (!is_hand(file.settings.explore)) things.push_back({material.name, {}, material});
  }
  if (!things.empty()) return things;
  return fail(ErrorKind::kUsage,
              is_hand(file.settings.explore) ? "no objects for a hand" : "no materials for a probe",
              arguments.text("objects"), "add tables such as [object.cup] or [material.cork]");
}

Result<devices::DeviceExploring> read_settings(const Arguments& arguments) {
  devices::DeviceExploring exploring;
  if (!arguments.has("settings")) return exploring;
  SOMATO_TRY(const auto file, read_toml(arguments.text("settings")));
  SOMATO_TRY(auto parameters, read_exploring_parameters(file));
  return devices::DeviceExploring{parameters.plan, parameters.grasp, parameters.closing,
                                  parameters.stroke, parameters.press};
}

Result<void> place(const DeviceFile& file, const ExploredThing& thing, std::size_t trial) {
  constexpr double kPatience = 30.0;
  if (!file.settings.placing.empty()) {
    return devices::place_by_emulator(file.settings.placing, thing.name, trial, kPatience,
                                      [] { return !stop_requested(); });
  }
  return place_by_person(thing, trial);
}

// Beside the recording; a failure to save it must not hide the fault.
std::string keep_log(const std::string& output, const devices::StateLog& log) {
  const std::string path = output + ".fault.csv";
  return save_whole(path, log.to_csv()) ? path : std::string();
}

}  // namespace

Flag device_flag() {
  return input_flag("--device",
                    "TOML file of a hand or probe at serial lines, instead of a simulated body "
                    "(docs/your-hand.md)");
}

Flag unattended_flag() {
  return {"--unattended",
          "With --device: explorations follow each other without Enter, of a thing without a name; "
          "for devices without servos, such as a skin",
          false, false};
}

Result<void> check_unattended(const Arguments& arguments) {
  if (!arguments.has("unattended")) return {};
  if (!arguments.has("device")) {
    return fail(ErrorKind::kUsage, "only a device has to be attended", "--unattended",
                "omit it, or use --device FILE");
  }
  for (const std::string flag : {"objects", "object"}) {
    if (!arguments.has(flag)) continue;
    return fail(ErrorKind::kUsage, "no person is there to place things", "--" + flag,
                "omit it, or --unattended");
  }
  return {};
}

Result<std::unique_ptr<wire::Lines>> open_lines(const DeviceFile& file) {
  std::vector<wire::SerialLines::Port> ports;
  for (const devices::LineSettings& line : devices::lines_of(file)) {
    ports.push_back({line.port, line.baud, line.rate});
  }
  SOMATO_TRY(auto lines, wire::SerialLines::open(std::move(ports), file.settings.clock,
                                                 file.settings.clock_port));
  return std::unique_ptr<wire::Lines>(std::move(lines));
}

Result<BodyDescription> describe_body(ExploringBody body) {
  SOMATO_TRY(const auto things, default_things(body));
  SOMATO_TRY(const auto simulated, simulated_body(body, things, {}, 1, 0, 0));
  return simulated->description();
}

Result<DeviceFile> read_checked_device(const std::string& path) {
  SOMATO_TRY(auto file, devices::read_device_file(path));
  if (file.settings.body.empty()) return file;
  if constexpr (!kHasSimulation) {
    return fail(ErrorKind::kUsage,
                "this program was built without simulated bodies, against which the device would "
                "be checked",
                path + ": body", "remove 'body', and name the objects with '--objects FILE'");
  }
  SOMATO_TRY(const auto body,
             choice_named<ExploringBody>("body", file.settings.body, path + ": body"));
  SOMATO_TRY(const auto description, describe_body(body));
  SOMATO_TRY_VOID(
      devices::check_against(file, description, needed_sensors(file.settings.explore), path));
  return file;
}

ServoGuard::ServoGuard(const wire::Lines& lines, std::span<const std::uint8_t> relax_bytes) {
  guard(lines, relax_bytes);
}

ServoGuard::~ServoGuard() {
  switch_off_at_the_end(-1, {});
}

Result<std::unique_ptr<Explorer>> device_explorer(const Arguments& arguments,
                                                  const std::string& output,
                                                  PermittedBy permitted) {
  SOMATO_TRY(const auto file, read_checked_device(arguments.text("device")));
  SOMATO_TRY(auto things, explored_things(arguments, file));
  SOMATO_TRY(auto exploring, read_settings(arguments));
  devices::DeviceSurroundings surroundings;
  surroundings.open_lines = [file] { return open_lines(file); };
  if (!arguments.has("unattended")) {
    surroundings.place = [file](const ExploredThing& thing, std::size_t trial) {
      return place(file, thing, trial);
    };
  }
  if (permitted == PermittedBy::kTerminal) surroundings.permit = permit_by_person;
  std::vector<Object> objects;
  for (const ExploredThing& thing : things) {
    if (thing.object) objects.push_back(*thing.object);
  }
  surroundings.scenes = recorded_scenes(std::move(objects));
  surroundings.on_switch = guard;
  surroundings.continued = count_continuations();
  surroundings.watch = watch_stop_key;
  surroundings.keep_log = [output](const devices::StateLog& log) { return keep_log(output, log); };
  return devices::DeviceExplorer::create(file, std::move(things), std::move(exploring),
                                         std::move(surroundings));
}

}  // namespace somato::program
