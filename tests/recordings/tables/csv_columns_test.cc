#include "recordings/tables/csv_columns.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/support/temporary_folder.h"
#include "recordings/support/csv_channel.h"
#include "somato/recording/csv_import.h"

namespace somato {
namespace {

using Names = std::vector<std::string>;

class FindCsvColumns : public ::testing::Test {
 protected:
  Result<CsvColumns> find(const Names& names) const {
    return find_csv_columns(plan_, csv_layout_of(plan_).value(), names);
  }

  std::string refusal(const Names& names) const {
    const auto found = find(names);
    return found ? "none" : to_string(found.error());
  }

  CsvImport plan_;
};

TEST_F(FindCsvColumns, TakesWhatFitsInTheOrderOfTheFile) {
  plan_.channels = {channel_of("touch", {"tax_*"})};
  const CsvColumns found = find({"tax_2", "t", "tax_10", "tax_1"}).value();
  EXPECT_EQ(found.channels, (std::vector<Names>{{"tax_2", "tax_10", "tax_1"}}));
  EXPECT_EQ(found.others, (Names{"t"}));
  EXPECT_EQ(found.columns[2].element, 1U);
  EXPECT_EQ(found.columns[3].element, 2U);
}

TEST_F(FindCsvColumns, LeavesAPatternWhatNothingElseNames) {
  plan_.trials.time = {"t"};
  plan_.trials.labels = {"object"};
  plan_.trials.ignore = {"aux*", "c"};
  plan_.channels = {channel_of("rest", {"*"}), channel_of("force", {"f1..f2", "aux9"})};
  const CsvColumns found = find({"t", "a", "object", "f2", "f1", "b", "aux1", "c", "aux9"}).value();
  EXPECT_EQ(found.channels, (std::vector<Names>{{"a", "b"}, {"f1", "f2", "aux9"}}));
  EXPECT_EQ(found.others, Names{});
  EXPECT_EQ(found.columns[0].use, CsvUse::kTime);
  EXPECT_EQ(found.columns[2].use, CsvUse::kLabel);
  EXPECT_EQ(found.columns[6].use, CsvUse::kNothing);
}

TEST_F(FindCsvColumns, TakesAColumnOnceInAChannel) {
  plan_.channels = {channel_of("touch", {"b", "a*", "*"})};
  EXPECT_EQ(find({"x", "a1", "b", "a2"})->channels, (std::vector<Names>{{"b", "a1", "a2", "x"}}));
}

// A range is a list of names: a pattern leaves its columns out, and none of them is taken twice.
TEST_F(FindCsvColumns, TakesTheColumnsOfARange) {
  const Names glove{"t", "thumb", "ring", "pinky", "b00", "b01", "b10", "b11", "Force..N."};
  plan_.channels = {channel_of("rest", {"*"}), channel_of("hand", {"thumb..pinky"}),
                    channel_of("pad", {"b00..b11"}), channel_of("force", {"Force..N."})};
  EXPECT_EQ(find(glove)->channels,
            (std::vector<Names>{
                {"t"}, {"thumb", "ring", "pinky"}, {"b00", "b01", "b10", "b11"}, {"Force..N."}}));
  for (const auto& columns : {Names{"thumb..pinky", "ring"}, Names{"b00..b11", "b10"},
                              Names{"ring", "thumb..pinky"}, Names{"thumb..ring", "ring..pinky"}}) {
    plan_.channels = {channel_of("touch", columns)};
    EXPECT_NE(refusal(glove).find("is mentioned twice"), std::string::npos) << refusal(glove);
  }
  plan_.channels = {channel_of("touch", {"thumb..pinky"})};
  for (const char* ignored : {"ring", "ring..pinky"}) {
    plan_.trials.ignore = {ignored};
    EXPECT_EQ(refusal(glove), "column 'ring' is both used and ignored; remove one of them");
  }
  plan_.trials.ignore = {"b00..b11", "Force..N."};
  plan_.channels = {channel_of("rest", {"*"})};
  EXPECT_EQ(find(glove)->channels, (std::vector<Names>{{"t", "thumb", "ring", "pinky"}}));
}

TEST_F(FindCsvColumns, RangesOfNumbersTakeColumnsWithoutNames) {
  Names header{"a", "b"};
  for (int column = 3; column <= 30; ++column) {
    header.push_back("(column " + std::to_string(column) + ")");
  }
  plan_.channels = {channel_of("first", {"a", "b"}), channel_of("more", {"10..26"})};
  plan_.trials.ignore = {"3..9", "27..30"};
  const CsvColumns found = find(header).value();
  EXPECT_EQ(found.channels.at(1).size(), 17U);
  EXPECT_EQ(found.columns[9].use, CsvUse::kValue);
  EXPECT_EQ(found.columns[25].use, CsvUse::kValue);
  EXPECT_EQ(found.columns[26].use, CsvUse::kNothing);
}

TEST_F(FindCsvColumns, RefusesAColumnThatTwoChannelsTake) {
  plan_.channels = {channel_of("touch", {"*1"}), channel_of("force", {"a*"})};
  EXPECT_EQ(refusal({"a2", "a1"}),
            "patterns of the channels 'touch' and 'force' both match column 'a1'; name the column "
            "in one of them, or narrow a pattern");
  plan_.channels[0].columns = {"a1"};
  EXPECT_EQ(find({"a2", "a1"})->channels, (std::vector<Names>{{"a1"}, {"a2"}}));
}

TEST_F(FindCsvColumns, RefusesAPatternThatTakesNothing) {
  plan_.channels = {channel_of("touch", {"taxl*"})};
  EXPECT_EQ(refusal({"t", "taxel"}), "no column matches 'taxl*'; did you mean 'taxel'?");
  plan_.trials.ignore = {"taxl1", "taxl2"};
  EXPECT_EQ(refusal({"taxl1", "taxl2"}),
            "all columns that match 'taxl*' are ignored or already used; leave the pattern out, or "
            "correct it");
}

TEST_F(FindCsvColumns, ChecksTheShapeOfWhatAPatternTakes) {
  plan_.channels = {channel_of("touch", {"x*"})};
  plan_.channels[0].shape = {2, 2};
  EXPECT_TRUE(find({"x1", "x2", "x3", "x4"}));
  EXPECT_EQ(refusal({"x1", "x2", "x3"}),
            "channel 'touch' has 3 elements, which do not fill its shape 2 x 2; correct the "
            "columns or the shape");
}

class ImportByPattern : public ::testing::Test {
 protected:
  ImportByPattern() {
    plan_.trials.files = "{trial:number}.csv";
    plan_.channels = {channel_of("touch", {"x*"})};
    folder_.with("1.csv", "x1,x2\n1,2\n");
  }

