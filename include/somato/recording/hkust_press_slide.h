#pragma once

#include <filesystem>

#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato {

/// Reads presses and slides in the format of the HKUST press-and-slide data set (Dylanliiiii, HKUST
/// 2026): a file `Material_MATERIAL_raw_TRIAL.csv` a run, in the folder or below.
///
/// The explorations have the labels `material` and `trial`, and the channel `force`: the elements
/// Fx, Fy and Fz in N at 97 Hz. That is the sensor's mean rate; the column `time` is passed over
/// because it tells when the host read a row, in bursts, not when the sensor measured. The other
/// columns can be worked out from these and are passed over too.
///
/// Errors: as import_csv_trials().
Result<Recording> import_hkust_press_slide(const std::filesystem::path& folder);

}  // namespace somato
