#include "base/files/file_system.h"

#include <gtest/gtest.h>

#include <cerrno>

#include "base/support/temporary_folder.h"

namespace somato {
namespace {

TEST(OperatingSystem, CreatesOnlyWhatIsNotThere) {
  const TemporaryFolder folder;
  const std::string path = folder.with("there", "x");
  EXPECT_EQ(operating_system().open(path, Opening::kCreate).error(), EEXIST);
  EXPECT_EQ(operating_system().open(folder.file("missing"), Opening::kOverwrite).error(), ENOENT);
  EXPECT_EQ(operating_system().open(path, Opening::kFolder).error(), ENOTDIR);
}

TEST(OperatingSystem, ReadsAtAPlace) {
  const TemporaryFolder folder;
  FileSystem& files = operating_system();
  const int file = files.open(folder.with("a", "0123456789"), Opening::kRead).value();
  char bytes[4] = {};
  EXPECT_EQ(files.read_at(file, 3, bytes, 4), 4u);
  EXPECT_EQ(std::string(bytes, 4), "3456");
  EXPECT_EQ(files.read_at(file, 8, bytes, 4), 2u);
  EXPECT_EQ(files.read_at(file, 10, bytes, 4), 0u);
  EXPECT_TRUE(files.close(file));
  EXPECT_EQ(files.read_at(file, 0, bytes, 4).error(), EBADF);
}

TEST(OperatingSystem, SaysWhatIsBehindAFile) {
  const TemporaryFolder folder;
  FileSystem& files = operating_system();
  const int file = files.open(folder.with("a", "four"), Opening::kRead).value();
  const int directory = files.open(folder.path(), Opening::kFolder).value();
  const int device = files.open("/dev/null", Opening::kRead).value();
  EXPECT_EQ(files.status(file)->kind, FileStatus::Kind::kRegular);
  EXPECT_EQ(files.status(file)->size, 4u);
  EXPECT_EQ(files.status(directory)->kind, FileStatus::Kind::kDirectory);
  EXPECT_EQ(files.status(device)->kind, FileStatus::Kind::kOther);
  for (const int each : {file, directory, device}) EXPECT_TRUE(files.close(each));
  EXPECT_EQ(files.close(file).error(), EBADF);
}

TEST(OperatingSystem, OverwritesOrTruncates) {
  const TemporaryFolder folder;
  FileSystem& files = operating_system();
  const std::string path = folder.with("a", "four");
  const int kept = files.open(path, Opening::kOverwrite).value();
  EXPECT_EQ(files.write(kept, "F").value(), 1u);
  EXPECT_TRUE(files.close(kept));
  EXPECT_EQ(bytes_of(path), "Four");
  EXPECT_TRUE(files.close(files.open(path, Opening::kTruncate).value()));
  EXPECT_EQ(bytes_of(path), "");
}

}  // namespace
}  // namespace somato
