#include "recordings/bags/span_table.h"

#include <gtest/gtest.h>

#include <string>

#include "base/support/temporary_folder.h"

namespace somato {
namespace {

TEST(SpanTable, RowsAreSpansWithLabels) {
  const TemporaryFolder folder;
  const auto spans =
      read_span_table(folder.with("spans.csv", "object,begin,end\ncup,0.5,1\nball,1,2.25\n"));
  ASSERT_TRUE(spans) << to_string(spans.error());
  ASSERT_EQ(spans->size(), 2U);
  EXPECT_EQ((*spans)[1].begin, 1'000'000'000);
  EXPECT_EQ((*spans)[1].end, 2'250'000'000);
  EXPECT_EQ((*spans)[1].labels, (std::vector<Label>{{"object", "ball"}}));
}

TEST(SpanTable, FollowsTheRulesOfTables) {
  const TemporaryFolder folder;
  const auto spans =
      read_span_table(folder.with("spans.csv", "sep=;\nobject;begin;end\n'=cup;0.5;1\n"));
  ASSERT_TRUE(spans) << to_string(spans.error());
  EXPECT_EQ(spans->at(0).labels, (std::vector<Label>{{"object", "=cup"}}));
  const auto index = read_span_table(folder.with("i.csv", ",object,begin,end\n0,cup,0.5,1\n"));
  ASSERT_FALSE(index);
  EXPECT_EQ(index.error().what, "column 1 has no name");
}

TEST(SpanTable, OtherTablesAreRefused) {
  const TemporaryFolder folder;
  for (const std::string text : {"", "begin\n1\n", "begin,end\n", "begin,end\n1,x\n",
                                 "begin,end\n1,1\n", "begin,end\n1\n", "begin,end\n0,2\n1,3\n"}) {
    EXPECT_FALSE(read_span_table(folder.with("spans.csv", text))) << text;
  }
  EXPECT_FALSE(read_span_table(folder.file("none.csv")));
}

}  // namespace
}  // namespace somato
