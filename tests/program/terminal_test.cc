#include "program/program_test.h"

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
  EXPECT_NE(done.err.find("training:   3 %, "), std::string::npos) << done.err;
  EXPECT_NE(done.err.find(" left\x1b[K"), std::string::npos) << done.err;
  EXPECT_NE(done.err.find("training: 100 %, took "), std::string::npos) << done.err;
  EXPECT_TRUE(done.err.ends_with("\n"));
}

TEST_F(Terminal, APipeStaysQuiet) {
  write_data();
  output_of({"som", "train", "data.csv", "-o", "x", "--iterations", "2000"});
}

TEST_F(Terminal, AnInterruptStopsTrainingAndKeepsTheOldFile) {
  train();
  const std::vector<Words> trainings{
      {"--iterations", "1000000000"},
      {"--iterations", "1000000000", "--arithmetic", "inner_products"},
      {"--training", "batch", "--epochs", "1000000000"},
      {"--iterations", "1000000000", "--rows", "2000", "--columns", "2000"}};
  for (const Words& flags : trainings) {
    SCOPED_TRACE(::testing::PrintToString(flags));
    Words arguments{"som", "train", "data.csv", "-o", "good.map"};
    arguments.insert(arguments.end(), flags.begin(), flags.end());
    const auto before = contents();
    const ProgramRun done = run(arguments, terminal(" left"));
    EXPECT_EQ(done.exit_code, 130);
    EXPECT_EQ(done.out, "");
    EXPECT_NE(done.err.find("somato: training was stopped before its end"), std::string::npos)
        << done.err;
    EXPECT_TRUE(contents() == before);
  }
}

TEST_F(Terminal, AnInterruptStopsAStudyAndLeavesNothing) {
  write("study.toml",
        "[study]\nname = 'long'\nseeds = 100000\n[vector]\nchannels = ['joints']\n[map]\n"
        "rows = 4\ncolumns = 4\niterations = 100\n");
  const auto before = contents();
  const ProgramRun done =
      run({"run", "study.toml", "--data", SOMATO_SOURCE_DIR "/examples/synthetic_grasps/trials",
           "--out", "out"},
          terminal(" left"));
  EXPECT_EQ(done.exit_code, 130);
  EXPECT_NE(done.err.find("stopped"), std::string::npos) << done.err;
  EXPECT_TRUE(contents() == before);
}

}  // namespace
}  // namespace somato
