#pragma once

#include <filesystem>

#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato {

/// Reads slides over fabrics in the format of the FabricSlide data set (Wang et al., Frontiers in
/// Neurorobotics 2022): a file `FABRIC_Fforce_Vvelocitymmps_TRIAL.csv` a slide, in the folder or
/// below.
///
/// The explorations have the labels `fabric`, `force` (the commanded grip, in mean counts of a
/// taxel), `velocity` (mm/s, negative downwards) and `trial`, and the channels:
/// - `touch`: 16 elements, counts after the logger's zero calibration, with times (28 ms apart);
/// - `speed`: 1 element, mm/s without its sign, one frame.
///
/// Errors: as import_csv_trials().
Result<Recording> import_fabricslide(const std::filesystem::path& folder);

}  // namespace somato
