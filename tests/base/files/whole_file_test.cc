#include "base/files/whole_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <thread>

#include "base/files/file_system.h"
#include "base/support/failing_file_system.h"
#include "base/support/temporary_folder.h"
#include "somato/core/random.h"

namespace somato {
namespace {

namespace fs = std::filesystem;

using testing::FailingFileSystem;

constexpr int kNever = 1 << 30;

const std::string kOld = "the old content";
const std::string kNew = "the new content, which is longer";

// Fails every operation of a save in turn; returns how many there were.
int fail_every_operation(bool exists, int error, std::size_t most) {
  int failing = 0;
  for (bool failed = true; failed; ++failing) {
    SCOPED_TRACE("operation " + std::to_string(failing) + ", error " + std::to_string(error));
    const TemporaryFolder folder;
    const std::string path = folder.file("model");
    if (exists) folder.with("model", kOld);
    FailingFileSystem files(failing, error, most);
    const Result<void> saved = detail::save_whole(files, path, kNew);
    failed = files.failed();
    EXPECT_EQ(files.opened(), 0);
    const bool is_new = fs::exists(path) && bytes_of(path) == kNew;
    const bool is_old = exists ? bytes_of(path) == kOld : !fs::exists(path);
    EXPECT_TRUE(is_new || is_old);
    EXPECT_EQ(folder.count(), fs::exists(path) ? 1 : 0) << "a temporary file is left";
    EXPECT_TRUE(!saved || is_new);
    EXPECT_TRUE(saved || (failed && error != EINTR));
    EXPECT_TRUE(saved || (saved.error().kind == ErrorKind::kSystem && saved.error().where == path));
  }
  return failing - 1;
}

TEST(SaveWhole, LeavesTheOldFileOrTheNewOneWhateverFails) {
  for (const bool exists : {false, true}) {
    for (const int error : {EIO, ENOSPC, EINTR}) {
      EXPECT_GE(fail_every_operation(exists, error, SIZE_MAX), 9);
      EXPECT_GE(fail_every_operation(exists, error, 1), 9 + static_cast<int>(kNew.size()) - 1);
    }
  }
}

TEST(SaveWhole, ReportsEveryFailureButThoseThatLoseNothing) {
  const TemporaryFolder folder;
  const std::string path = folder.with("model", kOld);
  int unreported = 0;
  for (int failing = 0;; ++failing) {
    FailingFileSystem files(failing, EIO);
    const Result<void> saved = detail::save_whole(files, path, kNew);
    if (!files.failed()) break;
    unreported += saved ? 1 : 0;
  }
  // Closing the old file, which was opened to ask about it, and closing the folder.
  EXPECT_EQ(unreported, 2);
}

TEST(SaveWhole, TreatsAWriteOfNothingAsAFailure) {
  const TemporaryFolder folder;
  FailingFileSystem files(kNever, EIO, 0);
  EXPECT_FALSE(detail::save_whole(files, folder.file("model"), kNew));
  EXPECT_EQ(folder.count(), 0);
}

TEST(SaveWhole, SaysWhatTheSystemSaid) {
  const TemporaryFolder folder;
  const Result<void> missing = save_whole(folder.file("no/such/folder"), kNew);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, ErrorKind::kSystem);
  EXPECT_NE(missing.error().what.find("No such file or directory"), std::string::npos);
  const Result<void> directory = save_whole(folder.path(), kNew);
  ASSERT_FALSE(directory);
  EXPECT_NE(directory.error().what.find("Is a directory"), std::string::npos);
}

unsigned mode_of(const std::string& path) {
  struct stat found{};
  EXPECT_EQ(::stat(path.c_str(), &found), 0);
  return found.st_mode & 07777u;
}

TEST(SaveWhole, KeepsPermissions) {
  const TemporaryFolder folder;
  const std::string path = folder.with("model", kOld);
  ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
  ASSERT_TRUE(save_whole(path, kNew));
  EXPECT_EQ(mode_of(path), 0640u);

  const mode_t before = ::umask(027);
  ASSERT_TRUE(save_whole(folder.file("fresh"), kNew));
  ::umask(before);
  EXPECT_EQ(mode_of(folder.file("fresh")), 0640u);
}

TEST(SaveWhole, FollowsSymbolicLinks) {
  const TemporaryFolder folder;
  fs::create_directory(folder.file("deep"));
  folder.with("deep/model", kOld);
  fs::create_symlink("deep/model", folder.file("link"));
  fs::create_symlink("link", folder.file("link_to_link"));
  ASSERT_TRUE(save_whole(folder.file("link_to_link"), kNew));
  EXPECT_TRUE(fs::is_symlink(folder.file("link")));
  EXPECT_EQ(bytes_of(folder.file("deep/model")), kNew);

  fs::create_symlink("deep/later", folder.file("dangling"));
  ASSERT_TRUE(save_whole(folder.file("dangling"), kNew));
  EXPECT_TRUE(fs::is_symlink(folder.file("dangling")));
  EXPECT_EQ(bytes_of(folder.file("deep/later")), kNew);

  fs::create_symlink("circle", folder.file("circle"));
  EXPECT_FALSE(save_whole(folder.file("circle"), kNew));
}

// Lets nothing be created, renamed or removed: a broken save under test, run by the superuser,
// would otherwise replace the machine's own devices.
class FixedFileSystem final : public FileSystem {
 public:
  bool tried_to_replace() const { return tried_to_replace_; }

