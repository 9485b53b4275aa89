#include "somato/files/npy.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "base/support/temporary_folder.h"
#include "somato/core/random.h"

namespace somato {
namespace {

// Bytes put together from the specification of the format.
std::string number_bytes(std::uint64_t value, int size, bool big = false) {
  std::string bytes;
  for (int i = 0; i < size; ++i) {
    const int shift = 8 * (big ? size - 1 - i : i);
    bytes += static_cast<char>(value >> shift & 0xFF);
  }
  return bytes;
}

std::string file(std::string header, const std::string& values, int version = 1) {
  const int length_size = version == 1 ? 2 : 4;
  while ((8 + static_cast<std::size_t>(length_size) + header.size() + 1) % 64 != 0) header += ' ';
  header += '\n';
  return "\x93NUMPY" + number_bytes(static_cast<std::uint64_t>(version), 1) + number_bytes(0, 1) +
         number_bytes(header.size(), length_size) + header + values;
}

std::string header(const std::string& type, const std::string& shape,
                   const std::string& order = "False") {
  return "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }";
}

std::string float_bytes(std::vector<float> values, bool big = false) {
  std::string bytes;
  for (const float value : values)
    bytes += number_bytes(std::bit_cast<std::uint32_t>(value), 4, big);
  return bytes;
}

std::string double_bytes(std::vector<double> values, bool big = false) {
  std::string bytes;
  for (const double value : values) {
    bytes += number_bytes(std::bit_cast<std::uint64_t>(value), 8, big);
  }
  return bytes;
}

const std::vector<float> kSix = {1, 2, 3, 4, 5.5f, -6};

TEST(Npy, HasTheDocumentedBytes) {
  EXPECT_EQ(encode_npy(Matrix<float>(2, 3, kSix)),
            file(header("<f4", "(2, 3)"), float_bytes(kSix)));
  const std::vector<std::int64_t> winners = {3, -1};
  EXPECT_EQ(encode_npy(winners),
            file(header("<i8", "(2,)"), number_bytes(3, 8) + number_bytes(~0ull, 8)));
}

TEST(Npy, ReadsEveryVersion) {
  for (const int version : {1, 2, 3}) {
    const std::string bytes = file(header("<f4", "(2, 3)"), float_bytes(kSix), version);
    EXPECT_EQ(decode_npy(bytes, "f").value(), Matrix<float>(2, 3, kSix)) << version;
  }
}

TEST(Npy, ReadsBothOrders) {
  const std::string by_columns = float_bytes({1, 4, 2, 5.5f, 3, -6});
  EXPECT_EQ(decode_npy(file(header("<f4", "(2, 3)", "True"), by_columns), "f").value(),
            Matrix<float>(2, 3, kSix));
}

TEST(Npy, ReadsOneDimensionAsOneColumn) {
  EXPECT_EQ(decode_npy(file(header("<f4", "(6,)"), float_bytes(kSix)), "f").value(),
            Matrix<float>(6, 1, kSix));
}

TEST(Npy, ReadsFloatingPointOfEitherByteOrder) {
  const Matrix<float> expected(1, 2, std::vector<float>{0.1f, -3e38f});
  const std::vector<double> doubles = {0.1, -3e38};
  const std::vector<float> floats = {0.1f, -3e38f};
  for (const bool big : {false, true}) {
    const std::string order = big ? ">" : "<";
    EXPECT_EQ(decode_npy(file(header(order + "f4", "(1, 2)"), float_bytes(floats, big)), "f"),
              expected);
    EXPECT_EQ(decode_npy(file(header(order + "f8", "(1, 2)"), double_bytes(doubles, big)), "f"),
              expected);
  }
}

// The values are published examples of binary16, from the least number, 2^-24, to the greatest.
TEST(Npy, ReadsHalfPrecisionInBothByteOrders) {
  const std::pair<std::uint16_t, float> numbers[] = {
      {0x0000, 0.0F},          {0x0001, 5.9604645e-8F}, {0x03ff, 6.0975552e-5F},
      {0x0400, 6.1035156e-5F}, {0x3555, 0.33325195F},   {0x3bff, 0.99951172F},
      {0x3c00, 1.0F},          {0x7bff, 65504.0F},      {0xc000, -2.0F}};
  for (const bool big : {false, true}) {
    for (const auto& [bits, number] : numbers) {
      const std::string bytes =
          file(header(big ? ">f2" : "<f2", "(1,)"), number_bytes(bits, 2, big));
      EXPECT_EQ(decode_npy(bytes, "f").value(), Matrix<float>(1, 1, number)) << number;
    }
    for (const std::uint64_t bits : {0x7c00U, 0xfc00U, 0x7e00U}) {
      EXPECT_FALSE(
          decode_npy(file(header(big ? ">f2" : "<f2", "(1,)"), number_bytes(bits, 2, big)), "f"));
    }
  }
  const std::string negative = file(header("<f2", "(1,)"), number_bytes(0x8000, 2, false));
  EXPECT_TRUE(std::signbit(decode_npy(negative, "f").value()(0, 0)));
}

TEST(Npy, ReadsIntegersOfEverySizeAndByteOrder) {
  for (const int size : {1, 2, 4, 8}) {
    for (const bool big : {false, true}) {
      const std::string order = size == 1 ? "|" : big ? ">" : "<";
      const std::uint64_t all_ones = ~0ull >> (64 - 8 * size);
      const std::string values = number_bytes(all_ones, size, big) + number_bytes(5, size, big);
      const std::string digit = std::to_string(size);
      EXPECT_EQ(decode_npy(file(header(order + "i" + digit, "(2,)"), values), "f").value(),
                Matrix<float>(2, 1, std::vector<float>{-1, 5}));
      EXPECT_EQ(decode_npy(file(header(order + "u" + digit, "(2,)"), values), "f").value(),
                Matrix<float>(2, 1, std::vector<float>{static_cast<float>(all_ones), 5}));
    }
  }
}

TEST(Npy, ReadsBooleans) {
  EXPECT_EQ(decode_npy(file(header("|b1", "(2,)"), std::string("\1\0", 2)), "f").value(),
            Matrix<float>(2, 1, std::vector<float>{1, 0}));
  EXPECT_FALSE(decode_npy(file(header("|b1", "(2,)"), "\1\2"), "f"));
}

TEST(Npy, ReadsHeadersAsAnyNumpyWroteThem) {
  for (const char* text : {"{'descr': '<f4', 'fortran_order': False, 'shape': (2, 3), }",
                           "{'shape': (2, 3), 'fortran_order': False, 'descr': '<f4'}",
                           "{\"descr\":\"<f4\",\"fortran_order\":False,\"shape\":(2,3,)}",
                           "{'descr': '<f4', 'fortran_order': False, 'shape': (2L, 3L), }"}) {
    EXPECT_TRUE(decode_npy(file(text, float_bytes(kSix)), "f")) << text;
  }
}

void expect_npy_refused(const std::string& bytes, const std::string& because) {
  const Result<Matrix<float>> matrix = decode_npy(bytes, "data.npy");
  ASSERT_FALSE(matrix) << because;
  EXPECT_EQ(matrix.error().kind, ErrorKind::kData);
  EXPECT_EQ(matrix.error().where, "data.npy");
  EXPECT_NE(matrix.error().what.find(because), std::string::npos) << to_string(matrix.error());
  EXPECT_FALSE(matrix.error().advice.empty());
}

TEST(Npy, RefusesHeadersNumpyDoesNotWrite) {
  for (const char* text :
       {"", "{}", "{'descr': '<f4', 'fortran_order': False}",
        "{'descr': '<f4', 'fortran_order': False, 'shape': (6)}",
        "{'descr': '<f4', 'fortran_order': False, 'shape': (,)}",
        "{'descr': '<f4', 'fortran_order': False, 'shape': (6,)",
        "{'descr': '<f4', 'fortran_order': False, 'shape': (6,)} x",
        "{'descr': '<f4', 'fortran_order': False, 'shape': (-6,)}",
        "{'descr': '<f4', 'fortran_order': 0, 'shape': (6,)}",
        "{'descr': '<f4', 'descr': '<f4', 'fortran_order': False, 'shape': (6,)}",
        "{'descr': '<f4', 'fortran_order': False, 'shape': (6,), 'more': 1}",
        "{'descr': '<f4' 'fortran_order': False, 'shape': (6,)}",
        "{'descr': '<f4', 'fortran_order': False, 'shape': (99999999999999999999,)}",
        "{'descr': '<f4, 'fortran_order': False, 'shape': (6,)}"}) {
    expect_npy_refused(file(text, float_bytes(kSix)), "not in the format of numpy");
  }
}

TEST(Npy, RefusesOtherTypes) {
  for (const char* type : {"|O", "<c8", "<U4", "<f1", "|f2", "|f4", "f4", "=f4", "<M8[s]", ""}) {
    expect_npy_refused(file(header(type, "(6,)"), float_bytes(kSix)), "are not supported");
  }
  expect_npy_refused(file("{'descr': [('a', '<f4'), ('b', '<i4', (2,))], 'fortran_order': False, "
                          "'shape': (1,), }",
                          std::string(12, '\0')),
                     "'structured' are not supported");
}

TEST(Npy, RefusesOtherDimensions) {
  expect_npy_refused(file(header("<f4", "()"), float_bytes({1})), "0 dimensions");
  expect_npy_refused(file(header("<f4", "(1, 2, 3)"), float_bytes(kSix)), "3 dimensions");
}

TEST(Npy, RefusesEmptyArrays) {
  expect_npy_refused(file(header("<f4", "(0,)"), ""), "empty: 0 x 1");
  expect_npy_refused(file(header("<f4", "(5, 0)"), ""), "empty: 5 x 0");
}

TEST(Npy, RefusesEveryTruncationAndWhatFollows) {
  const std::string bytes = file(header("<f4", "(2, 3)"), float_bytes(kSix));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(decode_npy(bytes.substr(0, size), "f")) << size;
  }
  expect_npy_refused(bytes.substr(0, bytes.size() - 1), "truncated");
  expect_npy_refused(bytes + "x", "1 bytes follow");
}

TEST(Npy, RefusesAbsurdShapes) {
  for (const char* shape : {"(1000000000000,)", "(4294967296, 4294967296)",
                            "(18446744073709551615, 18446744073709551615)",
                            "(4611686018427387905, 1)", "(1, 18446744073709551615)"}) {
    expect_npy_refused(file(header("<f4", shape), float_bytes({1})), "truncated");
  }
}

TEST(Npy, RefusesOtherFilesAndVersions) {
  expect_npy_refused("1,2,3\n", "not an NPY file");
  std::string bytes = file(header("<f4", "(6,)"), float_bytes(kSix));
  bytes[6] = '\4';
  expect_npy_refused(bytes, "version 4.0 is unknown");
}

TEST(Npy, NamesTheRowAndColumnOfWhatIsNotFinite) {
  const float inf = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  expect_npy_refused(file(header("<f4", "(2, 3)"), float_bytes({1, 2, 3, 4, nan, 6})),
                     "nan in row 2, column 2 (counted from 1)");
  expect_npy_refused(file(header("<f4", "(2, 3)", "True"), float_bytes({1, 2, 3, 4, inf, 6})),
                     "inf in row 1, column 3");
  expect_npy_refused(file(header("<f8", "(2,)"), double_bytes({1, -1e39})),
                     "-1e+39 in row 2, column 1");
}

TEST(Npy, KeepsTheBitsOfNumbers) {
  Random random(1);
  std::vector<float> values;
  while (values.size() < 600) {
    const float value = std::bit_cast<float>(random.next());
    if (value - value == 0) values.push_back(value);
  }
  const TemporaryFolder folder;
  ASSERT_TRUE(write_npy(folder.file("a.npy"), Matrix<float>(20, 30, values)));
  const Matrix<float> read = read_npy(folder.file("a.npy")).value();
  ASSERT_EQ(read.rows(), 20u);
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(std::bit_cast<std::uint32_t>(read.values()[i]),
              std::bit_cast<std::uint32_t>(values[i]));
  }
  const std::vector<std::int64_t> winners = {0, 224, 7};
  ASSERT_TRUE(write_npy(folder.file("b.npy"), winners));
  EXPECT_EQ(read_npy(folder.file("b.npy")).value(),
            Matrix<float>(3, 1, std::vector<float>{0, 224, 7}));
  EXPECT_EQ(read_npy(folder.file("missing")).error().kind, ErrorKind::kSystem);
}

}  // namespace
}  // namespace somato
