#pragma once

#include <string>
#include <string_view>

#include "somato/core/result.h"

namespace somato {

/// Whether `bytes`, at least the first 128 of a file, begin like a MAT-file of version 5 to 7.3.
bool is_mat(std::string_view bytes);

/// The number of bytes that is_mat() needs.
inline constexpr std::size_t kMatHeader = 128;

/// A matrix of a MAT-file in `bytes`, from the source `where`, as the bytes of an NPY file: the
/// variable of that name, or the only matrix of numbers if `variable` is empty. Full and sparse
/// matrices of real numbers and logical values are read, compressed or not, in either byte order.
/// Errors: kData for a damaged file, one of version 7.3 (HDF5) and a variable that is no such
/// matrix; kUsage, with the names, for a variable that does not exist or is not named; those of
/// npy_of_sparse(). Source: MathWorks, MAT-File Format, chapter 1 (Level 5 MAT-files).
Result<std::string> npy_in_mat(std::string_view bytes, const std::string& where,
                               const std::string& variable);

}  // namespace somato
