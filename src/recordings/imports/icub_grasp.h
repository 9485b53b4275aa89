#pragma once

#include <filesystem>

#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato {

/// Reads grasps in the text format of the iCub grasp data set (Soh, Su and Demiris, IROS 2012): a
/// file `OBJECT_TRIAL.txt` a grasp, holding the marker -10000 and then seven lines of numbers
/// between blanks a time step.
///
/// `folder` holds these files, or a folder `trials` with them; only files named *.txt are read. The
/// explorations come in the order of object name and trial number, with the labels `object` and
/// `trial`. Their channels, whose sampling rate is unknown:
/// - `joints`: 9 elements, deg (line 1 of a step);
/// - `finger_pressure`: 5 elements, counts (line 2), kept as written: about 255 less the lowest
///   taxel of each finger, but in the data set a third of them lie a few counts off;
/// - `taxels`: 60 elements, 12 a finger from thumb to little finger, raw counts of 0 to 255, lower
///   for more pressure (lines 3 to 7).
///
/// Errors: kSystem for a folder or file that cannot be read; kData for a folder without trials, a
/// name or content in another format, and numbers that are not finite, with file, line and column.
Result<Recording> import_icub_grasp(const std::filesystem::path& folder);

}  // namespace somato
