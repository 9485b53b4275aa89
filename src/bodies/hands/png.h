#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "somato/core/result.h"

namespace somato::detail {

/// Red, green and blue for every pixel, row after row from the top left.
struct Image {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint8_t> rgb;  ///< 3 x width x height.
};

/// Throws InvalidArgument unless both lie from 1 to 16384.
void require_picture_size(std::size_t width, std::size_t height);

/// Writes the image as a PNG file, atomically. Errors: kSystem with the system's reason. Throws
/// InvalidArgument if it has no pixels, or a number that differs from its size.
Result<void> write_png(const std::string& path, const Image& image);

/// Reads the bytes of a PNG file; what is transparent becomes white. Errors (kData): damaged bytes;
/// a picture of more than 16384 pixels along an axis.
Result<Image> read_png(std::string_view bytes);

}  // namespace somato::detail
