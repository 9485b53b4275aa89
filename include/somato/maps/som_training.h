#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "somato/core/progress.h"
#include "somato/core/random.h"
#include "somato/core/result.h"
#include "somato/core/sample_source.h"
#include "somato/core/samples.h"
#include "somato/maps/som.h"
#include "somato/maps/som_parameters.h"

namespace somato {

/// How training runs, as far as the trained map does not depend on it.
struct TrainingOptions {
  std::size_t threads = 1;
  Progress progress;  ///< Told iterations, or epochs, or parts of samples in all epochs.
};

/// Trains a map on `samples`. Where they are sparse and use fewer than half of the elements, and
/// weights do not start uniform, the map keeps weights for the elements they use: all others would
/// be exactly 0, and the ones it keeps are the same bits. The same parameters and samples give the
/// same bits for every number of threads, instruction set and compiler.
///
/// Fails with kUsage when the parameters contradict each other, with kData when there are no
/// samples, they have no elements or a length outside 1e-15 .. 1e18, with kInterrupted when the
/// progress says stop.
Result<Som> train_som(const SomParameters& parameters, const Samples& samples,
                      const TrainingOptions& options = {});

/// The same for samples that need not fit into memory, in batch training: the same bits as from
/// Samples that are dense, however they are parted. They are gone through once before training,
/// once more where weights start at samples, and once an epoch.
///
/// Fails also as the source does, and with kUsage when training is online: that draws from all
/// samples at any time.
Result<Som> train_som(const SomParameters& parameters, SampleSource& samples,
                      const TrainingOptions& options = {});

/// The map that train_som() starts from, which has learned nothing yet. `samples` decide automatic
/// parameters and initial weights. Fails as train_som() does.
Result<Som> untrained_som(const SomParameters& parameters, const Samples& samples);

/// Goes on training `som` on `samples` by its own parameters, from its weights as they are. Online
/// training on the weights themselves or batch training; `som` keeps its weights when it fails.
Result<void> continue_som(Som& som, const Samples& samples, const TrainingOptions& options = {});

/// The order in which online training draws samples: a function of the seed.
class DrawSequence {
 public:
  DrawSequence(Draws draws, std::size_t samples, std::uint64_t seed);

  /// The number of the next sample.
  std::size_t next();

 private:
  Draws draws_;
  std::size_t samples_;
  Random random_;
  std::vector<std::size_t> left_;
};

/// The samples as a map with these (resolved) parameters sees them: `samples` itself, or `storage`
/// filled with samples scaled to length 1 where the map normalizes its input.
const Samples& prepared_samples(const SomParameters& parameters, const Samples& samples,
                                Samples& storage);

}  // namespace somato
