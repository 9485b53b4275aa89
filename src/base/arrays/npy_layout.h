#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/arrays/npy_header.h"
#include "base/tables/column_precision.h"
#include "base/tables/table_columns.h"
#include "somato/core/matrix.h"
#include "somato/core/result.h"
#include "somato/files/csv.h"

namespace somato {

/// A type of numbers in an NPY file.
struct NpyType {
  std::string_view name;
  std::size_t size;             ///< Bytes of a number.
  double (*read)(const char*);  ///< Turns them into the nearest double.
};

/// The type with that name in numpy's notation, such as "<f4", or nullptr.
const NpyType* npy_type(std::string_view name);

/// Position and type of the numbers of an NPY file.
struct NpyLayout {
  const NpyType* type = nullptr;
  std::size_t rows = 0;
  std::size_t columns = 0;
  bool fortran_order = false;
  std::size_t start = 0;  ///< Bytes before the first number.
  std::vector<std::uint64_t> shape = {};
};

/// The description of an NPY file's array, and the bytes before its first element.
struct NpyStart {
  NpyHeader header;
  std::size_t size = 0;
};

/// The parts of an NPY file that are read.
struct NpyReading {
  TableColumns columns;
  bool keeps_missing = false;  ///< NaN is kept, not refused.
};

/// The number of bytes that contain the length of the header.
inline constexpr std::size_t kNpyStart = 12;

/// The bytes before the first number of a file of `file_size` bytes that begins with `bytes`, of
/// which kNpyStart are enough, or all of it. Errors: kData at `where`.
Result<std::size_t> npy_header_size(std::string_view bytes, std::size_t file_size,
                                    std::string_view where);

/// The start of a file of `file_size` bytes that begins with `bytes`, among them its header.
/// Errors: kData at `where`.
Result<NpyStart> npy_start_of(std::string_view bytes, std::size_t file_size,
                              std::string_view where);

/// The layout of a file of `file_size` bytes that begins with `bytes`, among them its header; an
/// array of one dimension has one column. Errors: kData at `where`.
Result<NpyLayout> npy_layout(std::string_view bytes, std::size_t file_size, std::string_view where);

/// The same for an array of any number of dimensions: the last of two or more are columns, and all
/// others together are rows.
Result<NpyLayout> npy_layout_of_any(std::string_view bytes, std::size_t file_size,
                                    std::string_view where);

/// The parts of a file with that layout that are selected by `options`. Errors (kUsage, at
/// `where`): a label column, a decimal comma, those of choose_columns().
Result<NpyReading> npy_reading(const NpyLayout& layout, const CsvOptions& options,
                               const std::string& where);

/// Writes the numbers of `bytes`, rows of layout.columns numbers beginning with row `first`, to
/// `out`, row by row: those of the columns that are read. In Fortran order `bytes` contain these
/// rows column by column. Errors: kData, with row and column, for a value that is not a finite
/// float32; after the last row those of ColumnPrecision::check(), with the preceding rows in
/// `precision`, unless that is nullptr.
Result<void> read_npy_rows(std::string_view bytes, const NpyLayout& layout,
                           const NpyReading& reading, std::size_t first, std::span<float> out,
                           std::string_view where, ColumnPrecision* precision);

/// All rows of a whole file; see read_npy_rows(). Sets reading.columns.rounded.
Result<Matrix<float>> npy_matrix(std::string_view bytes, const NpyLayout& layout,
                                 NpyReading& reading, std::string_view where);

}  // namespace somato
