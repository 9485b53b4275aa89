#include "view/film.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <thread>
#include <utility>

#include "base/files/whole_file.h"
#include "somato/core/check.h"

namespace somato::program {
namespace {

constexpr auto kEncodingTime = std::chrono::minutes(10);  // for the last frames

using Colour = std::array<double, 3>;

Colour colour_at(const detail::Image& picture, std::size_t row, std::size_t column) {
  const std::uint8_t* rgb = &picture.rgb[3 * (row * picture.width + column)];
  return {rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0};
}

// The mean of the square of pixels that begins there.
Colour colour_of_four(const detail::Image& picture, std::size_t row, std::size_t column) {
  Colour sum{};
  for (const std::size_t i : {0U, 1U}) {
    for (const std::size_t j : {0U, 1U}) {
      const Colour one = colour_at(picture, row + i, column + j);
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += one[k] / 4.0;
    }
  }
  return sum;
}

char quantized(double value) {
  return static_cast<char>(static_cast<std::uint8_t>(std::lround(value)));
}

// ITU-R BT.709, section 3: luminance, and the differences of blue and red from it.
double luminance(const Colour& colour) {
  return 0.2126 * colour[0] + 0.7152 * colour[1] + 0.0722 * colour[2];
}
double blue_difference(const Colour& colour) {
  return (colour[2] - luminance(colour)) / 1.8556;
}
double red_difference(const Colour& colour) {
  return (colour[0] - luminance(colour)) / 1.5748;
}

}  // namespace

std::string y4m_frame(const detail::Image& picture) {
  const auto [width, height] = std::pair(picture.width, picture.height);
  require(width % 2 == 0 && height % 2 == 0, "a film needs an even width and height");
  std::string frame = "FRAME\n";
  frame.reserve(frame.size() + width * height * 3 / 2);
  for (std::size_t row = 0; row < height; ++row) {
    for (std::size_t column = 0; column < width; ++column) {
      frame.push_back(quantized(16.0 + 219.0 * luminance(colour_at(picture, row, column))));
    }
  }
  for (const auto difference : {blue_difference, red_difference}) {
    for (std::size_t row = 0; row < height; row += 2) {
      for (std::size_t column = 0; column < width; column += 2) {
        frame.push_back(
            quantized(128.0 + 224.0 * difference(colour_of_four(picture, row, column))));
      }
    }
  }
  return frame;
}

Result<Film> Film::begin(std::size_t width, std::size_t height) {
  SOMATO_TRY(auto folder, ScratchFolder::create());
  const unsigned threads = std::max(1U, std::thread::hardware_concurrency());
  auto encoder = ChildProcess::start(
      {"vpxenc", "--codec=vp9", "--webm", "--passes=1", "--good", "--cpu-used=5", "--end-usage=q",
       "--cq-level=28", "--row-mt=1", "--color-space=bt709", fmt::format("--threads={}", threads),
       "--quiet", "--output=" + folder.path() + "/film.webm", "-"},
      {STDIN_FILENO});
  if (!encoder) {
    return fail(ErrorKind::kSystem, "films require the encoder vpxenc", "vpxenc",
                "install it, on Debian with: sudo apt-get install vpx-tools");
  }
  SOMATO_TRY_VOID(encoder->send(
      fmt::format("YUV4MPEG2 W{} H{} F{}:1 Ip A1:1 C420jpeg\n", width, height, kFilmRate)));
  return Film(std::move(folder), std::move(*encoder));
}

Result<void> Film::save(const std::string& path) {
  return encoder_.finish(kEncodingTime)
      .and_then([&] { return read_whole(folder_.path() + "/film.webm"); })
      .and_then([&](const std::string& bytes) { return save_whole(path, bytes); });
}

}  // namespace somato::program
