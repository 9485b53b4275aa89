#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "somato/core/result.h"

namespace somato {

/// The first bytes of an NPY file.
inline constexpr std::string_view kNpyMagic = "\x93NUMPY";

/// The description of an NPY file's array.
struct NpyHeader {
  std::string type;  ///< In numpy's notation: "<f4", "|b1"; "structured" for a list of fields.
  bool fortran_order = false;
  std::vector<std::uint64_t> shape;
};

/// Reads the header's text, a Python dictionary of exactly the keys descr, fortran_order and shape.
/// Errors: kData at `where`.
Result<NpyHeader> parse_npy_header(std::string_view text, std::string_view where);

/// The bytes before the first number of a file of version 1.0, of a type in numpy's notation.
std::string npy_file_start(std::string_view type, std::span<const std::size_t> shape,
                           bool fortran_order = false);

}  // namespace somato
