#include "base/files/spool.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "base/support/temporary_folder.h"

namespace somato {
namespace {

std::string read_spool(Spool& spool, std::size_t count) {
  std::string bytes(count, '?');
  EXPECT_TRUE(spool.read(bytes.data(), count));
  return bytes;
}

// TMPDIR as long as it exists.
class TemporaryFolderVariable {
 public:
  explicit TemporaryFolderVariable(const std::string& folder) {
    (void)::setenv("TMPDIR", folder.c_str(), 1);
  }
  TemporaryFolderVariable(const TemporaryFolderVariable&) = delete;
  TemporaryFolderVariable& operator=(const TemporaryFolderVariable&) = delete;
  ~TemporaryFolderVariable() { (void)::unsetenv("TMPDIR"); }
};

TEST(Spool, BytesAreReadInTheOrderInWhichTheyWereWritten) {
  for (const std::size_t memory : {std::size_t{0}, std::size_t{5}, std::size_t{100}}) {
    SCOPED_TRACE(memory);
    Spool spool(memory);
    for (const char* const bytes : {"abc", "defgh", "", "ij"}) ASSERT_TRUE(spool.write(bytes));
    EXPECT_EQ(spool.unread(), 10U);
    EXPECT_EQ(read_spool(spool, 1), "a");
    EXPECT_EQ(read_spool(spool, 8), "bcdefghi");
    ASSERT_TRUE(spool.write("k"));
    EXPECT_EQ(read_spool(spool, 2), "jk");
    EXPECT_EQ(spool.unread(), 0U);
    EXPECT_THROW((void)read_spool(spool, 1), std::invalid_argument);
    spool.clear();
    ASSERT_TRUE(spool.write("new"));
    EXPECT_EQ(read_spool(spool, 3), "new");
  }
}

TEST(Spool, ReadsMoreThanItsWindow) {
  constexpr std::size_t kCount = 3'000'000;
  Spool spool(1000);
  for (std::size_t i = 0; i < kCount / 1000; ++i) {
    ASSERT_TRUE(spool.write(std::string(1000, static_cast<char>('a' + i % 26))));
  }
  for (std::size_t place = 0; place < kCount; place += 750) {
    const char last = static_cast<char>('a' + (place + 749) / 1000 % 26);
    ASSERT_EQ(read_spool(spool, 750).back(), last) << place;
  }
}

TEST(Spool, TheFileHasNoNameAndItsFolderIsNamedByErrors) {
  const TemporaryFolder folder;
  {
    const TemporaryFolderVariable variable(folder.file(""));
    Spool spool(1);
    ASSERT_TRUE(spool.write("abc"));
    EXPECT_EQ(folder.count(), 0);
  }
  const TemporaryFolderVariable variable(folder.file("missing"));
  Spool spool(1);
  const Result<void> refused = spool.write("abc");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kSystem);
  EXPECT_EQ(refused.error().where, folder.file("missing"));
  EXPECT_NE(refused.error().advice.find("TMPDIR"), std::string::npos);
}

}  // namespace
}  // namespace somato
