#pragma once

#include <vector>

#include "bodies/hands/hand_scene.h"
#include "bodies/hands/object_motion.h"
#include "bodies/hands/servo_driver.h"

namespace somato {

/// The changing state of a simulated hand.
class SimulatedHand::Impl {
 public:
  std::shared_ptr<const HandScene::Impl> scene;
  detail::PhysicsData data;
  detail::ServoDriver driver;
  detail::PiezoElements piezo;
  detail::Pose placed;
  Random noise;
  std::vector<double> forces;  ///< N, of each taxel, without noise.
  double owed = 0.0;           ///< Seconds that passed beyond the last whole time step.
  BodyState state;
};

}  // namespace somato
