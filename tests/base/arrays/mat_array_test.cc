#include "base/arrays/mat_array.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/archives/made_zip.h"
#include "somato/core/random.h"
#include "somato/files/npy.h"

namespace somato {
namespace {

constexpr std::uint32_t kInt8 = 1;
constexpr std::uint32_t kUint8 = 2;
constexpr std::uint32_t kInt32 = 5;
constexpr std::uint32_t kUint32 = 6;
constexpr std::uint32_t kDouble = 9;
constexpr std::uint32_t kMatrix = 14;
constexpr std::uint32_t kCompressed = 15;
constexpr std::uint32_t kCharClass = 4;
constexpr std::uint32_t kSparseClass = 5;
constexpr std::uint32_t kDoubleClass = 6;

std::string mat_element(std::uint32_t type, const std::string& content) {
  std::string bytes;
  append_little_endian(bytes, type);
  append_little_endian(bytes, static_cast<std::uint32_t>(content.size()));
  bytes += content;
  if (type != kCompressed) bytes.resize((bytes.size() + 7) / 8 * 8, '\0');
  return bytes;
}

template <typename T>
std::string mat_numbers(std::uint32_t type, const std::vector<T>& values) {
  std::string content;
  for (const T value : values) append_little_endian(content, value);
  return mat_element(type, content);
}

// A variable with `parts` behind its description; a short name is a small element.
std::string mat_variable(const std::string& name, std::uint32_t kind,
                         std::vector<std::int32_t> shape, const std::string& parts) {
  std::string small;
  append_little_endian(small,
                       std::uint32_t{static_cast<std::uint32_t>(name.size()) << 16U | kInt8});
  small += name;
  small.resize(8, '\0');
  return mat_element(kMatrix, mat_numbers<std::uint32_t>(kUint32, {kind, 0}) +
                                  mat_numbers(kInt32, shape) +
                                  (name.size() <= 4 ? small : mat_element(kInt8, name)) + parts);
}

std::string mat(const std::string& variables) {
  std::string head = "MATLAB 5.0 MAT-file, made by a test";
  head.resize(124, ' ');
  return head + std::string("\0\1IM", 4) + variables;
}

// In the order of columns: 1 3 5 / 2 4 6, whose values fit into bytes.
std::string full(const std::string& name = "x") {
  return mat_variable(name, kDoubleClass, {2, 3},
                      mat_numbers<std::uint8_t>(kUint8, {1, 2, 3, 4, 5, 6}));
}

const Matrix<float> kFull(2, 3, {1, 3, 5, 2, 4, 6});

Result<Matrix<float>> read_mat(const std::string& bytes, const std::string& variable = {}) {
  return npy_in_mat(bytes, "a.mat", variable).and_then([](const std::string& npy) {
    return decode_npy(npy, "a.mat");
  });
}

std::string mat_refusal(const std::string& bytes, const std::string& variable = {}) {
  const auto result = read_mat(bytes, variable);
  return result ? "read" : to_string(result.error());
}

TEST(MatArray, FullMatricesAreStoredByColumns) {
  EXPECT_TRUE(is_mat(mat("")));
  EXPECT_EQ(read_mat(mat(full())).value(), kFull);
  EXPECT_EQ(read_mat(mat(mat_element(kCompressed, deflated(full(), false)))).value(), kFull);
  const std::string doubles =
      mat_variable("touch", kDoubleClass, {1, 2}, mat_numbers<double>(kDouble, {0.1, -2.5}));
  EXPECT_EQ(read_mat(mat(doubles)).value(), Matrix<float>(1, 2, {0.1F, -2.5F}));
}

TEST(MatArray, SparseMatricesAreReadWithTheirZeros) {
  // 0 1.5 0 / 2 0 -3, with room for one more element.
  const std::string sparse = mat_variable("s", kSparseClass, {2, 3},
                                          mat_numbers<std::int32_t>(kInt32, {1, 0, 1, 0}) +
                                              mat_numbers<std::int32_t>(kInt32, {0, 1, 2, 3}) +
                                              mat_numbers<double>(kDouble, {2, 1.5, -3}));
  EXPECT_EQ(read_mat(mat(sparse)).value(), Matrix<float>(2, 3, {0, 1.5F, 0, 2, 0, -3}));
  const std::string beyond = mat_variable("s", kSparseClass, {2, 3},
                                          mat_numbers<std::int32_t>(kInt32, {2, 0, 1}) +
                                              mat_numbers<std::int32_t>(kInt32, {0, 1, 2, 3}) +
                                              mat_numbers<double>(kDouble, {2, 1.5, -3}));
  EXPECT_NE(mat_refusal(mat(beyond)).find("the index 2, which is not below 2"), std::string::npos);
}

TEST(MatArray, TheOnlyMatrixIsReadOrTheNamedOne) {
  const std::string text =
      mat_variable("note", kCharClass, {1, 2}, mat_numbers<std::uint8_t>(kUint8, {'a', 'b'}));
  EXPECT_EQ(read_mat(mat(text + full())).value(), kFull);
  EXPECT_EQ(mat_refusal(mat(full() + full("y"))),
            "a.mat: the file contains several matrices: x, y; select one of these variables");
  EXPECT_EQ(read_mat(mat(full() + full("y")), "y").value(), kFull);
  EXPECT_NE(mat_refusal(mat(full()), "z").find("'z'"), std::string::npos);
  EXPECT_NE(mat_refusal(mat(text), "note").find("'note' is no matrix"), std::string::npos);
  EXPECT_NE(mat_refusal(mat(text)).find("contains no matrix"), std::string::npos);
}

TEST(MatArray, DamageAndOtherVersionsAreNamed) {
  std::string version = mat(full());
  version[125] = 2;
  EXPECT_NE(mat_refusal(version).find("version 7.3"), std::string::npos);
  EXPECT_NE(mat_refusal(mat(full()).substr(0, 180)).find("cut within"), std::string::npos)
      << mat_refusal(mat(full()).substr(0, 180));
  const std::string few =
      mat_variable("x", kDoubleClass, {2, 3}, mat_numbers<std::uint8_t>(kUint8, {1, 2}));
  EXPECT_NE(mat_refusal(mat(few)).find("truncated"), std::string::npos);
  std::string packed = deflated(full(), false);
  packed[packed.size() / 2] ^= 0x55;
  EXPECT_NE(mat_refusal(mat(mat_element(kCompressed, packed))), "read");
}

TEST(MatArray, AnyBytesAreReadOrRefused) {
  Random random(5);
  const std::string bytes = mat(mat_element(kCompressed, deflated(full(), false)) + full("y"));
  for (int i = 0; i < 3000; ++i) {
    std::string changed = bytes;
    for (int k = 0; k < 2; ++k) {
      changed[kMatHeader + random.below(changed.size() - kMatHeader)] =
          static_cast<char>(random.below(256));
    }
    if (i % 3 == 0) changed.resize(kMatHeader + random.below(changed.size() - kMatHeader));
    (void)mat_refusal(changed, i % 2 == 0 ? "y" : "");
  }
}

}  // namespace
}  // namespace somato
