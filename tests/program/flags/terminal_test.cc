#include "base/support/sanitized.h"
#include "program/support/program_test.h"
#include "somato/core/matrix.h"
#include "somato/files/npy.h"

namespace somato {
namespace {

class Terminal : public ProgramTest {
 protected:
  static ProgramWorld terminal(const std::string& interrupt_at = {}) {
    ProgramWorld world;
    world.terminal = true;
    world.interrupt_at = interrupt_at;
    world.seconds = 60;
    return world;
  }
};

TEST_F(Terminal, ShowsTheShareDoneAndTheTimeLeft) {
  write_data();
  const ProgramRun done =
      run({"som", "train", "data.csv", "-o", "x", "--iterations", "2000"}, terminal());
  EXPECT_EQ(done.exit_code, 0);
  EXPECT_NE(done.err.find("reading: 100 %, took "), std::string::npos) << done.err;
  EXPECT_NE(done.err.find("training:   3 %, "), std::string::npos) << done.err;
  EXPECT_NE(done.err.find(" left\x1b[K"), std::string::npos) << done.err;
  EXPECT_NE(done.err.find("training: 100 %, took "), std::string::npos) << done.err;
  EXPECT_TRUE(done.err.ends_with("\n"));
}

// Parts of some of the rows, as large files have them, but all kept.
TEST_F(Terminal, ShowsHowFarAFileIsReadThatFitsIntoMemory) {
  write("rows.npy", encode_npy(Matrix<float>(30000, 10, 0.5F)));
  const ProgramRun done =
      run({"som", "train", "rows.npy", "--keep-constant-columns", "--iterations", "10", "-o", "x",
           "--rows", "2", "--columns", "2", "--memory", "4MB"},
          terminal());
  EXPECT_EQ(done.exit_code, 0) << done.err;
  const std::size_t first = done.err.find("reading:  ");
  ASSERT_NE(first, std::string::npos) << done.err;
  EXPECT_LT(done.err.find(" left", first), done.err.find("reading: 100 %, took ")) << done.err;
}

TEST_F(Terminal, APipeStaysQuiet) {
  write_data();
  output_of({"som", "train", "data.csv", "-o", "x", "--iterations", "2000"});
}

TEST_F(Terminal, AnInterruptStopsTrainingAndKeepsTheOldFile) {
  train();
  const std::string rows = std::to_string(testing::fewer_if_sanitized(1000));
  const std::vector<Words> trainings{
      {"--iterations", "1000000000"},
      {"--iterations", "1000000000", "--arithmetic", "inner_products"},
      {"--training", "batch", "--epochs", "1000000000"},
      {"--iterations", "1000000000", "--rows", rows, "--columns", "1000"}};
  for (const Words& flags : trainings) {
    SCOPED_TRACE(::testing::PrintToString(flags));
    Words arguments{"som", "train", "data.csv", "-o", "good.map"};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    const auto before = contents();
    const ProgramRun done = run(arguments, terminal("training: "));
    EXPECT_EQ(done.exit_code, 130);
    EXPECT_EQ(done.out, "");
    EXPECT_NE(done.err.find("somato: training was stopped before its end"), std::string::npos)
        << done.err;
    EXPECT_TRUE(contents() == before);
  }
}

// As service managers ask for an end.
TEST_F(Terminal, ARequestToTerminateHasAnExitCodeOfItsOwn) {
  train();
  ProgramWorld world = terminal("training: ");
  world.interrupt_with = SIGTERM;
  const auto before = contents();
  EXPECT_EQ(run({"som", "train", "data.csv", "-o", "good.map", "--iterations", "1000000000"}, world)
                .exit_code,
            143);
  EXPECT_TRUE(contents() == before);
}

// Ctrl-C while a study of `seeds` runs; what was done is kept.
class TerminalStudy : public Terminal {
 protected:
  ProgramRun interrupted(const Words& arguments) const {
    ProgramRun done = run(arguments, terminal(" left"));
    EXPECT_EQ(done.exit_code, 130);
    EXPECT_EQ(done.out, "");
    EXPECT_NE(done.err.find("somato: the study was stopped before its end"), std::string::npos)
        << done.err;
    EXPECT_NE(done.err.find("the same command resumes it"), std::string::npos) << done.err;
    return done;
  }
};

TEST_F(TerminalStudy, AnInterruptKeepsCompletedWorkAndTheSameCommandResumes) {
  write_study("10", std::to_string(testing::fewer_if_sanitized(20000)));
  const Words words{"run", "study.toml", "--data", kTrials, "--out", "out", "--threads", "1"};
  interrupted(words);
  EXPECT_FALSE(std::filesystem::exists(path("out/results.json")));
  EXPECT_FALSE(std::filesystem::exists(path("out/system.somato")));
  const std::string journal = read("out/unfinished.journal");
  EXPECT_FALSE(journal.empty());
  output_of(words);
  EXPECT_FALSE(std::filesystem::exists(path("out/unfinished.journal")));
  output_of({"run", "study.toml", "--data", kTrials, "--out", "whole"});
  for (const std::string file : {"/results.json", "/map.svg", "/system.somato"}) {
    EXPECT_TRUE(read("out" + file) == read("whole" + file)) << file;
  }
}

TEST_F(TerminalStudy, AnotherStudyDoesNotGoOnWithIt) {
  write_study("100000", "400");
  const Words words{"run", "study.toml", "--data", kTrials, "--out", "out"};
  interrupted(words);
  write_study("100000", "401");
  expect_refused(
      2, words,
      {"out/unfinished.journal: ", "other settings or data", "use another folder (--out)"});
  std::string damaged = read("out/unfinished.journal");
  damaged[20] ^= 1;  // of the line that identifies the file
  write("out/unfinished.journal", damaged);
  write_study("100000", "400");
  expect_refused(1, words,
                 {"out/unfinished.journal: ", "damaged", "remove it to restart the study"});
}

}  // namespace
}  // namespace somato
