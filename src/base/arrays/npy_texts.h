#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "somato/core/result.h"

namespace somato {

/// The bytes of an NPY file of texts in UTF-8: an array of Unicode characters ("<U5"), which numpy
/// reads without pickle. Without dimensions it is a single text. Characters U+0000 at the end of a
/// text are lost.
std::string npy_of_texts(const std::vector<std::string>& texts, std::span<const std::size_t> shape);

/// The same for a list.
std::string npy_of_texts(const std::vector<std::string>& texts);

/// The texts of such a file, from the source `where`, in row-major order; arrays have at most one
/// dimension. Errors (kData): an array of another type, a file that is truncated or too long, and
/// numbers that are no characters.
Result<std::vector<std::string>> texts_in_npy(std::string_view bytes, std::string_view where);

}  // namespace somato
