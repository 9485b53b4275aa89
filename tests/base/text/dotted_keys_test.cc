#include "base/text/dotted_keys.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

TEST(DottedKeys, AreCountedWhereTheyAreKeys) {
  EXPECT_EQ(line_of_long_key("a.b.c = 1", 2), 0u);
  EXPECT_EQ(line_of_long_key("\na.b.c.d = 1", 2), 2u);
  EXPECT_EQ(line_of_long_key("[a.b.c.d]", 2), 1u);
  EXPECT_EQ(line_of_long_key("x = { a . b.\tc.d = 1 }", 2), 1u);
  EXPECT_EQ(line_of_long_key("x = '''\n\n''' \n a.b.c.d = 1", 2), 4u);
}

TEST(DottedKeys, AreNotNumbersOrProse) {
  EXPECT_EQ(line_of_long_key("a = [0.5, 1.5, 2.5, 3.5]", 2), 0u);
  EXPECT_EQ(line_of_long_key("# .....\na = \"....\"\nb = '....'\n", 2), 0u);
  EXPECT_EQ(line_of_long_key("a = \"\"\"\n....\\\"\" ....\n\"\"\"\"\"\n", 2), 0u);
}

TEST(DottedKeys, MayBeQuoted) {
  EXPECT_EQ(line_of_long_key("\"=\".'='.\"\\\"=\".d = 1", 2), 1u);
  EXPECT_EQ(line_of_long_key("\"#\".'{'.\"a", 2), 0u);
}

}  // namespace
}  // namespace somato
