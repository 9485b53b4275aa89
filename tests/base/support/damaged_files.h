#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "base/support/temporary_folder.h"
#include "somato/core/result.h"

namespace somato::testing {

/// Expects `load(path)` to refuse the file as data, with a message that names it.
template <typename Load>
void expect_file_refused(const std::string& path, const Load& load, const std::string& which) {
  const auto loaded = load(path);
  ASSERT_FALSE(loaded) << which;
  EXPECT_EQ(loaded.error().kind, ErrorKind::kData) << which;
  EXPECT_NE(to_string(loaded.error()).find(path), std::string::npos) << to_string(loaded.error());
}

/// Expects `load` to refuse the file at `path` whichever bit is turned and however short it is cut;
/// the file is empty afterwards.
template <typename Load>
void expect_damage_refused(const std::string& path, const Load& load) {
  const std::string whole = bytes_of(path);
  ASSERT_TRUE(load(path));
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    const auto place = static_cast<std::streamoff>(bit / 8);
    file.seekp(place).put(static_cast<char>(whole[bit / 8] ^ (1 << bit % 8))).flush();
    expect_file_refused(path, load, "bit " + std::to_string(bit));
    file.seekp(place).put(whole[bit / 8]).flush();
  }
  ASSERT_TRUE(load(path));
  for (std::size_t size = whole.size(); size-- > 0;) {
    std::filesystem::resize_file(path, size);
    expect_file_refused(path, load, "cut to " + std::to_string(size));
  }
}

}  // namespace somato::testing
