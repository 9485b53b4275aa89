#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "somato/core/matrix.h"
#include "somato/core/result.h"

namespace somato {

/// Whether `bytes` begin like a file in numpy's NPY format.
bool is_npy(std::string_view bytes);

/// The array in `bytes`, from the source `where`: versions 1 to 3 of numpy's NPY format; float16,
/// float32, float64, integers of 8 to 64 bits and booleans; either byte order; C or Fortran order.
/// An array of one dimension becomes one column. Numbers are rounded to float32. Errors (kData):
/// other types and dimensions, an empty array, a file that is truncated or too long, and, with row
/// and column, a value that is not a finite float32. Source: numpy.lib.format in numpy's
/// documentation.
Result<Matrix<float>> decode_npy(std::string_view bytes, std::string_view where);

/// The array in the file at `path`; see decode_npy() and read_whole().
Result<Matrix<float>> read_npy(const std::string& path);

/// A file of version 1.0 in C order: `<f4` of two dimensions.
std::string encode_npy(const Matrix<float>& matrix);

/// The header of such a file: the bytes before the first number, for writing the rows one by one.
std::string npy_start(std::size_t rows, std::size_t columns);

/// The bytes of numbers in such a file.
std::string npy_numbers(std::span<const float> numbers);

/// A file of integers: `<i8` of one dimension.
std::string encode_npy(std::span<const std::int64_t> numbers);

/// Writes a file of numbers; an earlier one is replaced when all is written.
Result<void> write_npy(const std::string& path, const Matrix<float>& matrix);
/// The same for integers.
Result<void> write_npy(const std::string& path, std::span<const std::int64_t> numbers);

}  // namespace somato
