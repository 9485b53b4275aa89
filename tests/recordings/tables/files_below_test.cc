#include "recordings/tables/files_below.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/support/temporary_folder.h"

namespace somato {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

TEST(NaturallyBefore, CountsNumbersAsNumbers) {
  EXPECT_TRUE(naturally_before("trial_2", "trial_10"));
  EXPECT_FALSE(naturally_before("trial_10", "trial_2"));
  EXPECT_TRUE(naturally_before("a2b3", "a2b10"));
  EXPECT_TRUE(naturally_before("a", "a1"));
  EXPECT_TRUE(naturally_before("a9", "b1"));
  EXPECT_FALSE(naturally_before("a1", "a1"));
  EXPECT_TRUE(naturally_before("99999999999999999999998", "99999999999999999999999"));
}

TEST(NaturallyBefore, OrdersNumbersOfOneValueToo) {
  EXPECT_NE(naturally_before("a1", "a01"), naturally_before("a01", "a1"));
  EXPECT_TRUE(naturally_before("a01b", "a1c"));
  EXPECT_TRUE(naturally_before("a0", "a1"));
}

TEST(FilesBelow, FindsFilesOfTheExtensionAtAnyDepth) {
  const TemporaryFolder folder;
  fs::create_directories(folder.file("b/c"));
  for (const char* name : {"t10.csv", "t2.CSV", "b/x.csv", "b/c/y.csv", "z.txt", "csv"}) {
    folder.with(name, "");
  }
  const Names expected{"b/c/y.csv", "b/x.csv", "t2.CSV", "t10.csv"};
  EXPECT_EQ(files_below(folder.path(), ".csv"), expected);
  EXPECT_EQ(files_below(folder.path() + "/", ".csv"), expected);
  EXPECT_EQ(files_below(folder.path(), "")->size(), 6U);
}

TEST(FilesBelow, FollowsLinksToFolders) {
  const TemporaryFolder elsewhere;
  elsewhere.with("1.csv", "");
  const TemporaryFolder folder;
  fs::create_directory_symlink(elsewhere.path(), folder.file("linked"));
  EXPECT_EQ(files_below(folder.path(), ".csv"), (Names{"linked/1.csv"}));
}

TEST(FilesBelow, RefusesACircleOfLinks) {
  const TemporaryFolder folder;
  fs::create_directory_symlink(folder.path(), folder.file("again"));
  const auto files = files_below(folder.path(), ".csv");
  ASSERT_FALSE(files);
  EXPECT_EQ(files.error().what, "there are more than 16 levels of folders");
  EXPECT_EQ(files.error().advice, "check for a loop of links");
}

TEST(FilesBelow, RefusesWhatCannotBeRead) {
  const TemporaryFolder folder;
  for (const std::string& path : {folder.file("nowhere"), folder.with("file", "")}) {
    const auto files = files_below(path, "");
    ASSERT_FALSE(files) << path;
    EXPECT_EQ(files.error().kind, ErrorKind::kSystem);
    EXPECT_EQ(files.error().where, path);
  }
}

TEST(FilesBelow, NamesALinkThatLeadsNowhere) {
  const TemporaryFolder folder;
  fs::create_symlink(folder.file("nowhere"), folder.file("link.csv"));
  const auto files = files_below(folder.path(), ".csv");
  ASSERT_FALSE(files);
  EXPECT_EQ(files.error().where, folder.file("link.csv"));
  EXPECT_NE(files.error().what.find("No such file"), std::string::npos);
}

}  // namespace
}  // namespace somato
