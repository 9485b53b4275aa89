#pragma once

#include <array>
#include <string>
#include <vector>

#include "bodies/hands/touch_sense.h"
#include "bodies/physics/physics.h"
#include "somato/simulation/simulated_hand.h"

namespace somato {

/// The constant part of a hand with an object.
class HandScene::Impl {
 public:
  Hand hand = Hand::kLucs2;
  Object object;
  SimulationParameters parameters;
  detail::PhysicsModel model;
  detail::Taxels taxels;
  BodyDescription description;
  std::vector<double>
      scales;  ///< For each servo: the factor from its unit (deg, mm) to the model's (rad, m).
  std::vector<double> start;  ///< For each servo, the open hand, in the model's units.
  int place = -1;             ///< The site of the object.
  bool at_palm = false;       ///< Whether objects are put against a palm there.
  bool turn_to_palm = false;  ///< Whether that means turning its wider side along the palm.
  int object_body = -1;
  int object_geom = -1;
  int stand_body = -1;  ///< The stand of a free round object; -1 if there is none.
};

namespace detail {

/// The text of a hand's model with an object put into it.
std::string scene_mjcf(std::string_view hand, const std::string& assets, const std::string& bodies);

}  // namespace detail

}  // namespace somato
