#pragma once

#include <vector>

#include "bodies/hands/hand_scene.h"
#include "bodies/hands/object_motion.h"
#include "bodies/hands/servo_driver.h"
#include "bodies/sensors/hand_sensors.h"
#include "bodies/sensors/hand_truth.h"

namespace somato {

/// The changing state of a simulated hand.
class SimulatedHand::Impl {
 public:
  std::shared_ptr<const HandScene::Impl> scene;
  detail::PhysicsData data;
  detail::ServoDriver driver;
  detail::HandSensors sensors;
  detail::Pose placed;
  std::vector<double> forces;  ///< N, of each taxel, without noise.
  double owed = 0.0;           ///< Seconds that passed beyond the last whole time step.
  BodyState state;
  detail::HandTruth truth;  ///< Empty unless the scene's parameters ask for true values.
};

}  // namespace somato
