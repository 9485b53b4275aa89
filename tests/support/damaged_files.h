#pragma once

#include <gtest/gtest.h>

#include <string>

#include "somato/core/error.h"
#include "support/temporary_folder.h"

namespace somato::testing {

/// Expects `load(path)` to refuse the file `bytes` as data, with a message that names the file.
template <typename Load>
void expect_file_refused(const TemporaryFolder& folder, const std::string& bytes, const Load& load,
                         const std::string& which) {
  const std::string path = folder.with("damaged.somato", bytes);
  const auto loaded = load(path);
  ASSERT_FALSE(loaded) << which;
  EXPECT_EQ(loaded.error().kind, ErrorKind::kData) << which;
  EXPECT_NE(to_string(loaded.error()).find(path), std::string::npos) << to_string(loaded.error());
}

/// Expects `load` to refuse the file at `path` however short it is cut and whichever bit is turned.
template <typename Load>
void expect_damage_refused(const TemporaryFolder& folder, const std::string& path,
                           const Load& load) {
  const std::string whole = bytes_of(path);
  ASSERT_TRUE(load(path));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    expect_file_refused(folder, whole.substr(0, size), load, "cut to " + std::to_string(size));
  }
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    std::string turned = whole;
    turned[bit / 8] = static_cast<char>(turned[bit / 8] ^ (1 << bit % 8));
    expect_file_refused(folder, turned, load, "bit " + std::to_string(bit));
  }
}

}  // namespace somato::testing
