#include "somato/simulation/simulation_parameters.h"

namespace somato {

const std::vector<std::pair<PiezoConverter, std::string>>& Choices<PiezoConverter>::all() {
  static const std::vector<std::pair<PiezoConverter, std::string>> choices{
      {PiezoConverter::kBipolar, "bipolar"}, {PiezoConverter::kUnipolar, "unipolar"}};
  return choices;
}

const Declarations<SimulationParameters>& SimulationParameters::declarations() {
  static const Declarations<SimulationParameters> all = [] {
    Declarations<SimulationParameters> d;
    d.add("time_step", &SimulationParameters::time_step, "s", Range::between(0.0001, 0.005),
          "Step of the physics; not given in the paper");
    d.add("free", &SimulationParameters::free, "", Range::any(),
          "Whether the object is free to slide and tilt on the table, or held in its place; not "
          "given in the paper");
    d.add("taxels", &SimulationParameters::taxels, "", Range::any(),
          "Whether the fingers of Hand III have taxels; not given in the paper");
    d.add("placement_noise", &SimulationParameters::placement_noise, "mm", Range::between(0, 50),
          "Standard deviation of where an object is put, along each axis; not given in the paper");
    d.add("placement_turn", &SimulationParameters::placement_turn, "deg", Range::between(0, 180),
          "Standard deviation of how an object is turned; automatic: 2 deg for each mm of "
          "placement_noise; not given in the paper");
    d.add("sensor_noise", &SimulationParameters::sensor_noise, "N", Range::between(0, 10),
          "Standard deviation of a touch sensor's noise; not given in the paper");
    d.add("joint_noise", &SimulationParameters::joint_noise, "deg", Range::between(0, 10),
          "Standard deviation of a potentiometer's noise; not given in the paper");
    d.add("servo_play", &SimulationParameters::servo_play, "", Range::between(0, 100),
          "Play of the servos' gears, as a multiple of the model's; not given in the paper");
    d.add(
        "touch_threshold", &SimulationParameters::touch_threshold, "N", Range::between(0, 100),
        "Readings of a touch sensor that are smaller, by their size, are reported as 0; not given "
        "in the paper");
    d.add("piezo_time", &SimulationParameters::piezo_time, "s", Range::between(0.001, 10),
          "Time in which a piezo element forgets a change of force; not given in the paper");
    d.add("piezo_converter", &SimulationParameters::piezo_converter, "", Range::any(),
          "Whether the converter behind a piezo element reads falling loads, whose voltage is "
          "negative, or 0 in their place; not given in the paper");
    d.add("friction", &SimulationParameters::friction, "", Range::between(0, 2),
          "Coulomb friction of the object; automatic: its material's; not given in the paper");
    return d;
  }();
  return all;
}

}  // namespace somato
