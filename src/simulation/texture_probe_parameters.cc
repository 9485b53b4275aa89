#include "somato/simulation/texture_probe_parameters.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace somato {
namespace {

void declare_lever(Declarations<TextureProbeParameters>& d) {
  using P = TextureProbeParameters;
  d.add("stroke", &P::stroke, "deg", Range::between(0.1, 180),
        "How far the lever turns; 36 in P11.");
  d.add("lever_speed", &P::lever_speed, "deg/s", Range::between(0.01, 3600),
        "How fast it turns; 36 in P11.");
  d.add("lever_radius", &P::lever_radius, "mm", Range::between(1, 1000),
        "From the servo's axis to the edge; not given in the paper.");
  d.add("placement_noise", &P::placement_noise, "mm", Range::between(0, 100),
        "Standard deviation of where the stroke starts, along it and across; not given in the "
        "paper.");
}

void declare_edge(Declarations<TextureProbeParameters>& d) {
  using P = TextureProbeParameters;
  d.add("edge_width", &P::edge_width, "mm", Range::between(0.001, 10),
        "Least spacing of heights that the edge follows; not given in the paper.");
  d.add("edge_stiffness", &P::edge_stiffness, "N/mm", Range::between(1e-6, 1e9),
        "Force for a mm of the edge: a softer material gives way instead; not given in the paper.");
  d.add("edge_resonance", &P::edge_resonance, "Hz", Range::between(1, 1e6),
        "Resonance of the free edge; not given in the paper.");
  d.add(
      "resonance_rise", &P::resonance_rise, "", Range::between(0, 100),
      "How much a rigid material raises the square of the resonance, as a share; not given in the "
      "paper.");
  d.add("edge_damping", &P::edge_damping, "", Range::between(1e-4, 10),
        "Damping ratio of the free edge; not given in the paper.");
}

void declare_microphone(Declarations<TextureProbeParameters>& d) {
  using P = TextureProbeParameters;
  d.add("sensitivity", &P::sensitivity, "mV/(mm/s)", Range::between(0, 1e9),
        "What the microphone makes of the edge; not given in the paper.");
  d.add("microphone_low", &P::microphone_low, "Hz", Range::between(1e-3, 1e6),
        "Frequency below which the microphone is deaf; not given in the paper.");
  d.add("microphone_noise", &P::microphone_noise, "mV", Range::between(0, 1e6),
        "Standard deviation of its white noise; not given in the paper.");
  d.add("servo_tone", &P::servo_tone, "Hz", Range::between(1e-3, 1e6),
        "Mean fundamental of the moving servo's whine; not given in the paper.");
  d.add("servo_tone_spread", &P::servo_tone_spread, "", Range::between(0, 0.05),
        "Standard deviation of the fundamental between explorations, as a share; not given in the "
        "paper.");
  d.add("servo_noise", &P::servo_noise, "mV", Range::between(0, 1e6),
        "Root mean square of the whine, with its harmonics; not given in the paper.");
}

void declare_converter(Declarations<TextureProbeParameters>& d) {
  using P = TextureProbeParameters;
  d.add("sample_rate", &P::sample_rate, "Hz", Range::between(1, 2e5),
        "Frames a second; not given in the paper.");
  d.add("oversampling", &P::oversampling, "", Range::between(2, 64),
        "Steps of the simulation for a frame; not given in the paper.");
  d.add("adc_bits", &P::adc_bits, "bits", Range::between(1, 24),
        "Resolution of the converter; 12 by the data sheet of the NI USB-6008 that P11 names; not "
        "given in the paper.");
  d.add("adc_range", &P::adc_range, "mV", Range::between(1e-6, 1e9),
        "Voltage, either way, at which the converter saturates; not given in the paper.");
}

Result<void> check_frequency(const char* key, double highest,
                             const TextureProbeParameters& parameters) {
  const double limit = 0.45 * parameters.sample_rate * static_cast<double>(parameters.oversampling);
  if (highest <= limit) return {};
  return fail(
      ErrorKind::kUsage,
      fmt::format("'{}' reaches {:g} Hz, and the simulation carries {:g} Hz", key, highest, limit),
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
  if (auto ranges = check_ranges(*this); !ranges) return ranges;
  const double raised = edge_resonance * std::sqrt(1.0 + resonance_rise);
  if (auto fits = check_frequency("edge_resonance", raised, *this); !fits) return fits;
  const double speed = lever_radius * lever_speed * std::numbers::pi / 180.0;
  if (auto fits = check_frequency("lever_speed", speed / edge_width, *this); !fits) return fits;
  if (auto fits = check_frequency("servo_tone", 8.0 * servo_tone, *this); !fits) return fits;
  return check_frequency("microphone_low", microphone_low, *this);
}

}  // namespace somato
