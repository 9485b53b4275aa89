#include "recordings/bags/sqlite_bag.h"

#include <gtest/gtest.h>

#include <string>

#include "base/support/temporary_folder.h"
#include "recordings/bags/made_sqlite_bag.h"

namespace somato {
namespace {

TEST(SqliteBag, MessagesComeInTheOrderInWhichTheyWereRecorded) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.db3");
  {
    MadeSqliteBag made(path, "/x", "a/msg/X", "int8 x\n");
    made.add(20, std::string("\0\1\0\0\5", 5));
    made.add(10, "");  // The clock was set back.
  }
  const auto bag = SqliteBag::open(path).value();
  ASSERT_EQ(bag->topics().size(), 1U);
  EXPECT_EQ(bag->topics()[0].name, "/x");
  EXPECT_EQ(bag->topics()[0].encoding.message_encoding, "cdr");
  EXPECT_EQ(bag->topics()[0].encoding.definition, "int8 x\n");
  const auto first = bag->next().value().value();
  EXPECT_EQ(first.time, 20);
  EXPECT_EQ(first.data, std::string("\0\1\0\0\5", 5));
  const auto second = bag->next().value().value();
  EXPECT_EQ(second.time, 10);
  EXPECT_TRUE(second.data.empty());
  EXPECT_FALSE(bag->next().value());
}

TEST(SqliteBag, OldBagsHaveNoDefinitions) {
  const TemporaryFolder folder;
  {
    const MadeSqliteBag made(folder.file("a.db3"), "/x", "a/msg/X", "");
  }
  const auto bag = SqliteBag::open(folder.file("a.db3")).value();
  EXPECT_TRUE(bag->topics()[0].encoding.definition.empty());
}

TEST(SqliteBag, OtherFilesAreRefused) {
  const TemporaryFolder folder;
  EXPECT_FALSE(SqliteBag::open(folder.file("none.db3")));
  EXPECT_FALSE(SqliteBag::open(folder.with("text.db3", std::string(4096, 'x'))));
  const std::string path = folder.file("other.db3");
  {
    MadeSqliteBag(path, "/x", "a/msg/X", "").run("DROP TABLE messages");
  }
  const auto bag = SqliteBag::open(path);
  ASSERT_FALSE(bag);
  EXPECT_EQ(bag.error().where, path);
  EXPECT_EQ(bag.error().what, "it is not a database of rosbag2 (no such table: messages)");
}

TEST(SqliteBag, AMessageOfNoTopicIsRefused) {
  const TemporaryFolder folder;
  {
    MadeSqliteBag made(folder.file("a.db3"), "/x", "a/msg/X", "");
    made.run("INSERT INTO messages VALUES(NULL, 8, 1, x'00')");
  }
  EXPECT_FALSE(SqliteBag::open(folder.file("a.db3")).value()->next());
}

}  // namespace
}  // namespace somato
