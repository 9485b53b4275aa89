#pragma once

#include <cstdint>
#include <memory>

#include "bodies/sensors/probe_truth.h"
#include "somato/bodies/body.h"
#include "somato/bodies/material.h"
#include "somato/core/result.h"
#include "somato/simulation/simulation_parameters.h"

namespace somato {

/// A hardness probe above a piece of material: a stick on a servo that presses with a constant
/// force, and the servo's potentiometer (P11 section IV; docs/bodies/probes.md describes the
/// simulation).
///
/// It has the degree of freedom `stick` (mm), initially at 0, which is `clearance` above the
/// material, and the sensor `potentiometer` (counts, one element, once per step). A stick with a
/// target deeper than its force permits stops where force and material are in equilibrium, which
/// the driver does not detect. The division of time into steps does not affect the readings. The
/// same arguments give the same bits on all machines. `truth` receives the true values of the last
/// step unless it is nullptr, and must outlive the probe.
///
/// Errors (kUsage): Material::validate() and HardnessProbeParameters::validate().
Result<std::unique_ptr<Body>> make_hardness_probe(const Material& material,
                                                  const HardnessProbeParameters& parameters,
                                                  std::uint64_t exploration_seed,
                                                  detail::StickTruth* truth = nullptr);

}  // namespace somato
