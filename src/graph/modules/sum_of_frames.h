#pragma once

#include "somato/codes/normalization.h"

namespace somato::modules {

/// A module that a reading which follows the sum of frames may stand for.
class Followed {
 public:
  Followed() = default;
  Followed(const Followed&) = delete;
  Followed(Followed&&) = delete;
  Followed& operator=(const Followed&) = delete;
  Followed& operator=(Followed&&) = delete;
  virtual ~Followed() = default;
};

/// Gives the sum of all frames so far, nothing forgotten.
class SumOfFrames : public Followed {};

/// Gives its input divided by a norm.
class DividedByNorm : public Followed {
 public:
  virtual Norm norm() const = 0;
};

}  // namespace somato::modules
