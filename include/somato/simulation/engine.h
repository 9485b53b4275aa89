#pragma once

#include <string>

namespace somato {

/// The physics engine behind the simulated bodies, with its version: such as "MuJoCo 3.17.0".
/// Forces and poses of a simulation depend on it.
std::string physics_engine();

}  // namespace somato
