#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "program/support/program_test.h"

namespace somato {
namespace {

// Ten things each of three kinds, which their width and weight separate; the unit of one column
// makes it a thousand times larger than the other.
std::string table(const std::string& missing = "") {
  std::string text = "date,width,grams,kind\n";
  for (int i = 0; i < 30; ++i) {
    const int kind = i % 3;
    const std::string width = std::to_string(8 + 3 * kind) + "." + std::to_string(i % 7);
    text += "2026-05-01," + (i == 4 && !missing.empty() ? missing : width) + "," +
            std::to_string(9000 - 900 * kind + (37 * i) % 50) + ",kind" + std::to_string(kind) +
            "\n";
  }
  return text;
}

class TableData : public ProgramTest {
 protected:
  void suggest(const Words& more = {}) const {
    Words words{"suggest", "t.csv", "--label-column", "kind", "--skip", "date", "-o", "s.toml"};
    words.insert(words.end(), more.begin(), more.end());
    output_of(words);
  }

  nlohmann::json run_study(const Words& more = {}) const {
    Words words{"run", "s.toml", "--data", "t.csv", "--seeds", "2", "--out", "out"};
    words.insert(words.end(), more.begin(), more.end());
    output_of(words);
    return nlohmann::json::parse(read("out/results.json"));
  }
};

TEST_F(TableData, IsGoneThroughFromASuggestionToAReportWithFlagsGivenOnce) {
  write("t.csv", table());
  suggest();
  const auto results = run_study();
  EXPECT_NE(results.dump().find("skip = "), std::string::npos);
  write("new.csv", "grams,date,width\n8110,2026-06-01,11\n");
  const std::string answers = output_of({"apply", "out/system.somato", "new.csv"});
  EXPECT_NE(answers.find(",kind1,\"\"\n"), std::string::npos) << answers;
  const std::string lines =
      output_of({"live", "--model", "out/system.somato", "--recording", "t.csv", "--speed", "max"});
  EXPECT_NE(lines.find("\"given\":\"kind0\",\"right\":true"), std::string::npos);
  EXPECT_EQ(output_of({"report", "out/results.json", "--data", "t.csv", "-o", "r.html"}),
            "r.html: 1 system, 0 claims\n");
  const std::string information = output_of({"information", "s.toml", "--data", "t.csv"});
  EXPECT_LT(information.find("    grams "), information.find("    width "));
}

TEST_F(TableData, TheSuggestionOfColumnsOfUnknownUnitsIsStandardized) {
  write("t.csv", table());
  suggest();
  EXPECT_NE(read("s.toml").find("\ninput = \"standardized_last_of_columns\"\nrows = "),
            std::string::npos);
}

TEST_F(TableData, MissingValuesGetTheMeanOfTheirColumn) {
  write("t.csv", table("NA"));
  expect_refused(1,
                 {"suggest", "t.csv", "--label-column", "kind", "--skip", "date", "-o", "s.toml"},
                 {"t.csv:6:12"});
  suggest({"--missing", "mean"});
  EXPECT_NE(read("s.toml").find("\nfill = ["), std::string::npos);
  run_study();
  write("new.csv", "width,grams\n,8110\n");
  EXPECT_EQ(run({"apply", "out/system.somato", "new.csv"}).exit_code, 0);
}

TEST_F(TableData, FlagsOfARunAreKeptInItsResults) {
  write("t.csv", table());
  write("s.toml",
        "[study]\nname = 's'\nprotocols = ['k_folds']\nfolds = 5\n"
        "[module.c]\ntype = 'channel'\nchannel = 'columns'\n"
        "[module.v]\ntype = 'last'\ninput = 'c'\n"
        "[module.map]\ntype = 'som'\ninput = 'v'\n");
  const auto results = run_study({"--label-column", "kind", "--skip", "date"});
  const std::string text = results.dump();
  EXPECT_NE(text.find("label_column = \\\"kind\\\""), std::string::npos);
  EXPECT_NE(text.find("label = \\\"kind\\\""), std::string::npos);
  EXPECT_EQ(output_of({"report", "out/results.json", "--data", "t.csv", "-o", "r.html"}),
            "r.html: 1 system, 0 claims\n");
}

TEST_F(TableData, RefusesWhatAStudyCannotDo) {
  write("t.csv", table());
  expect_refused(2, {"suggest", "t.csv", "--missing", "nearest", "-o", "s.toml"},
                 {"--missing: ", "use --missing mean"});
  suggest();
  expect_refused(2, {"run", "s.toml", "--data", kTrials, "--out", "out"},
                 {"'label_column' is a setting of tables"});
}

}  // namespace
}  // namespace somato
