#include "bodies/hands/png.h"

#include <png.h>

#include "base/files/whole_file.h"
#include "somato/core/check.h"

namespace somato::detail {
namespace {

constexpr std::size_t kMostPixels = 16'384;  // along an axis

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
  require(width > 0 && height > 0 && width <= kMostPixels && height <= kMostPixels,
          "a picture must have 1 to 16384 pixels along each axis");
}

Result<void> write_png(const std::string& path, const Image& image) {
  require_picture_size(image.width, image.height);
  require(image.rgb.size() == 3 * image.width * image.height,
          "a picture needs three bytes for each pixel");
  return png_bytes(image).and_then(
      [&](const std::string& bytes) { return somato::save_whole(path, bytes); });
}

Result<Image> read_png(std::string_view bytes) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()) == 0) {
    return fail(ErrorKind::kData, std::string("this is no PNG picture: ") + header.message);
  }
  if (header.width > kMostPixels || header.height > kMostPixels) {
    png_image_free(&header);
    return fail(ErrorKind::kData, "the picture has more than 16384 pixels along an axis");
  }
  header.format = PNG_FORMAT_RGB;
  Image image{header.width, header.height, std::vector<std::uint8_t>(PNG_IMAGE_SIZE(header))};
  const png_color white{255, 255, 255};
  if (png_image_finish_read(&header, &white, image.rgb.data(), 0, nullptr) == 0) {
    return fail(ErrorKind::kData, std::string("the picture is damaged: ") + header.message);
  }
  return image;
}

}  // namespace somato::detail
