#include "studies/run/merged_parts.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "base/support/temporary_folder.h"
#include "studies/run/checked_line.h"

namespace somato {
namespace {

class PartsToMerge : public ::testing::Test {
 protected:
  static std::string line(const std::string& name) { return checked_line({{"name", name}}); }

  void write(const std::string& part, const std::string& file, const std::string& text) const {
    std::filesystem::create_directories(folder_.file(part));
    folder_.with(part + "/" + file, text);
  }
  Result<MergedParts> merge(const std::string& from) const {
    return merge_parts(folder_.file(from), folder_.file("to"));
  }
  std::string merged(const std::string& file) const { return bytes_of(folder_.file("to/" + file)); }

  TemporaryFolder folder_;
};

TEST_F(PartsToMerge, KeepEveryValidLineOnce) {
  write("a/1-of-2", "x.journal", line("header") + line("one") + line("two").substr(0, 20));
  write("b/1-of-2", "x.journal", line("header") + line("two") + line("one"));
  write("b/2-of-2", "y.found", line("study"));
  write("b/2-of-2", "other.txt", "ignored");
  const auto a = merge("a");
  ASSERT_TRUE(a);
  EXPECT_EQ(a->parts, 1U);
  EXPECT_EQ(a->trainings, 1U);
  EXPECT_EQ(merged("1-of-2/x.journal"), line("header") + line("one"));
  const auto b = merge("b");
  ASSERT_TRUE(b);
  EXPECT_EQ(b->parts, 2U);
  EXPECT_EQ(b->trainings, 2U);
  EXPECT_EQ(b->studies, 1U);
  EXPECT_EQ(merged("1-of-2/x.journal"), line("header") + line("one") + line("two"));
  EXPECT_EQ(merged("2-of-2/y.found"), line("study"));
  EXPECT_FALSE(std::filesystem::exists(folder_.file("to/2-of-2/other.txt")));
}

TEST_F(PartsToMerge, OfTheSameNameMustBeTheSame) {
  write("a/1-of-1", "x.found", line("one"));
  write("b/1-of-1", "x.found", line("two"));
  ASSERT_TRUE(merge("a"));
  const auto b = merge("b");
  ASSERT_FALSE(b);
  EXPECT_EQ(b.error().kind, ErrorKind::kData);
  EXPECT_EQ(merged("1-of-1/x.found"), line("one"));
}

TEST_F(PartsToMerge, ReplaceADamagedFile) {
  write("to/1-of-1", "x.found", line("one").substr(0, 12));
  write("a/1-of-1", "x.found", line("one"));
  ASSERT_TRUE(merge("a"));
  EXPECT_EQ(merged("1-of-1/x.found"), line("one"));
}

}  // namespace
}  // namespace somato