  Outcome<int> open(const std::string& path, Opening opening) override {
    if (opening == Opening::kCreate) return tl::unexpected<int>(refused());
    return real_.open(path, opening);
  }
  Outcome<FileStatus> status(int file) override { return real_.status(file); }
  Outcome<std::size_t> read(int file, char* bytes, std::size_t count) override {
    return real_.read(file, bytes, count);
  }
  Outcome<std::size_t> read_at(int file, std::size_t place, char* bytes,
                               std::size_t count) override {
    return real_.read_at(file, place, bytes, count);
  }
  Outcome<std::size_t> write(int file, std::string_view bytes) override {
    return real_.write(file, bytes);
  }
  Outcome<void> set_permissions(int, const FileStatus&) override {
    return tl::unexpected<int>(refused());
  }
  Outcome<void> flush(int file) override { return real_.flush(file); }
  Outcome<void> lock(int file) override { return real_.lock(file); }
  Outcome<void> close(int file) override { return real_.close(file); }
  Outcome<void> rename(const std::string&, const std::string&) override {
    return tl::unexpected<int>(refused());
  }
  Outcome<void> remove(const std::string&) override { return tl::unexpected<int>(refused()); }

 private:
  int refused() {
    tried_to_replace_ = true;
    return EPERM;
  }

  FileSystem& real_ = operating_system();
  bool tried_to_replace_ = false;
};

TEST(SaveWhole, ReportsAFullDeviceAndNeverReplacesADevice) {
  ASSERT_TRUE(fs::is_character_file("/dev/full"));
  FixedFileSystem files;
  const Result<void> saved = detail::save_whole(files, "/dev/full", kNew);
  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error().kind, ErrorKind::kSystem);
  EXPECT_NE(saved.error().what.find("No space left on device"), std::string::npos);
  EXPECT_TRUE(detail::save_whole(files, "/dev/null", kNew));
  EXPECT_FALSE(files.tried_to_replace());
}

TEST(SaveWhole, WritesIntoAPipe) {
  const TemporaryFolder folder;
  const std::string path = folder.file("pipe");
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
  std::string got;
  std::thread reader([&] { got = bytes_of(path); });
  const std::string large(300000, 'x');
  EXPECT_TRUE(save_whole(path, large));
  reader.join();
  EXPECT_TRUE(got == large);
  EXPECT_TRUE(fs::is_fifo(path));
}

// As /dev/stdout with the output redirected to a file: the open file gets the bytes, and stays.
TEST(SaveWhole, WritesIntoAnOpenFileThroughItsLink) {
  const TemporaryFolder folder;
  const std::string path = folder.with("redirected", std::string(100, 'x'));
  const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
  ASSERT_GE(file, 0);
  const std::string link = folder.file("link");
  fs::create_symlink("/proc/self/fd/" + std::to_string(file), link);
  struct stat before{};
  struct stat after{};
  ASSERT_EQ(::stat(path.c_str(), &before), 0);
  EXPECT_TRUE(save_whole(link, kNew));
  ASSERT_EQ(::stat(path.c_str(), &after), 0);
  EXPECT_EQ(before.st_ino, after.st_ino);
  EXPECT_EQ(bytes_of(path), kNew);
  ::close(file);
}

