#include <nlohmann/json.hpp>

#include "program/support/program_test.h"
#include "somato/recording/recording_file.h"
#include "studies/support/made_senses.h"

namespace somato {
namespace {

class SuggestProgram : public ProgramTest {
 protected:
  void write_things(const std::string& name = "things.mcap") const {
    const std::vector<std::size_t> kinds{0, 1, 2, 3};
    ASSERT_TRUE(write_recording(path(name),
                                testing::made_senses(4, 3, {{"joints", kinds}, {"touch", kinds}})));
  }
};

TEST_F(SuggestProgram, WritesAStudyThatRuns) {
  write_things();
  const std::string shown = output_of({"suggest", "things.mcap", "-o", "suggested.toml"});
  EXPECT_TRUE(shown.starts_with("suggested.toml: 2 of 2 channels are senses, ")) << shown;
  EXPECT_TRUE(read("suggested.toml").starts_with("# Suggested by 'somato suggest' from 12 "));
  const std::string run =
      output_of({"run", "suggested.toml", "--data", "things.mcap", "--seeds", "1", "--out", "out"});
  EXPECT_NE(run.find("suggested: leave_one_out by object, 12 samples"), std::string::npos) << run;
}

TEST_F(SuggestProgram, TheFileDoesNotDependOnThreadsOrQuiet) {
  write_things();
  output_of({"suggest", "things.mcap", "-o", "one.toml", "--threads", "1"});
  EXPECT_EQ(output_of({"suggest", "things.mcap", "-o", "four.toml", "--threads", "4", "--quiet"}),
            "");
  EXPECT_EQ(read("one.toml"), read("four.toml"));
}

TEST_F(SuggestProgram, JsonHasTheScores) {
  write_things();
  const auto json = nlohmann::json::parse(
      output_of({"suggest", "things.mcap", "-o", "suggested.toml", "--json"}));
  EXPECT_EQ(json["explorations"], 12);
  EXPECT_EQ(json["parts"].size() > 0, true);
}

TEST_F(SuggestProgram, MentionsALabelThatTheRecordingLacks) {
  write_things();
  const std::string shown =
      output_of({"suggest", "things.mcap", "-o", "suggested.toml", "--label", "material"});
  EXPECT_NE(shown.find("The recording has only the labels object, trial"), std::string::npos);
  EXPECT_EQ(output_of({"suggest", "things.mcap", "-o", "suggested.toml", "--study", "texture"})
                .find("labels"),
            std::string::npos);
}

TEST_F(SuggestProgram, RefusesWhatCannotBeUsed) {
  write_things();
  write("text.toml", "[study]\nname = 'x'\n");
  ASSERT_TRUE(write_recording(path("one.mcap"), testing::made_senses(1, 1, {{"touch", {0}}})));
  expect_refused(1, {"suggest", "one.mcap", "-o", "out.toml"},
                 {"one.mcap", "the recording has only one exploration; "});
  expect_refused(2, {"suggest", "things.mcap", "-o", "things.mcap"}, {"things.mcap"});
  expect_refused(2, {"suggest", "things.mcap", "-o", "text.toml", "--study", "text.toml"},
                 {"text.toml"});
  expect_refused(2, {"suggest", "things.mcap"}, {"--output"});
  expect_refused(1, {"suggest", "missing.mcap", "-o", "out.toml"}, {"missing.mcap"});
  expect_refused(1, {"suggest", "things.mcap", "-o", "missing/out.toml"}, {"missing"});
  expect_refused(2, {"suggest", "things.mcap", "-o", "out.toml", "--budget", "0"}, {"--budget"});
  expect_refused(2,
                 {"suggest", "things.mcap", "-o", "out.toml", "--study", "texture", "--label", "x"},
                 {"--label: has no effect with --study"});
}

}  // namespace
}  // namespace somato
