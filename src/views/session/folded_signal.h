#pragma once

#include <cstddef>
#include <vector>

#include "somato/core/signal.h"

namespace somato::live {

/// A signal made small enough to be shown.
struct FoldedSignal {
  std::vector<std::size_t> shape;
  std::vector<float> values;  ///< Row-major.
  bool folded = false;        ///< Whether values were added up.
};

/// The signal of that shape in at most `most` numbers: summed over as many of its leading axes as
/// it takes; a last axis that is still longer, over stretches of neighbours, the last one shorter.
/// Throws InvalidArgument when `most` is 0.
FoldedSignal fold_signal(const SignalView& signal, const std::vector<std::size_t>& shape,
                         std::size_t most);

}  // namespace somato::live
