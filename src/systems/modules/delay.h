#pragma once

#include <cstddef>
#include <vector>

#include "systems/modules/support.h"

namespace somato::modules {

/// A module whose output does not depend on its present input, so that it may close a loop.
class Delay : public Module {
 public:
  /// The shape of the output, known before the input is; empty when the description gives none.
  virtual const std::vector<std::size_t>& promised_shape() const = 0;
};

}  // namespace somato::modules
