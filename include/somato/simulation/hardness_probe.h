#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "somato/bodies/body.h"
#include "somato/bodies/material.h"
#include "somato/core/parameter.h"
#include "somato/core/result.h"

namespace somato {

/// The parameters of a simulated hardness probe; see make_hardness_probe(). P11 section IV-A gives
/// 18 bits and a constant force, and no more.
struct HardnessProbeParameters {
  double stroke = 10.0;
  double stick_speed = 20.0;
  double clearance = 1.0;
  double force = 5.0;
  double force_noise = 0.01;
  std::size_t potentiometer_bits = 18;
  double potentiometer_noise = 0.006;

  static const Declarations<HardnessProbeParameters>& declarations();

  /// Whether the parameters fit each other. Errors (kUsage): one out of its range; a clearance that
  /// takes up the whole stroke.
  Result<void> validate() const;
};

/// Where the stick is, in mm, when its potentiometer reads `counts`; none outside its range.
std::optional<double> stick_position(double counts, const HardnessProbeParameters& parameters);

/// A hardness probe over a piece of material: a stick on a servo that presses with a constant
/// force, and the servo's potentiometer (P11 section IV; how it is simulated:
/// docs/bodies/probes.md).
///
/// It has the degree of freedom `stick` (mm), at 0 to begin with, which is `clearance` above the
/// material, and the sensor `potentiometer` (counts, one element, once a step). A stick sent deeper
/// than its force carries it stays where force and material balance; the driver does not know. How
/// a caller cuts time into steps changes no reading. The same arguments give the same bits
/// everywhere.
///
/// Errors (kUsage): Material::validate() and HardnessProbeParameters::validate().
Result<std::unique_ptr<Body>> make_hardness_probe(const Material& material,
                                                  const HardnessProbeParameters& parameters,
                                                  std::uint64_t exploration_seed);

}  // namespace somato
