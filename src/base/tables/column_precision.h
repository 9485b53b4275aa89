#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "somato/core/result.h"

namespace somato {

/// Checks the loss of single precision in the columns of a table: times since 1970, for example,
/// are equal within minutes.
class ColumnPrecision {
 public:
  /// Adds a number of a column, as in the file and as stored.
  void take(std::size_t column, double exact, float kept);

  /// Fails (kData) when what rounding changes in a column has a root mean square above a twentieth
  /// of the column's standard deviation; a column without deviation keeps all there is. `names` may
  /// be empty.
  Result<void> check(const std::vector<std::string>& names, std::string_view where) const;

 private:
  struct Column {
    double count = 0.0;
    double mean = 0.0;
    double squares = 0.0;  // of the deviations from the mean
    double lost = 0.0;     // squares of what rounding changes
    double example = 0.0;
  };

  std::vector<Column> columns_;
};

}  // namespace somato
