#pragma once

#include <cstdint>
#include <memory>

#include "somato/bodies/body.h"
#include "somato/bodies/material.h"
#include "somato/simulation/texture_probe_parameters.h"

namespace somato {

/// What is drawn at random around a probe.
struct ProbeSeeds {
  std::uint64_t world = 0;        ///< The surfaces: the same world has the same materials.
  std::uint64_t exploration = 0;  ///< Placement and noise of this probe.
};

/// A texture probe on a piece of material: a metal edge on a lever, and a microphone that listens
/// to it (P11 section IV; how it is simulated: docs/bodies/probes.md).
///
/// It has the degree of freedom `lever` (deg), at 0 to begin with, and the sensor `sound` (counts,
/// one element, at the sample rate). How a caller cuts time into steps changes no frame. One
/// material, parameters and seeds give the same bits everywhere.
///
/// Errors (kUsage): Material::validate() and TextureProbeParameters::validate().
Result<std::unique_ptr<Body>> make_texture_probe(const Material& material,
                                                 const TextureProbeParameters& parameters,
                                                 const ProbeSeeds& seeds);

}  // namespace somato