// Saves two large contents in turn, for ever.
[[noreturn]] void save_in_turn(const std::string& path, const std::string& a,
                               const std::string& b) {
  for (;;) {
    if (!save_whole(path, a) || !save_whole(path, b)) ::_exit(1);
  }
}

TEST(SaveWhole, LeavesAWholeFileWhenKilled) {
  const TemporaryFolder folder;
  const std::string path = folder.file("model");
  const std::string a(400001, 'a');
  const std::string b(300007, 'b');
  ASSERT_TRUE(save_whole(path, a));
  Random random(1);
  int partial_left = 0;
  for (int i = 0; i < 100; ++i) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) save_in_turn(path, a, b);
    ::usleep(static_cast<useconds_t>(500 + random.below(8000)));
    ASSERT_EQ(::kill(child, SIGKILL), 0);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "the child stopped saving by itself";
    const std::string found = bytes_of(path);
    ASSERT_TRUE(found == a || found == b) << found.size() << " bytes";
    partial_left += folder.count() > 1 ? 1 : 0;
    for (const auto& entry : fs::directory_iterator(folder.path())) {
      if (entry.path() != path) fs::remove(entry.path());
    }
  }
  EXPECT_GT(partial_left, 0) << "no child was killed in the middle of a save";
}

TEST(ReadWhole, ReadsWhatIsThere) {
  const TemporaryFolder folder;
  std::string bytes(3000000, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * i % 251);
  EXPECT_TRUE(read_whole(folder.with("large", bytes)).value() == bytes);
  EXPECT_EQ(read_whole(folder.with("empty", "")).value(), "");
  EXPECT_EQ(read_whole("/dev/null").value(), "");
  EXPECT_NE(read_whole("/proc/self/status")->find("Name:"), std::string::npos);
}

TEST(ReadWhole, RefusesWhatIsTooLarge) {
  const TemporaryFolder folder;
  const std::string path = folder.with("ten", "0123456789");
  EXPECT_EQ(read_whole(path, 10).value(), "0123456789");
  const Result<std::string> refused = read_whole(path, 9);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kData);
  EXPECT_NE(refused.error().what.find("9 bytes"), std::string::npos);
  const Result<std::string> endless = read_whole("/dev/zero", 100000);
  ASSERT_FALSE(endless);
  EXPECT_NE(endless.error().what.find("100000 bytes"), std::string::npos);
  FailingFileSystem counted(kNever);
  EXPECT_FALSE(detail::read_whole(counted, "/dev/zero", 100000));
  EXPECT_LT(counted.count(), 100) << "it was read on after the limit";

  const std::string sparse = folder.with("sparse", "");
  fs::resize_file(sparse, std::uintmax_t{1} << 40);
  EXPECT_FALSE(read_whole(sparse)) << "a file of a terabyte";
}

TEST(ReadWhole, SaysWhatTheSystemSaid) {
  const TemporaryFolder folder;
  const Result<std::string> missing = read_whole(folder.file("missing"));
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().kind, ErrorKind::kSystem);
  EXPECT_EQ(missing.error().where, folder.file("missing"));
  EXPECT_NE(missing.error().what.find("No such file or directory"), std::string::npos);
  const Result<std::string> directory = read_whole(folder.path());
  ASSERT_FALSE(directory);
  EXPECT_EQ(directory.error().kind, ErrorKind::kSystem);
  EXPECT_NE(directory.error().what.find("Is a directory"), std::string::npos);
}

TEST(ReadWhole, SurvivesShortReadsAndReportsFailingOnes) {
  const TemporaryFolder folder;
  const std::string path = folder.with("old", kOld);
  FailingFileSystem slow(kNever, EIO, 1);
  EXPECT_EQ(detail::read_whole(slow, path, 100).value(), kOld);
  FailingFileSystem interrupted(4, EINTR, 3);
  EXPECT_EQ(detail::read_whole(interrupted, path, 100).value(), kOld);
  for (int failing = 0; failing < 8; ++failing) {
    FailingFileSystem files(failing, EIO, 3);
    EXPECT_FALSE(detail::read_whole(files, path, 100)) << failing;
    EXPECT_EQ(files.opened(), 0);
  }
}

}  // namespace
}  // namespace somato
