#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato {

/// A part of a bag that is an exploration, in nanoseconds since the bag's first message.
struct BagSpan {
  std::int64_t begin = 0;
  std::int64_t end = 0;  ///< Not part of it.
  std::vector<Label> labels;
};

/// Reads a CSV file with the columns begin and end (s) and columns with labels. Errors: kSystem
/// for a file that cannot be read; kData with line and column for missing columns, fields without a
/// number, and spans that are empty, overlap or are not in order.
Result<std::vector<BagSpan>> read_span_table(const std::string& path);

}  // namespace somato
