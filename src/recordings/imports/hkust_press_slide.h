#pragma once

#include <filesystem>

#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato {

/// Reads presses and slides in the format of the HKUST press-and-slide data set (Dylanliiiii, HKUST
/// 2026): one file `Material_MATERIAL_raw_TRIAL.csv` per run, in the folder or its subfolders.
///
/// The explorations have the labels `material` and `trial`, and the channel `force`: the elements
/// Fx, Fy and Fz in N at 97 Hz. That is the sensor's mean rate; the column `time` is ignored
/// because it contains the times at which the host read the rows, in bursts, not those of the
/// measurements. The other columns can be derived from these and are ignored as well.
///
/// Errors: those of import_csv_trials().
Result<Recording> import_hkust_press_slide(const std::filesystem::path& folder);

}  // namespace somato
