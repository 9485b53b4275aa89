#include "base/archives/checksum.h"

#include <gtest/gtest.h>

#include <string>

#include "somato/core/random.h"

namespace somato {
namespace {

// Polynomial division bit by bit, most significant bit first, on reflected bytes.
std::uint32_t bitwise_crc(const std::string& bytes, std::uint32_t polynomial) {
  std::uint32_t remainder = 0xFFFFFFFF;
  for (const char c : bytes) {
    for (int bit = 0; bit < 8; ++bit) {
      const std::uint32_t in = (static_cast<unsigned char>(c) >> bit) & 1u;
      const bool subtract = ((remainder >> 31) ^ in) != 0;
      remainder = (remainder << 1) ^ (subtract ? polynomial : 0);
    }
  }
  std::uint32_t reflected = 0;
  for (int bit = 0; bit < 32; ++bit) reflected |= ((remainder >> bit) & 1u) << (31 - bit);
  return ~reflected;
}

// The check value of the catalogue of CRCs, and the examples of RFC 3720, appendix B.4.
TEST(Crc32c, HasThePublishedCheckValues) {
  EXPECT_EQ(crc32c(""), 0u);
  EXPECT_EQ(crc32c("123456789"), 0xE3069283u);
  EXPECT_EQ(crc32c(std::string(32, '\0')), 0x8A9136AAu);
  EXPECT_EQ(crc32c(std::string(32, '\xFF')), 0x62A8AB43u);
  std::string rising;
  for (char c = 0; c < 32; ++c) rising += c;
  EXPECT_EQ(crc32c(rising), 0x46DD794Eu);
}

TEST(Crc32c, AgreesWithDivisionBitByBit) {
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    std::string bytes(random.below(80), '\0');
    for (char& c : bytes) c = static_cast<char>(random.below(256));
    EXPECT_EQ(crc32c(bytes), bitwise_crc(bytes, 0x1EDC6F41));
  }
}

// The check value of the catalogue of CRCs; the others are those of zlib's crc32().
TEST(Crc32, HasThePublishedCheckValues) {
  EXPECT_EQ(crc32(""), 0u);
  EXPECT_EQ(crc32("123456789"), 0xCBF43926u);
  EXPECT_EQ(crc32(std::string(32, '\0')), 0x190A55ADu);
  EXPECT_EQ(crc32(std::string(32, '\xFF')), 0xFF6CAB0Bu);
}

TEST(Crc32, AgreesWithDivisionBitByBitInAnyPieces) {
  Random random(2);
  for (int i = 0; i < 500; ++i) {
    std::string bytes(random.below(80), '\0');
    for (char& c : bytes) c = static_cast<char>(random.below(256));
    const std::string_view all = bytes;
    const std::size_t cut = random.below(bytes.size() + 1);
    Crc32 pieces;
    pieces.add(all.substr(0, cut));
    pieces.add(all.substr(cut));
    EXPECT_EQ(pieces.value(), bitwise_crc(bytes, 0x04C11DB7));
  }
}

// The test vectors of draft-eastlake-fnv.
TEST(Fnv1a64, HasThePublishedValuesAndContinues) {
  EXPECT_EQ(fnv1a64(""), 0xCBF29CE484222325U);
  EXPECT_EQ(fnv1a64("a"), 0xAF63DC4C8601EC8CU);
  EXPECT_EQ(fnv1a64("foobar"), 0x85944171F73967E8U);
  EXPECT_EQ(fnv1a64("bar", fnv1a64("foo")), fnv1a64("foobar"));
}

}  // namespace
}  // namespace somato
