#include "recordings/tables/csv_trial_reader.h"

#include <gtest/gtest.h>

#include "recordings/support/csv_trials_test.h"

namespace somato {
namespace {

using Names = std::vector<std::string>;

using CsvTrialReader = CsvTrialsTest;

TEST_F(CsvTrialReader, RefusesColumnsWithoutNames) {
  for (const char* text : {",a,b\n0,1,2\n", "  ,a,b\n0,1,2\n", "Unnamed: 0,a,b\n0,1,2\n"}) {
    EXPECT_EQ(error_for(text),
              "x_1.csv:1: column 1 has no name; usually this is the index of pandas or the row "
              "names of R: write the table without it (index=False, row.names=FALSE), or "
              "list 1 under 'ignore'");
  }
  EXPECT_NE(error_for("a,b,\n1,2,\n").find("column 3 has no name; a separator ends the line"),
            std::string::npos);
  EXPECT_NE(error_for("a,b\nr1,1,2\n").find("found 3, one more than names; if the first column"),
            std::string::npos);
  EXPECT_NE(error_for("a,b\n1,2,\n").find("a separator ends the line"), std::string::npos);
  EXPECT_NE(error_for(",a,b,c\n0,1,2,3\n").find("not mentioned: '(column 1)', 'c'"),
            std::string::npos);
  EXPECT_NE(error_for(",a,b,1\n0,1,2,3\n").find("'(column 1)', '1'; assign"), std::string::npos);
  plan_.channels[0].columns = {"a", "1"};
  EXPECT_NE(error_for(",a,1\n0,1,2\n").find("list '(column 1)' under"), std::string::npos)
      << "1 is the name of another column";
  plan_.channels = {channel_of("touch", {"*"})};
  EXPECT_NE(error_for(",a,b\n0,1,2\n").find("column 1 has no name"), std::string::npos)
      << "a pattern does not match it";
}

TEST_F(CsvTrialReader, SelectsColumnsWithoutNamesByNumber) {
  for (const char* entry : {"1", "(column 1)", "(*"}) {
    plan_.trials.ignore = {entry};
    EXPECT_EQ(read(",a,b\n0,1,2\n").channels[0].frames, matrix(1, {1, 2})) << entry;
  }
  plan_.trials.ignore = {};
  plan_.channels = {channel_of("touch", {"1", "a", "b"})};
  const Channel touch = read(",a,b\n0,1,2\n").channels[0];
  EXPECT_EQ(touch.frames, matrix(1, {0, 1, 2}));
  EXPECT_EQ(touch.element_names, (Names{"(column 1)", "a", "b"}));
  plan_.trials.ignore = {"2"};
  EXPECT_EQ(read("1,,a,b\n0,9,1,2\n").channels[0].element_names, (Names{"1", "a", "b"}))
      << "a name precedes a number";
  plan_.trials.ignore = {};
  plan_.channels = {channel_of("touch", {"1", "(column 1)", "a"})};
  EXPECT_NE(error_for(",a\n0,1\n").find("column 1 is mentioned twice"), std::string::npos);
  plan_.channels = {channel_of("touch", {"a"})};
  plan_.trials.time = {"1"};
  EXPECT_EQ(read(",a\n5,1\n6,2\n").channels[0].times, (std::vector<double>{0, 1}));
}

TEST_F(CsvTrialReader, ReadsDecimalCommas) {
  plan_.trials.decimal = DecimalMark::kComma;
  EXPECT_EQ(read("a;b\n1,5;2\n3,25;-4\n").channels[0].frames, matrix(2, {1.5, 2, 3.25, -4}));
  EXPECT_EQ(read("sep=;\na;b\n1,5;2\n").channels[0].frames, matrix(1, {1.5, 2}));
  EXPECT_EQ(error_for("a;b\n1.5;2\n"),
            "x_1.csv:2:1: '1.5' is not a number; numbers are read with a decimal comma: write them "
            "without a point");
  plan_.trials.labels = {"mass"};
  plan_.channels.push_back(channel_of("mass", {}));
  plan_.channels[1].from_label = "mass";
  EXPECT_EQ(read("a;b;mass\n1;2;7,5\n").channels[1].frames, matrix(1, {7.5}));
  plan_.trials.labels = {};
  plan_.trials.files = "{object}_{mass:number}.csv";
  folder_.with("x_1.csv", "a;b\n1;2\n");
  folder_.with("y_2.5.csv", "a;b\n1;2\n");
  EXPECT_EQ(import()->explorations[1].channels[1].frames, matrix(1, {2.5}))
      << "names of files have points";
  plan_.trials.decimal = DecimalMark::kPoint;
  EXPECT_NE(error_for("a;b\n1,5;2\n").find("read decimal commas"), std::string::npos);
}

TEST_F(CsvTrialReader, ReadsTheLineOfSpreadsheets) {
  EXPECT_EQ(read("sep=;\na;b\n1;2\n").channels[0].frames, matrix(1, {1, 2}));
  EXPECT_EQ(error_for("sep=;\na;b\n1;x\n"),
            "x_1.csv:3:3: 'x' is not a number; correct it, or list its column under 'ignore'");
}

TEST_F(CsvTrialReader, ReadsGuardedLabels) {
  plan_.trials.labels = {"kind"};
  EXPECT_EQ(read("a,b,kind\n1,2,'=1+1\n").labels.back(), (Label{"kind", "=1+1"}));
  EXPECT_EQ(read("a,b,kind\n1,2,'-\n").labels.back(), (Label{"kind", "-"}));
  EXPECT_EQ(read("a,b,kind\n1,2,''@x\n").labels.back(), (Label{"kind", "'@x"}));
}

}  // namespace
}  // namespace somato
