#include "hardware/protocols/crc32.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "base/archives/checksum.h"
#include "somato/core/random.h"

namespace somato::wire {
namespace {

std::uint32_t crc32_of(std::string_view text) {
  return crc32({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

// The check value that catalogues of checksums state for this CRC.
TEST(WireCrc32, HasThePublishedCheckValue) {
  EXPECT_EQ(crc32_of("123456789"), 0xCBF43926U);
  EXPECT_EQ(crc32_of(""), 0U);
}

TEST(WireCrc32, EqualsTheChecksumOfFiles) {
  Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    std::string text(random.below(200), '\0');
    for (char& c : text) c = static_cast<char>(random.below(256));
    ASSERT_EQ(crc32_of(text), somato::crc32(text));
  }
}

}  // namespace
}  // namespace somato::wire
