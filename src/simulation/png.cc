#include "simulation/png.h"

#include <png.h>

#include "files/whole_file.h"
#include "somato/core/check.h"

namespace somato::detail {
namespace {

Result<std::string> png_bytes(const Image& image) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&header, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr) ==
      0) {
    return fail(ErrorKind::kSystem,
                std::string("a picture cannot be compressed: ") + header.message);
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace

void require_picture_size(std::size_t width, std::size_t height) {
  constexpr std::size_t kMost = 16'384;
  require(width > 0 && height > 0 && width <= kMost && height <= kMost,
          "a picture must have 1 to 16384 pixels along each axis");
}

Result<void> write_png(const std::string& path, const Image& image) {
  require_picture_size(image.width, image.height);
  require(image.rgb.size() == 3 * image.width * image.height,
          "a picture needs three bytes for each pixel");
  return png_bytes(image).and_then(
      [&](const std::string& bytes) { return somato::save_whole(path, bytes); });
}

}  // namespace somato::detail