  Result<Recording> import() const { return import_csv_trials(folder_.path(), plan_); }

  // The error, without the folder.
  std::string refusal() const {
    const auto recording = import();
    if (recording) return "none";
    const std::string text = to_string(recording.error());
    return text.substr(std::min(text.size(), folder_.path().size()));
  }

  TemporaryFolder folder_;
  CsvImport plan_;
};

TEST_F(ImportByPattern, BringsColumnsIntoTheOrderOfTheFirstFile) {
  folder_.with("2.csv", "x2,x1\n4,3\n5,6\n");
  const Recording recording = import().value();
  EXPECT_TRUE(validate(recording));
  EXPECT_EQ(recording.explorations[1].channels[0],
            (Channel{"touch", "", {"x1", "x2"}, Matrix<float>(2, 2, {3, 4, 6, 5}), {}}));
}

TEST_F(ImportByPattern, RefusesOtherColumnsThanInTheFirstFile) {
  const std::string first = folder_.file("1.csv");
  folder_.with("2.csv", "x1,x2,x3\n1,2,3\n");
  EXPECT_EQ(refusal(), "/2.csv: a pattern matches column 'x3' here, but not in " + first +
                           "; name the column, ignore it, or import the files separately");
  folder_.with("2.csv", "x1\n1\n");
  EXPECT_EQ(refusal(), "/2.csv: a pattern matches column 'x2' in " + first +
                           ", but not here; name the column, ignore it, or import the files "
                           "separately");
}

TEST_F(ImportByPattern, NamesThePlaceOfAPatternWithoutColumns) {
  plan_.trials.other_columns = Unmentioned::kIgnore;
  folder_.with("2.csv", "# made by hand\nX1,y2\n1,2\n");
  EXPECT_EQ(refusal(), "/2.csv:2: no column matches 'x*'; did you mean 'X1'?");
}

TEST_F(ImportByPattern, RefusesAnIgnoredColumnThatIsInNoFile) {
  folder_.with("2.csv", "x1,x2,aux\n1,2,never read\n");
  plan_.trials.ignore = {"aux"};
  EXPECT_EQ(import()->explorations[1].channels[0].frames.columns(), 2U);
  for (const char* entry : {"x02", "x02*"}) {
    plan_.trials.ignore = {"aux", entry};
    EXPECT_EQ(refusal(),
              std::string(": 'ignore': no column matches '") + entry + "'; did you mean 'x2'?");
  }
}

}  // namespace
}  // namespace somato
