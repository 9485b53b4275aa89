#include "base/files/scratch_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>

#include "base/files/whole_file.h"

namespace somato {
namespace {

TEST(ScratchFolder, IsPrivateAndRemovedWithItsContent) {
  std::string path;
  {
    auto created = ScratchFolder::create();
    ASSERT_TRUE(created);
    const ScratchFolder folder(std::move(*created));
    path = folder.path();
    EXPECT_EQ(std::filesystem::status(path).permissions(), std::filesystem::perms::owner_all);
    EXPECT_TRUE(save_whole(path + "/file", "bytes"));
    const auto other = ScratchFolder::create();
    ASSERT_TRUE(other);
    EXPECT_NE(other->path(), path);
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace somato
