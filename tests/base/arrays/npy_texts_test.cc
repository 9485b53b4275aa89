#include "base/arrays/npy_texts.h"

#include <gtest/gtest.h>

#include <array>

#include "base/archives/little_endian.h"
#include "base/arrays/npy_header.h"

namespace somato {
namespace {

using Texts = std::vector<std::string>;

TEST(NpyTexts, AreTheSameWhenRead) {
  for (const Texts& texts :
       {Texts{""}, Texts{"", "a"}, Texts{"\xC3\xA4\xE2\x82\xAC\xF0\x9F\x96\x90", "x"},
        Texts{std::string("a\0b", 3)}, Texts{"\x7F", "\xF4\x8F\xBF\xBF"}}) {
    EXPECT_EQ(texts_in_npy(npy_of_texts(texts), "f").value(), texts);
  }
  EXPECT_EQ(texts_in_npy(npy_of_texts({"one"}, {}), "f").value(), Texts{"one"});
}

std::string raw(const std::string& type, std::size_t count,
                const std::vector<std::uint32_t>& points) {
  std::string bytes = npy_file_start(type, std::array{count});
  for (const std::uint32_t point : points) append_little_endian(bytes, point);
  return bytes;
}

TEST(NpyTexts, AreRefusedIfTheyAreNone) {
  EXPECT_TRUE(texts_in_npy(raw("<U1", 2, {65, 66}), "f"));
  for (const std::string& bytes :
       {raw("<U1", 3, {65, 66}), raw("<U2", 2, {65, 66}), raw("<U0", 2, {}), raw("<U", 1, {65}),
        raw("<U1x", 1, {65}), raw("<i4", 1, {65}), raw(">U1", 1, {65}), raw("<U1", 1, {0x110000}),
        raw("<U1", 1, {0xD800}), raw("<U1", std::size_t{1} << 62, {65}),
        raw("<U4611686018427387904", 1, {65}), std::string("\x93NUMPY")}) {
    const auto texts = texts_in_npy(bytes, "f");
    ASSERT_FALSE(texts) << bytes;
    EXPECT_EQ(texts.error().kind, ErrorKind::kData);
  }
  const std::array<std::size_t, 2> table{1, 1};
  EXPECT_FALSE(texts_in_npy(npy_of_texts({"x"}, table), "f"));
}

}  // namespace
}  // namespace somato
