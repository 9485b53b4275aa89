#include "somato/simulation/simulation_parameters.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace somato {
namespace {

// A table of the file, and how it is read.
struct Section {
  std::string name;
  std::function<Result<void>(const Table&)> read;
};

template <typename Parameters>
Section section(std::string name, Parameters& parameters) {
  return {std::move(name), [&parameters](const Table& table) -> Result<void> {
            SOMATO_TRY(auto read, read_parameters<Parameters>(table, parameters));
            parameters = std::move(read);
            return {};
          }};
}

std::vector<Section> sections_of(ExploringParameters& parameters) {
  return {section("simulation", parameters.simulation),
          section("plan", parameters.plan),
          section("grasp", parameters.grasp),
          section("closing", parameters.closing),
          section("texture_probe", parameters.texture_probe),
          section("stroke", parameters.stroke),
          section("hardness_probe", parameters.hardness_probe),
          section("press", parameters.press)};
}

Result<void> read_section(const Table::Entry& entry, const std::vector<Section>& sections) {
  std::vector<std::string> known;
  known.reserve(sections.size());
  for (const Section& section : sections) {
    known.push_back(section.name);
    if (section.name != entry.name) continue;
    if (const auto* table = std::get_if<Table>(&entry.content)) return section.read(*table);
    return fail(ErrorKind::kUsage, "'" + entry.name + "' must be a table", entry.where,
                "write [" + entry.name + "] on a separate line, its keys below");
  }
  return fail(unknown_name("table", entry.name, entry.where, known));
}

}  // namespace

const std::vector<std::pair<PiezoConverter, std::string>>& Choices<PiezoConverter>::all() {
  static const std::vector<std::pair<PiezoConverter, std::string>> choices{
      {PiezoConverter::kBipolar, "bipolar"}, {PiezoConverter::kUnipolar, "unipolar"}};
  return choices;
}

const Declarations<SimulationParameters>& SimulationParameters::declarations() {
  static const Declarations<SimulationParameters> all = [] {
    Declarations<SimulationParameters> d;
    d.add("time_step", &SimulationParameters::time_step, "s", Range::between(0.0001, 0.005),
          "Time step of the physics. Not given in the paper.");
    d.add(
        "free", &SimulationParameters::free, "", Range::any(),
        "Whether the object can slide and tilt on the table, or is fixed. Not given in the paper.");
    d.add("taxels", &SimulationParameters::taxels, "", Range::any(),
          "Whether the fingers of Hand III have taxels. Not given in the paper.");
    d.add("placement_noise", &SimulationParameters::placement_noise, "mm", Range::between(0, 50),
          "Standard deviation of the object's position, along each axis. Not given in the paper.");
    d.add("placement_turn", &SimulationParameters::placement_turn, "deg", Range::between(0, 180),
          "Standard deviation of the object's rotation; automatic: 2 deg for each mm of "
          "placement_noise. Not given in the paper.");
    d.add("sensor_noise", &SimulationParameters::sensor_noise, "N", Range::between(0, 10),
          "Standard deviation of a touch sensor's noise. Not given in the paper.");
    d.add("joint_noise", &SimulationParameters::joint_noise, "deg", Range::between(0, 10),
          "Standard deviation of a potentiometer's noise. Not given in the paper.");
    d.add("servo_play", &SimulationParameters::servo_play, "", Range::between(0, 100),
          "Backlash of the servos' gears, as a multiple of the model's. Not given in the paper.");
    d.add("touch_threshold", &SimulationParameters::touch_threshold, "N", Range::between(0, 100),
          "Threshold of a touch sensor: readings with a smaller magnitude are reported as 0. Not "
          "given in the paper.");
    d.add("piezo_time", &SimulationParameters::piezo_time, "s", Range::between(0.001, 10),
          "Time constant with which the response of a piezo element to a change of force decays. "
          "Not given in the paper.");
    d.add("piezo_converter", &SimulationParameters::piezo_converter, "", Range::any(),
          "Whether the converter of a piezo element reports falling loads, whose voltage is "
          "negative, or 0 instead. Not given in the paper.");
    d.add("touch_rest", &SimulationParameters::touch_rest, "N", Range::between(0, 100),
          "Median resting level of the touch sensors: what they read without contact; 0: none. Not "
          "given in the paper.");
    d.add("touch_rest_spread", &SimulationParameters::touch_rest_spread, "", Range::between(0, 3),
          "Standard deviation of the natural logarithm of the resting level between the sensors of "
          "a hand; 0: all are equal. Not given in the paper.");
    d.add(
        "touch_gain_spread", &SimulationParameters::touch_gain_spread, "", Range::between(0, 3),
        "Standard deviation of the natural logarithm of the sensitivity between the touch sensors "
        "of a hand; 0: all are equal. Not given in the paper.");
    d.add("touch_bits", &SimulationParameters::touch_bits, "bits", Range::between(1, 24),
          "Resolution of the converter of the touch sensors over touch_range; automatic: without "
          "steps and limits. Not given in the paper.");
    d.add("touch_range", &SimulationParameters::touch_range, "N", Range::between(1e-3, 1e6),
          "Force at which the converter of the touch sensors saturates; no effect without "
          "touch_bits. Not given in the paper.");
    d.add("joint_spread", &SimulationParameters::joint_spread, "deg", Range::between(0, 90),
          "Standard deviation, between explorations, of the difference of a potentiometer from the "
          "angle of its servo, constant during an exploration; 0: none. Not given in the paper.");
    d.add("joint_bits", &SimulationParameters::joint_bits, "bits", Range::between(1, 24),
          "Resolution of the converter of the potentiometers of the joints over joint_range; "
          "automatic: without steps. Not given in the paper.");
    d.add("joint_range", &SimulationParameters::joint_range, "deg", Range::between(1, 3600),
          "Angle that the converter of the potentiometers covers; no effect without joint_bits. "
          "Not given in the paper.");
    d.add(
        "friction", &SimulationParameters::friction, "", Range::between(0, 2),
        "Coulomb friction of the object; automatic: that of its material. Not given in the paper.");
    d.add("silhouette", &SimulationParameters::silhouette, "", Range::between(0, 256),
          "Rows and columns of the channel `silhouette`, the object as a camera sees it, without "
          "the hand: the share of each pixel that it covers, seen with parallel rays in the "
          "direction of the model's camera; 0: no such channel. Not given in the paper.");
    d.add("silhouette_side", &SimulationParameters::silhouette_side, "mm", Range::between(1, 2000),
          "Width and height of what the camera sees. Not given in the paper.");
    d.add("silhouette_centre", &SimulationParameters::silhouette_centre, "mm",
          Range::between(0, 1000),
          "Height above the place of the object of the point in the middle of the image. Not "
          "given in the paper.");
    d.add("true_values", &SimulationParameters::true_values, "", Range::any(),
          "Whether the recording also contains the true values, such as forces and angles, from "
          "which `somato sense` computes the readings of other sensors; of hands and probes.");
    return d;
  }();
  return all;
}

Result<ExploringParameters> read_exploring_parameters(const Table& file,
                                                      ExploringParameters parameters) {
  const std::vector<Section> sections = sections_of(parameters);
  for (const Table::Entry& entry : file.entries) {
    SOMATO_TRY_VOID(read_section(entry, sections));
  }
  return parameters;
}

}  // namespace somato
