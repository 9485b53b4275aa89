#include "recordings/file/partial_file.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <filesystem>

#include "base/support/failing_file_system.h"
#include "base/support/temporary_folder.h"

namespace somato {
namespace {

constexpr std::size_t kEmpty = 4;  // bytes

Result<OpenFile> create(const std::string& path) {
  return create_partial_file(operating_system(), path, kEmpty);
}

TEST(PartialFile, IsCreatedBesideTheFile) {
  const TemporaryFolder folder;
  const auto file = create(folder.file("hand.mcap"));
  ASSERT_TRUE(file) << to_string(file.error());
  EXPECT_TRUE(std::filesystem::exists(folder.file("hand.mcap.partial")));
  EXPECT_FALSE(std::filesystem::exists(folder.file("hand.mcap")));
  EXPECT_EQ(create(folder.file("none/hand.mcap")).error().kind, ErrorKind::kSystem);
}

TEST(PartialFile, OfAnEarlierProcessIsNotTouched) {
  const TemporaryFolder folder;
  folder.with("hand.mcap.partial", "precious");
  const auto refused = create(folder.file("hand.mcap"));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kUsage);
  const std::string command =
      "somato recover " + folder.file("hand.mcap.partial") + " -o " + folder.file("hand.mcap");
  EXPECT_NE(refused.error().advice.find(command), std::string::npos) << refused.error().advice;
  EXPECT_EQ(bytes_of(folder.file("hand.mcap.partial")), "precious");
}

TEST(PartialFile, OfAnEarlierProcessWithoutDataIsUsedAgain) {
  const TemporaryFolder folder;
  folder.with("hand.mcap.partial", "head");
  EXPECT_TRUE(create(folder.file("hand.mcap")));
}

TEST(PartialFile, ThatAnotherProcessWritesIsNotTouched) {
  const TemporaryFolder folder;
  {
    const auto first = create(folder.file("hand.mcap"));
    ASSERT_TRUE(first);
    const auto refused = create(folder.file("hand.mcap"));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kUsage);
    EXPECT_NE(refused.error().what.find("another process"), std::string::npos);
  }
  EXPECT_TRUE(create(folder.file("hand.mcap"))) << "its lock ends with it";
}

TEST(PartialFile, NeedsNoLocks) {
  const TemporaryFolder folder;
  testing::FailingFileSystem files(1, ENOLCK);  // after opening
  EXPECT_TRUE(create_partial_file(files, folder.file("hand.mcap"), kEmpty));
  EXPECT_TRUE(files.failed());
}

}  // namespace
}  // namespace somato
