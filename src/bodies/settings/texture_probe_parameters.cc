#include "somato/simulation/simulation_parameters.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace somato {
namespace {

void declare_lever(Declarations<TextureProbeParameters>& d) {
  using P = TextureProbeParameters;
  d.add("stroke", &P::stroke, "deg", Range::between(0.1, 180), "Angle of the stroke; 36 in P11.");
  d.add("lever_speed", &P::lever_speed, "deg/s", Range::between(0.01, 3600),
        "Angular speed of the stroke; 36 in P11.");
  d.add("lever_radius", &P::lever_radius, "mm", Range::between(1, 1000),
        "Distance from the servo's axis to the edge. Not given in the paper.");
  d.add("placement_noise", &P::placement_noise, "mm", Range::between(0, 100),
        "Standard deviation of the start of the stroke, along it and across. Not given in the "
        "paper.");
}

void declare_edge(Declarations<TextureProbeParameters>& d) {
  using P = TextureProbeParameters;
  d.add("edge_width", &P::edge_width, "mm", Range::between(0.001, 10),
        "Smallest spacing of heights that the edge follows. Not given in the paper.");
  d.add("edge_stiffness", &P::edge_stiffness, "N/mm", Range::between(1e-6, 1e9),
        "Stiffness of the edge, in force per mm; a softer material yields instead. Not given in "
        "the paper.");
  d.add("edge_resonance", &P::edge_resonance, "Hz", Range::between(1, 1e6),
        "Resonance of the free edge. Not given in the paper.");
  d.add(
      "resonance_rise", &P::resonance_rise, "", Range::between(0, 100),
      "Increase of the squared resonance on a rigid material, as a share. Not given in the paper.");
  d.add("edge_damping", &P::edge_damping, "", Range::between(1e-4, 10),
        "Damping ratio of the free edge. Not given in the paper.");
}

void declare_microphone(Declarations<TextureProbeParameters>& d) {
  using P = TextureProbeParameters;
  d.add("sensitivity", &P::sensitivity, "mV/(mm/s)", Range::between(0, 1e9),
        "Sensitivity of the microphone to the motion of the edge. Not given in the paper.");
  d.add("microphone_low", &P::microphone_low, "Hz", Range::between(1e-3, 1e6),
        "Lower cut-off frequency of the microphone. Not given in the paper.");
  d.add("microphone_noise", &P::microphone_noise, "mV", Range::between(0, 1e6),
        "Standard deviation of its white noise. Not given in the paper.");
  d.add("ambient_sound", &P::ambient_sound, "mV", Range::between(0, 1e6),
        "Root mean square of the sound of the room, as the microphone reports it; 0: none. Not "
        "given in the paper.");
  d.add("ambient_cutoff", &P::ambient_cutoff, "Hz", Range::between(1e-3, 1e6),
        "Frequency above which the sound of the room falls by 6 dB an octave; no effect without "
        "ambient_sound. Not given in the paper.");
  d.add("servo_tone", &P::servo_tone, "Hz", Range::between(1e-3, 1e6),
        "Mean fundamental frequency of the servo's whine in motion. Not given in the paper.");
  d.add("servo_tone_spread", &P::servo_tone_spread, "", Range::between(0, 0.05),
        "Standard deviation of the fundamental between explorations, as a share. Not given in the "
        "paper.");
  d.add("servo_noise", &P::servo_noise, "mV", Range::between(0, 1e6),
        "Root mean square of the whine, with its harmonics. Not given in the paper.");
}

void declare_converter(Declarations<TextureProbeParameters>& d) {
  using P = TextureProbeParameters;
  d.add("sample_rate", &P::sample_rate, "Hz", Range::between(1, 2e5),
        "Frames per second. Not given in the paper.");
  d.add("oversampling", &P::oversampling, "", Range::between(2, 64),
        "Number of simulation steps per frame. Not given in the paper.");
  d.add("adc_bits", &P::adc_bits, "bits", Range::between(1, 24),
        "Resolution of the converter; 12 according to the data sheet of the NI USB-6008, which P11 "
        "names. Not given in the paper.");
  d.add("adc_range", &P::adc_range, "mV", Range::between(1e-6, 1e9),
        "Voltage, positive or negative, at which the converter saturates. Not given in the paper.");
}

Result<void> check_frequency(const char* key, double highest,
                             const TextureProbeParameters& parameters) {
  const double limit = 0.45 * parameters.sample_rate * static_cast<double>(parameters.oversampling);
  if (highest <= limit) return {};
  return fail(ErrorKind::kUsage,
              fmt::format("'{}' reaches {:g} Hz, but the simulation supports at most {:g} Hz", key,
                          highest, limit),
              {}, "lower it, or raise 'oversampling'");
}

}  // namespace

const Declarations<TextureProbeParameters>& TextureProbeParameters::declarations() {
  static const Declarations<TextureProbeParameters> kAll = [] {
    Declarations<TextureProbeParameters> d;
    declare_lever(d);
    declare_edge(d);
    declare_microphone(d);
    declare_converter(d);
    return d;
  }();
  return kAll;
}

Result<void> TextureProbeParameters::validate() const {
  SOMATO_TRY_VOID(check_ranges(*this));
  const double raised = edge_resonance * std::sqrt(1.0 + resonance_rise);
  SOMATO_TRY_VOID(check_frequency("edge_resonance", raised, *this));
  const double speed = lever_radius * lever_speed * std::numbers::pi / 180.0;
  SOMATO_TRY_VOID(check_frequency("lever_speed", speed / edge_width, *this));
  SOMATO_TRY_VOID(check_frequency("servo_tone", 8.0 * servo_tone, *this));
  return check_frequency("microphone_low", microphone_low, *this);
}

}  // namespace somato
