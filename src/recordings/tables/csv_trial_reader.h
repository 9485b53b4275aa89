#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "recordings/tables/csv_columns.h"
#include "recordings/tables/csv_times.h"
#include "somato/core/result.h"
#include "somato/recording/csv_import.h"
#include "somato/recording/recording.h"

namespace somato {

/// Consecutive rows with the same labels in their columns.
struct LabelledRows {
  std::size_t first = 0;
  std::size_t rows = 0;
  std::vector<std::string> values;  ///< In the order of CsvTrials::labels.
};

/// The content of one file. Channels from labels have no frames yet.
struct CsvTrial {
  std::vector<Channel> channels;
  std::vector<LabelledRows> parts;
  CsvClock clock;
};

/// The value of `channel` from a number of a file or its name, or nothing if it is too large.
std::optional<float> csv_value(const CsvChannel& channel, double number);

/// Reads the text of one file, which is `where`. Errors: as import_csv_trials(), also for labels
/// that change in a file that is not divided.
Result<CsvTrial> read_csv_trial(const CsvImport& description, const CsvLayout& layout,
                                CsvFilesInCommon& common, std::string_view text,
                                const std::string& where);

}  // namespace somato
