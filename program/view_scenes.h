#pragma once

#include "somato/bodies/scene.h"

namespace somato::program {

/// Finds what a recording of one of the simulated hands looked like, by its channels, with the
/// object of its label `object` where it is one of the tables that travel with the program.
SceneFinder hand_scenes();

}  // namespace somato::program
