#pragma once

#include <optional>
#include <vector>

#include "base/tables/csv_records.h"
#include "somato/core/result.h"
#include "somato/files/csv.h"

namespace somato {

/// Reads the first record of a text into `fields`, and returns the separator of its fields:
/// `given`, or the one that is declared or probable; see CsvOptions. Errors: kData as
/// CsvRecords::next(); kUsage (at the line) for commas between fields with a decimal comma.
Result<char> begin_csv(CsvRecords& records, DecimalMark decimal, std::optional<char> given,
                       std::vector<CsvField>& fields);

}  // namespace somato
