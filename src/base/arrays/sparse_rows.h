#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "somato/core/result.h"

namespace somato {

/// The elements of a sparse matrix that are stored; elements at the same place are added.
struct SparseMatrix {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<std::size_t> row;     ///< One per element, from 0.
  std::vector<std::size_t> column;  ///< One per element, from 0.
  std::vector<double> values;       ///< One per element.
};

/// One index per element of a compressed list: element k belongs to line i if
/// `starts[i] <= k < starts[i + 1]`. Errors (kData, at `where`): starts that do not ascend from 0
/// to `elements`.
Result<std::vector<std::size_t>> lines_of_starts(const std::vector<double>& starts,
                                                 std::size_t lines, std::size_t elements,
                                                 std::string_view where);

/// `numbers` as indices below `limit`. Errors (kData, at `where`): numbers that are none.
Result<std::vector<std::size_t>> indices_below(const std::vector<double>& numbers,
                                               std::size_t limit, std::string_view where);

/// The matrix with all its elements, as the bytes of an NPY file of float64. Errors (kSystem, at
/// `where`): it exceeds a quarter of the available memory.
Result<std::string> npy_of_sparse(const SparseMatrix& matrix, std::string_view where);

}  // namespace somato
