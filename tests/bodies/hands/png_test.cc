#include "bodies/hands/png.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <string_view>

#include "base/files/whole_file.h"
#include "base/support/places.h"
#include "base/support/temporary_folder.h"
#include "somato/core/check.h"

namespace somato::detail {
namespace {

Image gradient(std::size_t width, std::size_t height) {
  Image image{.width = width, .height = height, .rgb = {}};
  for (std::size_t at = 0; at < 3 * width * height; ++at) {
    image.rgb.push_back(static_cast<std::uint8_t>(at * at % 251));
  }
  return image;
}

std::string as_text(const Image& image) {
  std::string text = fmt::format("{} {} ", image.width, image.height);
  for (const std::uint8_t byte : image.rgb) text += fmt::format("{:02x}", byte);
  return text + "\n";
}

// The content of the file according to a reader that shares nothing with the writer.
std::string read_independently(const std::string& path) {
  const std::string command =
      "python3 '" + source_path("tests/bodies/hands/read_png.py") + "' '" + path + "'";
  FILE* output = popen(command.c_str(), "r");
  std::string text;
  std::array<char, 4096> part{};
  while (const std::size_t count = fread(part.data(), 1, part.size(), output)) {
    text.append(part.data(), count);
  }
  EXPECT_EQ(pclose(output), 0);
  return text;
}

TEST(Png, HoldsThePixels) {
  const TemporaryFolder folder;
  for (const Image& image : {gradient(1, 1), gradient(5, 3), gradient(40, 70)}) {
    const std::string path = folder.file("picture.png");
    ASSERT_TRUE(write_png(path, image));
    EXPECT_EQ(read_independently(path), as_text(image));
  }
}

TEST(Png, IsReadAgain) {
  const TemporaryFolder folder;
  const std::string path = folder.file("picture.png");
  ASSERT_TRUE(write_png(path, gradient(5, 3)));
  std::string bytes = somato::read_whole(path).value();
  const auto image = read_png(bytes);
  ASSERT_TRUE(image);
  EXPECT_EQ(as_text(*image), as_text(gradient(5, 3)));
  for (const std::size_t length : {std::size_t{0}, std::size_t{20}, bytes.size() - 20}) {
    EXPECT_FALSE(read_png(std::string_view(bytes).substr(0, length))) << length;
  }
  bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 0x55);
  EXPECT_FALSE(read_png(bytes));
}

TEST(Png, IsNotThereWhenItCannotBeWritten) {
  const TemporaryFolder folder;
  const auto written = write_png(folder.file("missing/picture.png"), gradient(2, 2));
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().kind, ErrorKind::kSystem);
}

TEST(Png, RefusesImagesThatAreNone) {
  EXPECT_THROW((void)write_png("/nowhere", Image{}), InvalidArgument);
  Image image = gradient(4, 4);
  image.rgb.pop_back();
  EXPECT_THROW((void)write_png("/nowhere", image), InvalidArgument);
  EXPECT_THROW(require_picture_size(16'385, 1), InvalidArgument);
  EXPECT_NO_THROW(require_picture_size(16'384, 1));
}

}  // namespace
}  // namespace somato::detail
