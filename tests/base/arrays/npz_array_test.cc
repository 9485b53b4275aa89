#include "base/arrays/npz_array.h"

#include <gtest/gtest.h>

#include <array>

#include "base/archives/made_zip.h"
#include "base/arrays/npy_header.h"
#include "base/numbers/number_file.h"
#include "base/support/temporary_folder.h"
#include "somato/files/npy.h"

namespace somato {
namespace {

template <typename T>
std::string array_file(const std::string& type, const std::vector<T>& values) {
  std::string bytes = npy_file_start(type, std::array{values.size()});
  for (const T value : values) append_little_endian(bytes, value);
  return bytes;
}

using NpzMembers = std::vector<std::pair<std::string, std::string>>;

// As scipy.sparse.save_npz writes the matrix
//   0 1.5 0
//   2 0  -3
NpzMembers sparse_members(const std::string& format) {
  NpzMembers members{
      {"shape.npy", array_file<std::int64_t>("<i8", {2, 3})},
      {"format.npy", npy_file_start("|S3", std::span<const std::size_t>()) + format}};
  const bool is_by_columns = format == "csc";
  members.emplace_back("data.npy",
                       array_file<double>("<f8", is_by_columns ? std::vector{2.0, 1.5, -3.0}
                                                               : std::vector{1.5, 2.0, -3.0}));
  if (format == "coo") {
    members.emplace_back("row.npy", array_file<std::int32_t>("<i4", {0, 1, 1}));
    members.emplace_back("col.npy", array_file<std::int32_t>("<i4", {1, 0, 2}));
    return members;
  }
  members.emplace_back(
      "indices.npy",
      array_file<std::int32_t>("<i4", is_by_columns ? std::vector{1, 0, 1} : std::vector{1, 0, 2}));
  members.emplace_back("indptr.npy",
                       array_file<std::int32_t>(
                           "<i4", is_by_columns ? std::vector{0, 1, 2, 3} : std::vector{0, 1, 3}));
  return members;
}

Result<Matrix<float>> read_npz(const NpzMembers& members, const std::string& variable = {}) {
  return npy_in_npz(made_zip(members, true), "a.npz", variable)
      .and_then([](const std::string& npy) { return decode_npy(npy, "a.npz"); });
}

std::string npz_refusal(const NpzMembers& members, const std::string& variable = {}) {
  const auto result = read_npz(members, variable);
  return result ? "read" : to_string(result.error());
}

TEST(NpzArray, SparseMatricesAreReadInThreeFormats) {
  for (const char* format : {"csr", "csc", "coo"}) {
    EXPECT_EQ(npz_refusal(sparse_members(format)), "read");
    EXPECT_EQ(read_npz(sparse_members(format)).value(), Matrix<float>(2, 3, {0, 1.5F, 0, 2, 0, -3}))
        << format;
  }
}

TEST(NpzArray, ListsThatDoNotFitAreRefused) {
  EXPECT_NE(npz_refusal(sparse_members("bsr")).find("'bsr' are not read; convert it to csr"),
            std::string::npos);
  for (const std::vector<std::int32_t>& starts :
       {std::vector{0, 1}, {0, 3, 1}, {0, 4, 3}, {1, 2, 3}, {0, 1, 2}, {0, -1, 3}}) {
    NpzMembers members = sparse_members("csr");
    members.back().second = array_file("<i4", starts);
    EXPECT_NE(npz_refusal(members).find("a.npz: the "), std::string::npos) << starts[1];
  }
  NpzMembers members = sparse_members("coo");
  members.back().second = array_file<std::int32_t>("<i4", {1, 0, 3});
  EXPECT_NE(npz_refusal(members).find("the index 3, which is not below 3"), std::string::npos);
  members.back().second = array_file<std::int32_t>("<i4", {1, 0});
  EXPECT_NE(npz_refusal(members).find("do not fit"), std::string::npos);
  members.pop_back();
  EXPECT_NE(npz_refusal(members).find("'col' is missing"), std::string::npos);
  members = sparse_members("csr");
  members.front().second = array_file<std::int64_t>("<i8", {1 << 30, 1 << 30});
  members.back().second = array_file<std::int32_t>("<i4", {0, 3});
  EXPECT_NE(npz_refusal(members), "read");
}

TEST(NpzArray, OneOfSeveralArraysIsSelected) {
  const NpzMembers members{{"a.npy", array_file<float>("<f4", {1.0F, 2.0F})},
                           {"b.npy", array_file<float>("<f4", {3.0F})}};
  EXPECT_EQ(read_npz(members, "b").value(), Matrix<float>(1, 1, 3.0F));
  EXPECT_EQ(read_npz({members.front()}).value(), Matrix<float>(2, 1, {1.0F, 2.0F}));
  EXPECT_EQ(npz_refusal(members),
            "a.npz: the archive contains several arrays: a, b; select one of these variables");
  EXPECT_NE(npz_refusal(members, "c").find("'c'"), std::string::npos);
}

TEST(NpzArray, FilesAreRecognizedByTheirBytes) {
  const TemporaryFolder folder;
  const std::string path = folder.with("rows", made_zip(sparse_members("csr"), false));
  EXPECT_EQ(read_numbers(path).value().values, Matrix<float>(2, 3, {0, 1.5F, 0, 2, 0, -3}));
  CsvOptions options;
  options.variable = "data";
  EXPECT_EQ(read_numbers(path, options).value().values, Matrix<float>(3, 1, {1.5F, 2, -3}));
  const auto refused = read_numbers(folder.with("a.csv", "1,2\n3,4\n"), options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kUsage);
}

}  // namespace
}  // namespace somato
