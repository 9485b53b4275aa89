#include "somato/simulation/engine.h"

#include <mujoco/mujoco.h>

namespace somato {

std::string physics_engine() {
  return std::string("MuJoCo ") + mj_versionString();
}

}  // namespace somato
