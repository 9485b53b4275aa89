#pragma once

#include "maps/training/som_start.h"
#include "somato/core/result.h"
#include "somato/maps/som_training.h"

namespace somato {

/// Trains a map with one sample after the other, for the iterations of its parameters and, if its
/// length is automatic, until checks find no improvement. Fails with kInterrupted if the progress
/// or the observer requests to stop, and as check_bounded() does.
Result<void> train_online(SomStart& start, const TrainingOptions& options);

}  // namespace somato
