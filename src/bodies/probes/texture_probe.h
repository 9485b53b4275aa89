#pragma once

#include <cstdint>
#include <memory>

#include "bodies/sensors/probe_truth.h"
#include "somato/bodies/body.h"
#include "somato/bodies/material.h"
#include "somato/simulation/simulation_parameters.h"

namespace somato {

/// Seeds of the random quantities of a probe.
struct ProbeSeeds {
  std::uint64_t world = 0;        ///< Seed of the surfaces: the same seed gives the same materials.
  std::uint64_t exploration = 0;  ///< Seed of placement and noise of this probe.
};

/// A texture probe on a piece of material: a metal edge on a lever, and a microphone that records
/// it (P11 section IV; docs/bodies/probes.md describes the simulation).
///
/// It has the degree of freedom `lever` (deg), initially at 0, and the sensor `sound` (counts, one
/// element, at the sample rate). The division of time into steps does not affect the frames. The
/// same material, parameters and seeds give the same bits on all machines. `truth` hears the true
/// values of every frame unless it is nullptr, and must outlive the probe.
///
/// Errors (kUsage): Material::validate() and TextureProbeParameters::validate().
Result<std::unique_ptr<Body>> make_texture_probe(const Material& material,
                                                 const TextureProbeParameters& parameters,
                                                 const ProbeSeeds& seeds,
                                                 detail::SoundTruth* truth = nullptr);

}  // namespace somato
