#pragma once

#include <filesystem>

#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato {

/// Reads impacts in the format of the acoustic hardness data set (Kev-HL, 2026): a JSON file an
/// impact with the objects `metadata` and `audio`, in the folder or below.
///
/// The explorations come in natural order of their paths, with the labels `hardness`
/// (metadata.class), `material` and `release`: "device" where metadata.comment is missing, null or
/// empty, otherwise the comment, in the data set "manual". The channel `sound` has 1 element in
/// counts of 16 bits, at audio.sample_rate.
///
/// Errors: kSystem for what cannot be read; kData with the file, and the place as JSON Pointer or
/// line and column, for a JSON file that is no such impact: wrong syntax, more than 16 levels or 64
/// MiB, members missing or of another type, samples beyond 16 bits, not as many as num_samples,
/// audio.overflow set (samples were lost), a sample_rate of 0 or less; and for two files with the
/// same metadata.sample_id.
Result<Recording> import_acoustic_hardness(const std::filesystem::path& folder);

}  // namespace somato
