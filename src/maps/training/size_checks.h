#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/maps/som_parameters.h"

namespace somato {

/// A square map, and the mean distance from its winners of samples that it has not learned.
struct SizeCheck {
  std::size_t neurons = 0;
  double error = 0.0;
};

/// The measured size of a map.
struct MeasuredSize {
  double share = 1.0;             ///< Neurons for each sample that is learned; 1 is the greatest.
  std::vector<SizeCheck> checks;  ///< In the order of the measurement; the last one may be worse.
};

/// The number of neurons by measured convergence: maps learn four of five samples in batches, and
/// the distance of each fifth one is measured. From a sixteenth of as many neurons as samples to
/// learn the number is doubled until twice as many are not clearly better (is_clearly_better()), or
/// there are as many neurons as samples. Without labels, and the same for any number of threads.
///
/// Fewer than five samples are not measured. `proceed` is called before each map. Errors: those of
/// training and of `proceed`.
Result<MeasuredSize> measured_size(const Samples& samples, Similarity similarity,
                                   std::size_t threads,
                                   const std::function<Result<void>()>& proceed);

}  // namespace somato
