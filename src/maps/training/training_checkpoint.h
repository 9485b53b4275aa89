#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "maps/training/length_checks.h"
#include "maps/training/source_preparation.h"
#include "somato/core/result.h"
#include "somato/maps/som.h"

namespace somato {

/// A map after some epochs of batch training, in a file from which training continues.
struct TrainingCheckpoint {
  std::uint64_t epochs = 0;  ///< Completed ones.
  Som som;
  LengthChecks::State checks = {};  ///< Only stored if the length of training is automatic.
};

/// A text that identifies a training: that of a map with these resolved parameters on samples of
/// this survey.
std::string training_identity(const SomParameters& parameters, const SampleSurvey& survey);

/// Saves atomically. Errors: kSystem.
Result<void> save_checkpoint(const std::string& path, const std::string& identity,
                             const TrainingCheckpoint& checkpoint);

/// The checkpoint at `path`, or nothing if there is no such file. Errors: kSystem; kUsage for the
/// checkpoint of another training, kData for a damaged file or another one.
Result<std::optional<TrainingCheckpoint>> load_checkpoint(const std::string& path,
                                                          const std::string& identity);

}  // namespace somato
