#pragma once

#include "somato/bodies/closing.h"
#include "somato/bodies/exploration_plan.h"
#include "somato/bodies/guarded_grasp.h"
#include "somato/bodies/pressing.h"
#include "somato/bodies/stroking.h"
#include "somato/core/value.h"
#include "somato/simulation/hardness_probe.h"
#include "somato/simulation/simulation_parameters.h"
#include "somato/simulation/texture_probe_parameters.h"

namespace somato {

/// Everything about an exploration that is declared: a table of TOML each.
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
/// [stroke], [hardness_probe] and [press] of a file; what it leaves out stays as it is. Errors
/// (kUsage) with their place: unknown tables and keys, values out of range.
Result<ExploringParameters> read_exploring_parameters(const Table& file,
                                                      ExploringParameters parameters = {});

}  // namespace somato
