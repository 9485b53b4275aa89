#include "base/arrays/npz_array.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "base/arrays/npz_arrays.h"
#include "base/arrays/sparse_rows.h"
#include "base/text/flag_hint.h"
#include "somato/core/parameter.h"

namespace somato {
namespace {

// The text in an array of bytes or characters without dimensions, such as csr: its ASCII.
std::string text_in(const std::string& npy) {
  std::string text;
  const std::size_t header = npy.find('\n');
  for (std::size_t i = std::min(header, npy.size()); i < npy.size(); ++i) {
    if (npy[i] >= 'a' && npy[i] <= 'z') text += npy[i];
  }
  return text;
}

Result<SparseMatrix> sparse_in(const NpzArrays& arrays, const std::string& where) {
  SOMATO_TRY(const std::string format_bytes, arrays.read("format"));
  const std::string format = text_in(format_bytes);
  if (format != "csr" && format != "csc" && format != "coo") {
    return fail(ErrorKind::kData,
                fmt::format("sparse matrices of the format '{}' are not read", format), where,
                "convert it to csr with matrix.tocsr()");
  }
  SOMATO_TRY(const std::vector<double> shape, arrays.numbers("shape"));
  constexpr double kMost = 9007199254740992.0;  // 2^53: all integers below are doubles.
  const bool is_matrix = shape.size() == 2 && shape[0] >= 1.0 && shape[1] >= 1.0 &&
                         shape[0] < kMost && shape[1] < kMost;
  if (!is_matrix) {
    return fail(ErrorKind::kData, "the sparse matrix has no rows or columns", where,
                "save a matrix with at least one of both");
  }
  SparseMatrix matrix{
      static_cast<std::size_t>(shape[0]), static_cast<std::size_t>(shape[1]), {}, {}, {}};
  SOMATO_TRY(matrix.values, arrays.numbers("data"));
  const std::size_t elements = matrix.values.size();
  if (format == "coo") {
    SOMATO_TRY(const std::vector<double> rows, arrays.numbers("row"));
    SOMATO_TRY(const std::vector<double> columns, arrays.numbers("col"));
    SOMATO_TRY(matrix.row, indices_below(rows, matrix.rows, where));
    SOMATO_TRY(matrix.column, indices_below(columns, matrix.columns, where));
  } else {
    const bool is_by_rows = format == "csr";
    SOMATO_TRY(const std::vector<double> starts, arrays.numbers("indptr"));
    SOMATO_TRY(const std::vector<double> indices, arrays.numbers("indices"));
    std::vector<std::size_t>& lines = is_by_rows ? matrix.row : matrix.column;
    std::vector<std::size_t>& places = is_by_rows ? matrix.column : matrix.row;
    const std::size_t lines_count = is_by_rows ? matrix.rows : matrix.columns;
    const std::size_t places_count = is_by_rows ? matrix.columns : matrix.rows;
    SOMATO_TRY(lines, lines_of_starts(starts, lines_count, elements, where));
    SOMATO_TRY(places, indices_below(indices, places_count, where));
  }
  if (matrix.row.size() == elements && matrix.column.size() == elements) return matrix;
  return fail(ErrorKind::kData, "the lists of the sparse matrix do not fit each other", where,
              "save the matrix again");
}

}  // namespace

Result<std::string> npy_in_npz(std::string_view bytes, const std::string& where,
                               const std::string& variable) {
  SOMATO_TRY(const NpzArrays arrays, NpzArrays::open(bytes, where));
  if (variable.empty() && arrays.has("format") && arrays.has("shape")) {
    SOMATO_TRY(const SparseMatrix matrix, sparse_in(arrays, where));
    return npy_of_sparse(matrix, where);
  }
  const std::vector<std::string> names = arrays.names();
  if (!variable.empty() && !arrays.has(variable)) {
    return fail(unknown_name("variable", variable, where, names));
  }
  if (!variable.empty()) return arrays.read(variable);
  if (names.size() == 1) return arrays.read(names.front());
  return fail(ErrorKind::kUsage,
              names.empty()
                  ? std::string("the archive contains no arrays")
                  : fmt::format("the archive contains several arrays: {}", fmt::join(names, ", ")),
              where,
              names.empty() ? "save an array with numpy.savez"
                            : "select one of these variables" + flag_hint("variable"));
}

}  // namespace somato
