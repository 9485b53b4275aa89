#include <csignal>

#include "base/core/memory.h"
#include "base/support/sanitized.h"
#include "program/support/program_test.h"
#include "somato/recording/recording_file.h"

namespace somato {
namespace {

class Output : public ProgramTest {
 protected:
  static ProgramWorld output_to(const std::string& where) {
    ProgramWorld world;
    world.output_to = where;
    return world;
  }

  // The output could not be written: exit code 1 and one line that states this.
  void expect_unheard(const Words& arguments, const std::string& where) const {
    SCOPED_TRACE(::testing::PrintToString(arguments));
    const ProgramRun done = run(arguments, output_to(where));
    EXPECT_EQ(done.exit_code, 1);
    EXPECT_EQ(done.err.find("somato: standard output: cannot write"), 0u) << done.err;
    EXPECT_EQ(done.err.find('\n'), done.err.size() - 1) << done.err;
  }
};

const Words kTrain{"som", "train", "data.csv", "-o"};
const Words kMap{"som", "map", "good.map", "data.csv", "-o"};
const Words kActivity{"som", "map", "good.map", "data.csv", "--activity"};
const Words kPlot{"som", "plot", "good.map", "-o"};

Words to(Words words, const std::string& path) {
  words.push_back(path);
  return words;
}

TEST_F(Output, ThatCannotBeSavedIsRefused) {
  train();
  std::filesystem::create_directory(path("folder"));
  std::filesystem::create_symlink("loop", path("loop"));
  std::filesystem::create_symlink("nowhere/x", path("dangling"));
  for (const Words& words : {kTrain, kMap, kActivity, kPlot}) {
    expect_refused(1, {{to(words, "no/x"), {"no/x: cannot save", "No such file", "check the path"}},
                       {to(words, "folder"), {"folder: cannot save", "name a file, not a folder"}},
                       {to(words, "data.csv/x"), {"data.csv/x: cannot save", "Not a directory"}},
                       {to(words, "loop"), {"loop: cannot save", "symbolic links"}},
                       {to(words, "dangling"), {"x: cannot save", "No such file"}},
                       {to(words, "/dev/full"),
                        {"/dev/full: cannot save", "No space left", "free disk space"}}});
  }
}

// Before the data are read.
TEST_F(Output, ItsPlaceIsLookedAtFirst) {
  expect_refused(1, {{{"som", "train", "missing", "-o", "no/x"}, {"no/x"}},
                     {{"som", "map", "missing", "missing", "-o", "no/x"}, {"no/x"}},
                     {{"som", "plot", "missing", "-o", "no/x"}, {"no/x"}}});
}

TEST_F(Output, AFullDiskLeavesTheOldFile) {
  train();
  write("old", "old content");
  ProgramWorld world;
  world.largest_file = 100;
  for (const Words& words : {kTrain, kMap, kActivity, kPlot}) {
    for (const char* name : {"new", "old"}) {
      expect_refused(1, to(words, name), {std::string(name) + ": cannot save", "File too large"},
                     world);
    }
  }
}

TEST_F(Output, FullOrClosedStandardOutputIsAFailure) {
  train();
  for (const char* where : {"/dev/full", "closed"}) {
    expect_unheard({"som", "map", "good.map", "data.csv"}, where);
    expect_unheard({"som", "quality", "good.map", "data.csv"}, where);
    expect_unheard({"reference"}, where);
    expect_unheard({"--help"}, where);
    expect_unheard({"--version"}, where);
  }
}

// The number of a closed standard stream must not go to the next file that is opened.
TEST_F(Output, AClosedStandardOutputDoesNotSpoilFiles) {
  train();
  const std::string map = read("good.map");
  expect_unheard({"som", "train", "data.csv", "-o", "again.map", "--rows", "4", "--columns", "5",
                  "--iterations", "200"},
                 "closed");
  EXPECT_EQ(read("again.map"), map);
}

TEST_F(Output, AReaderThatLeavesIsNoError) {
  std::string rows;
  for (int i = 0; i < 20000; ++i) rows += data();
  train();
  write("many.csv", rows);
  ProgramWorld world;
  world.closes_output = true;
  const ProgramRun done = run({"som", "map", "good.map", "many.csv"}, world);
  EXPECT_EQ(done.err, "");
  EXPECT_EQ(done.signal, SIGPIPE);
}

TEST_F(Output, MapsLargerThanTheMemoryAreRefusedWithTheirSize) {
  if (memory_of_machine() >= std::size_t{1} << 38) GTEST_SKIP() << "a large machine";
  std::string wide;
  for (int row = 0; row < 2; ++row) {
    for (int i = 0; i < 4096; ++i) wide += (i > 0 ? "," : "") + std::to_string((row + 1) * i + row);
    wide += "\n";
  }
  write("wide.csv", wide);
  // 2^24 neurons x 2^12 features x 4 bytes are 2^38 bytes.
  for (const char* arithmetic : {"plain", "inner_products", "automatic"}) {
    expect_refused(1,
                   {"som", "train", "wide.csv", "-o", "x", "--rows", "4096", "--columns", "4096",
                    "--arithmetic", arithmetic},
                   {"4096 x 4096 neurons of 4096 features", "256.0 GiB", "choose fewer rows"});
  }
}

TEST_F(Output, ShortMemoryIsAnErrorLikeOthers) {
#ifdef SOMATO_TESTS_SANITIZED
  GTEST_SKIP() << "sanitizers need all the address space";
#endif
  write_data();
  ProgramWorld world;
  // Weights take 192 MiB, and the activity of one row 64.
  const Words words{"som", "train",  "data.csv", "-o",        "x",   "--iterations",
                    "1",   "--rows", "4096",     "--columns", "4096"};
  world.memory = std::size_t{100} << 20;
  expect_refused(1, words, {"need 192.0 MiB of memory", "limits leave this process"}, world);
  world.memory = std::size_t{400} << 20;
  expect_refused(1, words, {"not enough memory", "smaller map"}, world);
}

// A small file that unpacks to 64 MiB of zeros.
TEST_F(Output, RecordingsThatUnpackToMoreThanThereIsAreRefused) {
#ifdef SOMATO_TESTS_SANITIZED
  GTEST_SKIP() << "sanitizers need all the address space";
#endif
  Channel zeros{"joints", "deg", {}, Matrix<float>(16, 1 << 20), {}, 10.0};
  const Recording recording{{{{{"object", "ball"}}, {}, {std::move(zeros)}}}};
  ASSERT_TRUE(write_recording(path("zeros.mcap"), recording));
  write_study();
  ProgramWorld world;
  world.memory = std::size_t{180} << 20;
  expect_refused(1, {"run", "study.toml", "--data", "zeros.mcap", "--out", "out"},
                 {"zeros.mcap: its frames exceed the available memory", "shorter recording"},
                 world);
  EXPECT_EQ(run({"inspect", "zeros.mcap"}, world).exit_code, 0);
}

// 30 explorations of 9 joints at 500,000 points are 540 MB.
TEST_F(Output, ModulesThatTakeMoreMemoryThanThereIsAreNamed) {
#ifdef SOMATO_TESTS_SANITIZED
  GTEST_SKIP() << "sanitizers need all the address space";
#endif
  write("study.toml",
        "[study]\nname = 'long'\nlabel = 'object'\nseeds = 1\n"
        "[module.joints]\ntype = 'channel'\nchannel = 'joints'\n"
        "[module.curve]\ntype = 'resampling'\ninput = 'joints'\npoints = 500000\n"
        "[module.map]\ntype = 'som'\ninput = 'curve'\nrows = 1\ncolumns = 1\niterations = 1\n");
  ProgramWorld world;
  world.memory = std::size_t{400} << 20;
  expect_refused(1, {"run", "study.toml", "--data", kTrials, "--out", "out"},
                 {"study.toml:8, module 'curve': ", "memory", "reduce the number of its elements"},
                 world);
}

}  // namespace
}  // namespace somato
