#include "base/arrays/sparse_rows.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "base/archives/little_endian.h"
#include "base/arrays/npy_header.h"
#include "base/core/memory.h"

namespace somato {
namespace {

tl::unexpected<Error> bad(std::string what, std::string_view where) {
  return fail(ErrorKind::kData, std::move(what), std::string(where), "save the matrix again");
}

}  // namespace

Result<std::vector<std::size_t>> indices_below(const std::vector<double>& numbers,
                                               std::size_t limit, std::string_view where) {
  std::vector<std::size_t> indices;
  indices.reserve(numbers.size());
  for (const double number : numbers) {
    const bool is_index =
        number >= 0.0 && number < static_cast<double>(limit) && std::floor(number) == number;
    if (!is_index) {
      return bad(
          fmt::format("the sparse matrix has the index {}, which is not below {}", number, limit),
          where);
    }
    indices.push_back(static_cast<std::size_t>(number));
  }
  return indices;
}

Result<std::vector<std::size_t>> lines_of_starts(const std::vector<double>& starts,
                                                 std::size_t lines, std::size_t elements,
                                                 std::string_view where) {
  SOMATO_TRY(const std::vector<std::size_t> places, indices_below(starts, elements + 1, where));
  bool fits = places.size() == lines + 1 && places.front() == 0 && places.back() == elements;
  std::vector<std::size_t> line_of;
  line_of.reserve(elements);
  for (std::size_t line = 0; fits && line < lines; ++line) {
    fits = places[line] <= places[line + 1];
    if (fits) line_of.resize(places[line + 1], line);
  }
  if (fits) return line_of;
  return bad("the lists of the sparse matrix do not fit each other", where);
}

Result<std::string> npy_of_sparse(const SparseMatrix& matrix, std::string_view where) {
  const double size = static_cast<double>(matrix.rows) * static_cast<double>(matrix.columns) *
                      static_cast<double>(sizeof(double));
  if (size > static_cast<double>(free_memory()) / 4.0) {
    return fail(ErrorKind::kSystem,
                fmt::format("the sparse matrix has {} x {} elements, which take {}", matrix.rows,
                            matrix.columns, memory_text(size)),
                std::string(where), "select columns before it is saved, or save its rows in parts");
  }
  std::vector<double> all(matrix.rows * matrix.columns, 0.0);
  for (std::size_t i = 0; i < matrix.values.size(); ++i) {
    all[matrix.row[i] * matrix.columns + matrix.column[i]] += matrix.values[i];
  }
  std::string bytes = npy_file_start("<f8", std::array{matrix.rows, matrix.columns});
  bytes.reserve(bytes.size() + all.size() * sizeof(double));
  for (const double value : all) append_little_endian(bytes, value);
  return bytes;
}

}  // namespace somato
