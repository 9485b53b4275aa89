#include "base/tables/csv_header.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

using Names = std::vector<std::string>;

std::vector<CsvField> fields(const Names& texts) {
  std::vector<CsvField> fields;
  for (const std::string& text : texts) fields.push_back({text, false, 1, 1});
  return fields;
}

TEST(NamesInHeader, AreNumbersOfColumnsWithoutNames) {
  EXPECT_EQ(names_in_header(fields({"", "a", "  ", "'=b", "\xC2\xA0\n"})),
            (Names{"(column 1)", "a", "(column 3)", "=b", "(column 5)"}));
}

TEST(IsNameless, KnowsTheNamesThatStandForNone) {
  EXPECT_TRUE(is_nameless("(column 3)", 2));
  EXPECT_FALSE(is_nameless("(column 3)", 1));
  for (const char* name :
       {"Unnamed: 0", "Unnamed: 12", "Unnamed: 0.1", "Unnamed: 0_level_0", "...1", "...12"}) {
    EXPECT_TRUE(is_nameless(name, 5)) << name;
  }
  for (const char* name : {"a", "1", "Unnamed", "Unnamed: x", "...", "...x", "x...1", "...1x"}) {
    EXPECT_FALSE(is_nameless(name, 0)) << name;
  }
}

TEST(NamelessColumns, AreExplainedByTheirPlace) {
  EXPECT_EQ(to_string(nameless_columns({0}, 3, "f", "skip 1")),
            "f: column 1 has no name; usually this is the index of pandas or the row names of R: "
            "write the table without it (index=False, row.names=FALSE), or skip 1");
  EXPECT_EQ(to_string(nameless_columns({2}, 3, "f", "skip 3")),
            "f: column 3 has no name; a separator ends the line of names: remove it from every "
            "line, or skip 3");
  EXPECT_EQ(to_string(nameless_columns({0, 1}, 3, "f", "x")).substr(0, 30),
            "f: columns 1, 2 have no names;");
}

TEST(WrongNumberOfFields, IsExplainedAfterTheHeader) {
  const auto said = [](const Names& row, std::size_t width, bool follows_header) {
    return to_string(
        wrong_number_of_fields(fields(row), width, follows_header, "f:2", "repair it"));
  };
  EXPECT_EQ(said({"1", "2"}, 3, true), "f:2: expected 3 fields, found 2; repair it");
  EXPECT_EQ(said({"1", "2", "3"}, 2, false), "f:2: expected 2 fields, found 3; repair it");
  EXPECT_NE(said({"1", "2", "3"}, 2, true).find("row.names=FALSE"), std::string::npos);
  EXPECT_NE(said({"1", "2", ""}, 2, true).find("a separator ends the line"), std::string::npos);
  EXPECT_EQ(said({"1", "2", "3", "4"}, 2, true), "f:2: expected 2 fields, found 4; repair it");
}

}  // namespace
}  // namespace somato
