#pragma once

#include "maps/t_mpsom/t_mpsom_arbor.h"
#include "somato/core/matrix.h"
#include "somato/maps/t_mpsom.h"

namespace somato {

/// An input of a map: its weights, and what the neurons see of it.
struct TMpsom::Input {
  LaneMatrix<float> weights;
  TMpsomArbor arbor;
  bool normalized = false;  // for certain, if weights are to be
};

}  // namespace somato
