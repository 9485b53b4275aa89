#pragma once

#include <cstddef>

#include "somato/core/parameter.h"
#include "somato/core/result.h"

namespace somato {

/// The parameters of a simulated texture probe; see make_texture_probe(). P11 section IV-A gives
/// the lever's 36 degrees in 1 s, section IV names the converter, an NI USB-6008, which has 12 bits
/// by its data sheet.
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
  double servo_tone = 210.0;
  double servo_tone_spread = 0.02;
  double servo_noise = 3.0;

  double sample_rate = 8192.0;
  std::size_t oversampling = 8;
  std::size_t adc_bits = 12;
  double adc_range = 1000.0;

  static const Declarations<TextureProbeParameters>& declarations();

  /// Whether the parameters fit each other. Errors (kUsage): one out of its range; an edge,
  /// a microphone or a servo with frequencies, or heights that pass by, above 0.45 x `sample_rate`
  /// x `oversampling`.
  Result<void> validate() const;
};

}  // namespace somato
