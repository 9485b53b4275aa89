#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/bodies/explore_by.h"
#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/core/value.h"

namespace somato {

/// Reading of the converter of a piezo element for a falling load, whose voltage is negative.
enum class PiezoConverter {
  kBipolar,   ///< Rising and falling loads.
  kUnipolar,  ///< Rising loads; 0 for a falling load.
};

template <>
struct Choices<PiezoConverter> {
  static const std::vector<std::pair<PiezoConverter, std::string>>& all();
};

/// Parameters of the simulation of a hand and its object.
struct SimulationParameters {
  double time_step = 0.001;
  bool free = false;
  bool taxels = false;
  double placement_noise = 1.0;
  std::optional<double> placement_turn;
  double sensor_noise = 0.02;
  double joint_noise = 0.2;
  double servo_play = 1.0;
  double touch_threshold = 0.1;
  double piezo_time = 0.1;
  PiezoConverter piezo_converter = PiezoConverter::kUnipolar;
  double touch_rest = 0.0;
  double touch_rest_spread = 0.0;
  double touch_gain_spread = 0.0;
  std::optional<std::size_t> touch_bits;
  double touch_range = 10.0;
  double joint_spread = 0.0;
  std::optional<std::size_t> joint_bits;
  double joint_range = 180.0;
  std::optional<double> friction;
  std::size_t silhouette = 0;
  double silhouette_side = 200.0;
  double silhouette_centre = 60.0;
  bool true_values = false;

  static const Declarations<SimulationParameters>& declarations();
};

/// The parameters of a simulated texture probe. P11 section IV-A gives
/// the lever's 36 degrees in 1 s; section IV names the converter, an NI USB-6008, which has 12 bits
/// according to its data sheet.
struct TextureProbeParameters {
  double stroke = 36.0;
  double lever_speed = 36.0;
  double lever_radius = 40.0;
  double placement_noise = 0.2;

  double edge_width = 0.01;
  double edge_stiffness = 1.0;
  double edge_resonance = 900.0;
  double resonance_rise = 0.5;
  double edge_damping = 0.05;

  double sensitivity = 15.0;
  double microphone_low = 20.0;
  double microphone_noise = 1.0;
  double ambient_sound = 0.0;
  double ambient_cutoff = 100.0;
  double servo_tone = 210.0;
  double servo_tone_spread = 0.02;
  double servo_noise = 3.0;

  double sample_rate = 8192.0;
  std::size_t oversampling = 8;
  std::size_t adc_bits = 12;
  double adc_range = 1000.0;

  static const Declarations<TextureProbeParameters>& declarations();

  /// Whether the parameters are consistent. Errors (kUsage): one out of its range; frequencies of
  /// the edge, the microphone, the servo, or the passing heights above 0.45 x `sample_rate` x
  /// `oversampling`.
  Result<void> validate() const;
};

/// The parameters of a simulated hardness probe. P11 section IV-A only
/// gives 18 bits and a constant force.
struct HardnessProbeParameters {
  double stroke = 10.0;
  double stick_speed = 20.0;
  double clearance = 1.0;
  double force = 5.0;
  double force_noise = 0.01;
  std::size_t potentiometer_bits = 18;
  double potentiometer_noise = 0.006;
  std::optional<double> potentiometer_path;
  double potentiometer_offset = 0.0;
  double press_spread = 0.0;

  static const Declarations<HardnessProbeParameters>& declarations();

  /// Whether the parameters are consistent. Errors (kUsage): one out of its range; a clearance that
  /// is not below the stroke.
  Result<void> validate() const;
};

/// All parameters of an exploration: one table of TOML for each member.
struct ExploringParameters {
  SimulationParameters simulation;
  ExplorationPlan plan;
  GuardedGrasp grasp;
  Closing closing;
  TextureProbeParameters texture_probe;
  StrokeParameters stroke;
  HardnessProbeParameters hardness_probe;
  PressParameters press;
};

/// The parameters in the tables [simulation], [plan], [grasp], [closing], [texture_probe],
/// [stroke], [hardness_probe] and [press] of a file; missing ones are unchanged. Errors (kUsage)
/// with their location: unknown tables and keys, values out of range.
Result<ExploringParameters> read_exploring_parameters(const Table& file,
                                                      ExploringParameters parameters = {});

}  // namespace somato
