#include "base/numbers/number_file.h"

#include <gtest/gtest.h>

#include "base/support/temporary_folder.h"
#include "somato/files/npy.h"

namespace somato {
namespace {

TEST(NumberFile, GoesByWhatIsInside) {
  const TemporaryFolder folder;
  const Matrix<float> values(1, 2, std::vector<float>{1, 2});
  EXPECT_EQ(read_numbers(folder.with("a.csv", encode_npy(values)))->values, values);
  EXPECT_EQ(read_numbers(folder.with("b.npy", "1 2\n"))->values, values);
  EXPECT_EQ(read_numbers(folder.file("missing")).error().kind, ErrorKind::kSystem);
}

TEST(NumberFile, HasLabelsOnlyAsText) {
  const TemporaryFolder folder;
  CsvOptions options;
  options.label_column = "1";
  EXPECT_EQ(read_numbers(folder.with("a", "cup,1\n"), options)->labels.at(0), "cup");
  const std::string npy = encode_npy(Matrix<float>(1, 1, 0.0f));
  EXPECT_EQ(read_numbers(folder.with("b", npy), options).error().kind, ErrorKind::kUsage);
}

}  // namespace
}  // namespace somato
