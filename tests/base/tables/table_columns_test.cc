#include "base/tables/table_columns.h"

#include <gtest/gtest.h>

#include "base/text/name_glob.h"

namespace somato {
namespace {

using Names = std::vector<std::string>;
using Columns = std::vector<std::size_t>;

const Names kNames{"id", "tax_1", "tax_2", "slipped", "kind", "a*b"};

TableColumns with_names(std::optional<std::size_t> label = {}) {
  return {kNames.size(), kNames, label, {}, {}};
}

TableColumns nameless(std::size_t width, std::optional<std::size_t> label = {}) {
  return {width, {}, label, {}, {}};
}

Columns chosen(const ColumnChoice& choice, const TableColumns& table) {
  const auto columns = choose_columns(choice, table, "f");
  EXPECT_TRUE(columns) << to_string(columns.error());
  return columns ? columns->features : Columns{};
}

void expect_choice_refused(const ColumnChoice& choice, const TableColumns& table,
                           const std::string& says, ErrorKind kind = ErrorKind::kUsage) {
  const auto columns = choose_columns(choice, table, "f");
  ASSERT_FALSE(columns) << says;
  EXPECT_EQ(columns.error().kind, kind) << says;
  EXPECT_NE(to_string(columns.error()).find(says), std::string::npos)
      << says << " is not in " << to_string(columns.error());
}

TEST(NameGlob, MatchesWholeNames) {
  for (const auto& [pattern, name] :
       std::vector<std::pair<std::string, std::string>>{{"*", ""},
                                                        {"*", "x"},
                                                        {"tax_*", "tax_"},
                                                        {"tax_*", "tax_12"},
                                                        {"*_1", "tax_1_1"},
                                                        {"a*b*c", "abbbc"},
                                                        {"a*b*c", "a-b-b-c"},
                                                        {"?", "x"},
                                                        {"?", "\xC3\xA4"},
                                                        {"t?x", "tax"},
                                                        {"*aab", "aaaab"},
                                                        {"**", "x"},
                                                        {"", ""},
                                                        {"?*", "\xC3\xA4\xC3\xB6"}}) {
    EXPECT_TRUE(matches_glob(pattern, name)) << pattern << " " << name;
  }
  for (const auto& [pattern, name] :
       std::vector<std::pair<std::string, std::string>>{{"tax_*", "Tax_1"},
                                                        {"tax_*", "a tax_1"},
                                                        {"tax", "taxi"},
                                                        {"?", ""},
                                                        {"?", "xy"},
                                                        {"a*b", "abc"},
                                                        {"*aab", "aaba"},
                                                        {"", "x"},
                                                        {"[ab]", "a"},
                                                        {"??", "\xC3\xA4"}}) {
    EXPECT_FALSE(matches_glob(pattern, name)) << pattern << " " << name;
  }
}

TEST(TableColumns, AreAllButTheLabelUnlessChosen) {
  EXPECT_EQ(chosen({}, with_names()), (Columns{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(chosen({}, with_names(4)), (Columns{0, 1, 2, 3, 5}));
  EXPECT_EQ(chosen({}, nameless(3, 0)), (Columns{1, 2}));
}

TEST(TableColumns, AreChosenByNameAndPatternInTheOrderOfTheFile) {
  EXPECT_EQ(chosen({{"slipped", "id"}, {}, {}}, with_names()), (Columns{0, 3}));
  EXPECT_EQ(chosen({{"tax_*"}, {}, {}}, with_names()), (Columns{1, 2}));
  EXPECT_EQ(chosen({{"*"}, {}, {}}, with_names(4)), (Columns{0, 1, 2, 3, 5})) << "not the label";
  EXPECT_EQ(chosen({{}, {"slipped", "*d"}, {}}, with_names()), (Columns{1, 2, 5}));
  EXPECT_EQ(chosen({{"tax_*"}, {"tax_2"}, {}}, with_names()), (Columns{1}))
      << "all of them but one";
  EXPECT_EQ(chosen({{"a*b"}, {}, {}}, with_names()), (Columns{5})) << "a name is no pattern";
}

TEST(TableColumns, AreChosenByNumberWhereTheyHaveNoNames) {
  EXPECT_EQ(chosen({{"2", "4..5"}, {}, {}}, nameless(6)), (Columns{1, 3, 4}));
  EXPECT_EQ(chosen({{}, {"1..2", "6"}, {}}, nameless(6)), (Columns{2, 3, 4}));
  EXPECT_EQ(chosen({{"1..6"}, {"3"}, {}}, nameless(6)), (Columns{0, 1, 3, 4, 5}));
  EXPECT_EQ(chosen({{"2..2"}, {}, {}}, nameless(2)), (Columns{1}));
  for (const char* wrong : {"0", "7", "x", "", "3..2", "5..7", "1..", "..2", "1...3", "-1", "1.5",
                            "99999999999999999999", "1..99999999999999999999", "+1", "tax_*"}) {
    expect_choice_refused({{wrong}, {}, {}}, nameless(6),
                          "there is no column '" + std::string(wrong));
    expect_choice_refused({{}, {wrong}, {}}, nameless(6), "numbers from 1 to 6");
  }
}

TEST(TableColumns, RefuseWhatNamesNoColumn) {
  expect_choice_refused({{"sliped"}, {}, {}}, with_names(),
                        "f: there is no column 'sliped'; did you mean 'slipped'?");
  expect_choice_refused({{}, {"sliped"}, {}}, with_names(), "did you mean 'slipped'?");
  expect_choice_refused({{"touch_*"}, {}, {}}, with_names(), "there is no column 'touch_*'");
  expect_choice_refused({{}, {"2"}, {}}, with_names(), "select them by name");
  expect_choice_refused({{"1..3"}, {}, {}}, with_names(), "select them by name");
}

TEST(TableColumns, RefuseContradictions) {
  expect_choice_refused({{"id", "slipped"}, {"slipped"}, {}}, with_names(),
                        "column 'slipped' is both selected and skipped");
  expect_choice_refused({{"slipped"}, {"s*"}, {}}, with_names(),
                        "'slipped' is both selected and skipped");
  expect_choice_refused({{"3"}, {"2..4"}, {}}, nameless(5),
                        "column 3 is both selected and skipped");
  expect_choice_refused({{"id", "id"}, {}, {}}, with_names(), "column 'id' is selected twice");
  expect_choice_refused({{}, {"kind"}, {}}, with_names(4),
                        "'kind' contains the labels and cannot be skipped");
  expect_choice_refused({{"kind", "id"}, {}, {}}, with_names(4),
                        "'kind' contains the labels and cannot be used");
  expect_choice_refused({{}, {"*"}, {}}, with_names(), "no numeric column is left");
  expect_choice_refused({{"a*b"}, {"*b", "tax_1"}, {}}, with_names(), "both selected and skipped");
  expect_choice_refused({}, nameless(1, 0), "no numeric column is left", ErrorKind::kData);
}

TEST(TableColumns, WithOneNameAreAmbiguous) {
  const TableColumns twins{4, {"x", "y", "x", "xy"}, {}, {}, {}};
  expect_choice_refused({{"x"}, {}, {}}, twins, "two columns are named 'x'");
  expect_choice_refused({{}, {"x"}, {}}, twins, "two columns are named 'x'");
  for (const ColumnChoice& choice : {ColumnChoice{}, {{"x*"}, {}, {}}}) {
    expect_choice_refused(choice, twins, "columns 1 and 3 are both named 'x'", ErrorKind::kData);
  }
  EXPECT_EQ(chosen({{}, {"3"}, {}}, twins), (Columns{0, 1, 3}));
  EXPECT_EQ(chosen({{"1", "3"}, {}, {}}, twins), (Columns{0, 2})) << "both, by number";
  EXPECT_EQ(chosen({{}, {}, {"x", "y", "x", "xy"}}, twins), (Columns{0, 1, 2, 3}))
      << "the very columns";
  EXPECT_EQ(chosen({{}, {}, {"xy", "y"}}, twins), (Columns{3, 1}));
  expect_choice_refused({{}, {}, {"x"}}, twins, "two columns are named 'x'", ErrorKind::kData);
}

TEST(TableColumns, WithoutNamesAmongOthersAreChosenByNumber) {
  const TableColumns table{5, {"(column 1)", "a", "Unnamed: 2", "1", "(column 5)"}, {}, {}, {}};
  expect_choice_refused({}, table, "columns 1, 3, 5 have no names", ErrorKind::kData);
  expect_choice_refused({}, table, "or skip '(column 1),3,5'", ErrorKind::kData);
  EXPECT_EQ(chosen({{}, {"(column 1)", "3", "5"}, {}}, table), (Columns{1, 3}));
  EXPECT_EQ(chosen({{"Unnamed: 2", "a"}, {}, {}}, table), (Columns{1, 2}));
  EXPECT_EQ(chosen({{"5", "1"}, {}, {}}, table), (Columns{3, 4})) << "a name precedes a number";
  expect_choice_refused({{"a", "(*"}, {}, {}}, table, "columns 1, 5 have no names",
                        ErrorKind::kData);
  expect_choice_refused({{}, {"2"}, {}}, table, "select them by name");
  expect_choice_refused({{}, {"2..3"}, {}}, table, "select them by name");
  expect_choice_refused({{}, {"6"}, {}}, table, "there is no column '6'");
  EXPECT_EQ(chosen({{}, {}, {"a", "1"}}, table), (Columns{1, 3})) << "a model selects by name";
}

TEST(TableColumns, OfAModelArePickedByNameInItsOrder) {
  EXPECT_EQ(chosen({{}, {}, {"slipped", "tax_1"}}, with_names()), (Columns{3, 1}));
  EXPECT_EQ(chosen({{"tax_*", "id"}, {}, {"tax_2", "id"}}, with_names()), (Columns{2, 0}));
  EXPECT_EQ(chosen({{}, {}, {"a", "b"}}, nameless(3)), (Columns{0, 1, 2})) << "nothing to pick by";
  expect_choice_refused({{}, {}, {"tax_1", "tax_3"}}, with_names(),
                        "column 'tax_3' is required, but is missing; did you mean",
                        ErrorKind::kData);
  expect_choice_refused({{}, {"tax_1"}, {"tax_1"}}, with_names(),
                        "'tax_1' is required, but is left out", ErrorKind::kData);
  expect_choice_refused({{}, {}, {"kind"}}, with_names(4), "contains the labels", ErrorKind::kData);
}

TEST(TableColumns, TellWhatIsLeftOut) {
  const auto columns = choose_columns({{}, {}, {"slipped", "tax_1"}}, with_names(4), "f").value();
  EXPECT_EQ(columns.left_out(), (Columns{0, 2, 5}));
  EXPECT_EQ(columns.feature_names(), (Names{"slipped", "tax_1"}));
  EXPECT_TRUE(choose_columns({}, nameless(3), "f").value().feature_names().empty());
}

}  // namespace
}  // namespace somato
