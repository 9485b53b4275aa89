#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "files/column_precision.h"
#include "somato/core/result.h"

namespace somato {

/// A type of numbers in an NPY file.
struct NpyType {
  std::string_view name;
  std::size_t size;             ///< Bytes of a number.
  double (*read)(const char*);  ///< Turns them into the nearest double.
};

/// Where an NPY file has its numbers, and which.
struct NpyLayout {
  const NpyType* type = nullptr;
  std::size_t rows = 0;
  std::size_t columns = 0;
  bool fortran_order = false;
  std::size_t start = 0;  ///< Bytes before the first number.
};

/// As many bytes as tell how long the header is.
inline constexpr std::size_t kNpyStart = 12;

/// The bytes before the first number of a file of `file_size` bytes that begins with `bytes`, of
/// which kNpyStart are enough, or all of it. Errors: kData at `where`.
Result<std::size_t> npy_header_size(std::string_view bytes, std::size_t file_size,
                                    std::string_view where);

/// The layout of a file of `file_size` bytes that begins with `bytes`, among them its header.
/// Errors: kData at `where`.
Result<NpyLayout> npy_layout(std::string_view bytes, std::size_t file_size, std::string_view where);

/// Writes the numbers of `bytes`, rows of layout.columns numbers beginning with row `first`, to
/// `out`, row by row. In Fortran order `bytes` hold these rows column by column. Errors: kData,
/// with row and column, for a value that is not a finite float32; after the last row
/// those of ColumnPrecision::check(), which knows the rows read before by `precision`,
/// unless that is nullptr.
Result<void> read_npy_rows(std::string_view bytes, const NpyLayout& layout, std::size_t first,
                           std::span<float> out, std::string_view where,
                           ColumnPrecision* precision);

}  // namespace somato
