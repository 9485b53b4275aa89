#pragma once

#include <string>
#include <vector>

#include "somato/core/matrix.h"

namespace somato {

/// Numbers in rows and columns as a file holds them.
struct NumberTable {
  std::vector<std::string> names;   ///< Of the columns of `values`; empty when there are none.
  Matrix<float> values;             ///< All finite; where missing numbers are kept, these are NaN.
  std::vector<std::string> labels;  ///< One a row; empty when there is no label column.

  bool operator==(const NumberTable&) const = default;
};

}  // namespace somato
