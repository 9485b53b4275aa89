#pragma once

#include <cstddef>
#include <string>

#include "base/files/whole_file.h"
#include "somato/core/result.h"
#include "somato/files/csv.h"

namespace somato {

/// The table in the file at `path`: NPY, NPZ or MAT if it begins as these do, otherwise CSV.
/// Errors: see read_whole(), decode_npy(), npy_in_npz(), npy_in_mat() and parse_csv(); kUsage for a
/// label column or a decimal comma of a file that is not CSV; kData for more than `limit` bytes.
Result<NumberTable> read_numbers(const std::string& path, const CsvOptions& options = {},
                                 std::size_t limit = kLargestFile);

}  // namespace somato
