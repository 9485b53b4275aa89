#include "bodies/sensors/sensor_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "base/text/flag_hint.h"
#include "bodies/sensors/exact_values.h"
#include "somato/simulation/sense.h"

namespace somato {
namespace {

// The parameters of a sensor, and the true channel that it measures.
struct SensorParameters {
  const char* truth;
  std::vector<std::string_view> names;
};

const std::vector<SensorParameters>& sensors() {
  static const std::vector<SensorParameters> all{
      {"true_contacts",
       {"sensor_noise", "touch_threshold", "piezo_time", "piezo_converter", "touch_rest",
        "touch_rest_spread", "touch_gain_spread", "touch_bits", "touch_range"}},
      {"true_joints", {"joint_noise", "joint_spread", "joint_bits", "joint_range"}},
      {"true_edge",
       {"sensitivity", "microphone_noise", "ambient_sound", "ambient_cutoff", "servo_noise",
        "adc_bits", "adc_range"}},
      {"true_stick",
       {"potentiometer_bits", "potentiometer_noise", "potentiometer_path", "potentiometer_offset",
        "press_spread"}},
      {"true_draws", {"true_values"}}};
  return all;
}

const SensorParameters* sensor_of(std::string_view parameter) {
  const auto found =
      std::find_if(sensors().begin(), sensors().end(), [&](const SensorParameters& sensor) {
        return std::ranges::find(sensor.names, parameter) != sensor.names.end();
      });
  return found == sensors().end() ? nullptr : &*found;
}

template <typename S>
void add_infos(std::vector<ParameterInfo>& all) {
  for (const ParameterInfo& info : S::declarations().infos()) {
    if (sensor_of(info.name) != nullptr) all.push_back(info);
  }
}

template <typename S>
Result<void> read_section(const Table& given, S& parameters) {
  Table section{given.where, {}};
  for (const Table::Entry& entry : given.entries) {
    const auto& infos = S::declarations().infos();
    const bool is_own = std::any_of(infos.begin(), infos.end(), [&](const ParameterInfo& info) {
      return info.name == entry.name;
    });
    if (is_own) section.entries.push_back(entry);
  }
  SOMATO_TRY(auto read, read_parameters(section, parameters));
  parameters = std::move(read);
  return {};
}

}  // namespace

const std::vector<ParameterInfo>& sensor_parameters() {
  static const std::vector<ParameterInfo> all = [] {
    std::vector<ParameterInfo> infos;
    add_infos<SimulationParameters>(infos);
    add_infos<TextureProbeParameters>(infos);
    add_infos<HardnessProbeParameters>(infos);
    return infos;
  }();
  return all;
}

Result<ExploringParameters> read_sensor_parameters(const Table& given,
                                                   ExploringParameters parameters) {
  std::vector<std::string> known;
  for (const ParameterInfo& info : sensor_parameters()) known.push_back(info.name);
  for (const Table::Entry& entry : given.entries) {
    if (sensor_of(entry.name) == nullptr) {
      return fail(unknown_name("parameter of a sensor", entry.name, entry.where, known));
    }
  }
  parameters.simulation.true_values = false;
  SOMATO_TRY_VOID(read_section(given, parameters.simulation));
  SOMATO_TRY_VOID(read_section(given, parameters.texture_probe));
  SOMATO_TRY_VOID(read_section(given, parameters.hardness_probe));
  return parameters;
}

Result<void> check_sensor_effect(const Table& given, const Exploration& exploration) {
  for (const Table::Entry& entry : given.entries) {
    const SensorParameters* sensor = sensor_of(entry.name);
    if (sensor == nullptr || detail::true_channel(exploration, sensor->truth) != nullptr ||
        detail::true_channel(exploration, "true_draws") == nullptr) {
      continue;
    }
    return fail(ErrorKind::kUsage,
                "has no effect, because the recording has no true values of its sensor",
                entry.where, "omit it");
  }
  return {};
}

Result<std::string> note_of_other_sensors(const Exploration& explored) {
  SOMATO_TRY(const Exploration by_default, sense(explored, {}));
  std::vector<Channel> readings = explored.channels;
  std::erase_if(readings, detail::is_true_channel);
  if (by_default.channels == readings) return std::string();
  return fmt::format(
      "the recording was made with other sensors than the default ones, and parameters of sensors "
      "that are not given have their defaults; give the settings of the exploration{}",
      flag_hint("settings", "FILE"));
}

}  // namespace somato
