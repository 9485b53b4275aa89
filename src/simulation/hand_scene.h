#pragma once

#include <array>
#include <string>
#include <vector>

#include "simulation/physics.h"
#include "simulation/touch_sense.h"
#include "somato/simulation/simulated_hand.h"

namespace somato {

/// What is constant about a hand with an object before it.
class HandScene::Parts {
 public:
  Hand hand = Hand::kLucs2;
  Object object;
  SimulationParameters parameters;
  detail::PhysicsModel model;
  detail::Taxels taxels;
  BodyDescription description;
  std::vector<double> scales;  ///< Of each servo: its unit (deg, mm) in the model's (rad, m).
  std::vector<double> start;   ///< Of each servo, the open hand; in the model's units.
  int place = -1;              ///< The site where objects stand.
  bool at_palm = false;        ///< Whether objects are put against a palm there.
  bool turn_to_palm = false;   ///< Whether that means turning its wider side along the palm.
  int object_body = -1;
  int object_geom = -1;
  int stand_body = -1;  ///< What a free round object lies on; -1 where there is none.
};

namespace detail {

/// The text of a hand's model with an object put into it.
std::string scene_mjcf(std::string_view hand, const std::string& assets, const std::string& bodies);

}  // namespace detail

}  // namespace somato
