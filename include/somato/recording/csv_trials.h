#pragma once

#include <cstddef>
#include <filesystem>

#include "somato/core/result.h"
#include "somato/recording/csv_import.h"
#include "somato/recording/recording.h"

namespace somato {

/// What an import leaves out because it does not fill a window.
struct CsvLeftOut {
  std::size_t rows = 0;   ///< That are in no window.
  std::size_t files = 0;  ///< That have no window at all.
};

/// Reads a folder of CSV files, one a trial, as `description` says; `folder` may also be one file.
///
/// Files of the pattern's ending are looked for in the folder and all below it; the pattern is
/// matched with as many last parts of their path as it has itself. A name that it fits in more than
/// one way is refused, and so are, unless the description says otherwise, names that it does not
/// fit, columns that are not mentioned and fields without a number.
///
/// A file is one exploration, or one a window, or one a row. The explorations come in natural order
/// of files (trial 2 before trial 10) with the labels of their file's name and of their columns,
/// and its path as source. Those of divided files have the labels `file`, the path below the
/// folder, and `window` or `row`, which counts from 1 in each file. Windows begin window - overlap
/// rows apart, and anew where a label of a column changes; rows that fill no window are left out.
///
/// A channel of columns has a frame a row and the columns as names of its elements; one from a
/// label has one frame, and neither times nor rate. A pattern takes the columns that fit it and
/// that are named nowhere and not ignored, in the order of the first file. Times are seconds since
/// the exploration's first row, in double precision: of nanoseconds since 1970 the last two digits
/// are lost.
///
/// The text is as in parse_csv(): any separator, quotes, comments, ends of lines, a byte order
/// mark. Errors: as check_csv_import(); kSystem for what cannot be read; kData with file, line and
/// column for what is not as described, ragged rows, times that run backwards, files without rows,
/// labels that are missing or that change in a file that is not divided, patterns without columns
/// or with others than in the first file, ignored columns that are in no file, no window at all.
Result<Recording> import_csv_trials(const std::filesystem::path& folder,
                                    const CsvImport& description, CsvLeftOut* left_out = nullptr);

}  // namespace somato
