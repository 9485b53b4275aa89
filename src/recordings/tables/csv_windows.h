#pragma once

#include <cstddef>
#include <vector>

#include "recordings/tables/csv_trial_reader.h"
#include "somato/recording/csv_import.h"
#include "somato/recording/recording.h"

namespace somato {

/// Rows of a file that become an exploration; all lie in one of its labelled parts.
struct CsvWindow {
  std::size_t first = 0;
  std::size_t rows = 0;
  std::size_t part = 0;
};

/// The windows of a file and the number of rows outside of them. Each begins window - overlap rows
/// after the preceding one, and again where a label changes. The last one of a part may be shorter
/// if the description keeps it.
struct CsvWindows {
  std::vector<CsvWindow> windows;
  std::size_t left_out = 0;
};

CsvWindows windows_of(const CsvTrials& trials, const std::vector<LabelledRows>& parts);

/// The frames of `channel` that are rows of `window`; times count from the first of them. A channel
/// without frames stays so.
Channel cut(const Channel& channel, const CsvWindow& window);

}  // namespace somato
