#pragma once

#include <filesystem>

#include "somato/core/result.h"
#include "somato/recording/csv_import.h"
#include "somato/recording/recording.h"

namespace somato {

/// Reads a folder of CSV files, one a trial, as `description` says.
///
/// Files of the pattern's ending are looked for in the folder and all below it; the pattern is
/// matched with as many last parts of their path as it has itself. A name that it fits in more than
/// one way is refused, and so are, unless the description says otherwise, names that it does not
/// fit, columns that are not mentioned and fields without a number.
///
/// The explorations come in natural order (trial 2 before trial 10) with the labels of their file's
/// name, and their path as source. A channel of columns has a frame a row and the columns as names
/// of its elements; one from a label has one frame, and neither times nor rate. Times are seconds
/// since the first row, in double precision: of nanoseconds since 1970 the last two digits are
/// lost.
///
/// The text is as in parse_csv(): any separator, quotes, comments, ends of lines, a byte order
/// mark. Errors: as check_csv_import(); kSystem for what cannot be read; kData with file, line and
/// column for what is not as described, ragged rows, times that run backwards, files without rows.
Result<Recording> import_csv_trials(const std::filesystem::path& folder,
                                    const CsvImport& description);

}  // namespace somato
