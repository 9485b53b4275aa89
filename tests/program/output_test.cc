#include <csignal>
#include "support/sanitized.h"

#include "program/program_test.h"
#include "somato/core/memory.h"
#include "support/sanitized.h"

#include "support/sanitized.h"
namespace somato {
#include "support/sanitized.h"
namespace {
#include "support/sanitized.h"

#include "support/sanitized.h"
class Output : public ProgramTest {
#include "support/sanitized.h"
 protected:
#include "support/sanitized.h"
  static ProgramWorld output_to(const std::string& where) {
#include "support/sanitized.h"
    ProgramWorld world;
#include "support/sanitized.h"
    world.output_to = where;
#include "support/sanitized.h"
    return world;
#include "support/sanitized.h"
  }
#include "support/sanitized.h"

#include "support/sanitized.h"
  // Whatever was done, it was not told: exit code 1 and one line that says so.
#include "support/sanitized.h"
  void expect_unheard(const Words& arguments, const std::string& where) const {
#include "support/sanitized.h"
    SCOPED_TRACE(::testing::PrintToString(arguments));
#include "support/sanitized.h"
    const ProgramRun done = run(arguments, output_to(where));
#include "support/sanitized.h"
    EXPECT_EQ(done.exit_code, 1);
#include "support/sanitized.h"
    EXPECT_EQ(done.err.find("somato: standard output: cannot write"), 0u) << done.err;
#include "support/sanitized.h"
    EXPECT_EQ(done.err.find('\n'), done.err.size() - 1) << done.err;
#include "support/sanitized.h"
  }
#include "support/sanitized.h"
};
#include "support/sanitized.h"

#include "support/sanitized.h"
const Words kTrain{"som", "train", "data.csv", "-o"};
#include "support/sanitized.h"
const Words kMap{"som", "map", "good.map", "data.csv", "-o"};
#include "support/sanitized.h"
const Words kActivity{"som", "map", "good.map", "data.csv", "--activity"};
#include "support/sanitized.h"
const Words kPlot{"som", "plot", "good.map", "-o"};
#include "support/sanitized.h"

#include "support/sanitized.h"
Words to(Words words, const std::string& path) {
#include "support/sanitized.h"
  words.push_back(path);
#include "support/sanitized.h"
  return words;
#include "support/sanitized.h"
}
#include "support/sanitized.h"

#include "support/sanitized.h"
TEST_F(Output, ThatCannotBeSavedIsRefused) {
#include "support/sanitized.h"
  train();
#include "support/sanitized.h"
  std::filesystem::create_directory(path("folder"));
#include "support/sanitized.h"
  std::filesystem::create_symlink("loop", path("loop"));
#include "support/sanitized.h"
  std::filesystem::create_symlink("nowhere/x", path("dangling"));
#include "support/sanitized.h"
  for (const Words& words : {kTrain, kMap, kActivity, kPlot}) {
#include "support/sanitized.h"
    expect_refused(
#include "support/sanitized.h"
        1, {{to(words, "no/x"), {"no/x: cannot save", "No such file", "check the path"}},
#include "support/sanitized.h"
            {to(words, "folder"), {"folder: cannot save", "name a file, not a folder"}},
#include "support/sanitized.h"
            {to(words, "data.csv/x"), {"data.csv/x: cannot save", "Not a directory"}},
#include "support/sanitized.h"
            {to(words, "loop"), {"loop: cannot save", "symbolic links"}},
#include "support/sanitized.h"
            {to(words, "dangling"), {"x: cannot save", "No such file"}},
#include "support/sanitized.h"
            {to(words, "/dev/full"), {"/dev/full: cannot save", "No space left", "make room"}}});
#include "support/sanitized.h"
  }
#include "support/sanitized.h"
}
#include "support/sanitized.h"

#include "support/sanitized.h"
// Before the data are read, let alone learned from.
#include "support/sanitized.h"
TEST_F(Output, ItsPlaceIsLookedAtFirst) {
#include "support/sanitized.h"
  expect_refused(1, {{{"som", "train", "missing", "-o", "no/x"}, {"no/x"}},
#include "support/sanitized.h"
                     {{"som", "map", "missing", "missing", "-o", "no/x"}, {"no/x"}},
#include "support/sanitized.h"
                     {{"som", "plot", "missing", "-o", "no/x"}, {"no/x"}}});
#include "support/sanitized.h"
}
#include "support/sanitized.h"

#include "support/sanitized.h"
TEST_F(Output, AFullDiskLeavesTheOldFile) {
#include "support/sanitized.h"
  train();
#include "support/sanitized.h"
  write("old", "old content");
#include "support/sanitized.h"
  ProgramWorld world;
#include "support/sanitized.h"
  world.largest_file = 100;
#include "support/sanitized.h"
  for (const Words& words : {kTrain, kMap, kActivity, kPlot}) {
#include "support/sanitized.h"
    for (const char* name : {"new", "old"}) {
#include "support/sanitized.h"
      expect_refused(1, to(words, name), {std::string(name) + ": cannot save", "File too large"},
#include "support/sanitized.h"
                     world);
#include "support/sanitized.h"
    }
#include "support/sanitized.h"
  }
#include "support/sanitized.h"
}
#include "support/sanitized.h"

#include "support/sanitized.h"
TEST_F(Output, FullOrClosedStandardOutputIsAFailure) {
#include "support/sanitized.h"
  train();
#include "support/sanitized.h"
  for (const char* where : {"/dev/full", "closed"}) {
#include "support/sanitized.h"
    expect_unheard({"som", "map", "good.map", "data.csv"}, where);
#include "support/sanitized.h"
    expect_unheard({"som", "quality", "good.map", "data.csv"}, where);
#include "support/sanitized.h"
    expect_unheard({"reference"}, where);
#include "support/sanitized.h"
    expect_unheard({"--help"}, where);
#include "support/sanitized.h"
    expect_unheard({"--version"}, where);
#include "support/sanitized.h"
  }
#include "support/sanitized.h"
}
#include "support/sanitized.h"

#include "support/sanitized.h"
// The number of a closed standard stream must not go to the next file that is opened.
#include "support/sanitized.h"
TEST_F(Output, AClosedStandardOutputDoesNotSpoilFiles) {
#include "support/sanitized.h"
  train();
#include "support/sanitized.h"
  const std::string map = read("good.map");
#include "support/sanitized.h"
  expect_unheard({"som", "train", "data.csv", "-o", "again.map", "--rows", "4", "--columns", "5",
#include "support/sanitized.h"
                  "--iterations", "200"},
#include "support/sanitized.h"
                 "closed");
#include "support/sanitized.h"
  EXPECT_EQ(read("again.map"), map);
#include "support/sanitized.h"
}
#include "support/sanitized.h"

#include "support/sanitized.h"
TEST_F(Output, AReaderThatLeavesIsNoError) {
#include "support/sanitized.h"
  std::string rows;
#include "support/sanitized.h"
  for (int i = 0; i < 20000; ++i) rows += data();
#include "support/sanitized.h"
  train();
#include "support/sanitized.h"
  write("many.csv", rows);
#include "support/sanitized.h"
  ProgramWorld world;
#include "support/sanitized.h"
  world.closes_output = true;
#include "support/sanitized.h"
  const ProgramRun done = run({"som", "map", "good.map", "many.csv"}, world);
#include "support/sanitized.h"
  EXPECT_EQ(done.err, "");
#include "support/sanitized.h"
  EXPECT_EQ(done.signal, SIGPIPE);
#include "support/sanitized.h"
}
#include "support/sanitized.h"

#include "support/sanitized.h"
TEST_F(Output, MapsLargerThanTheMemoryAreRefusedWithTheirSize) {
#include "support/sanitized.h"
  if (memory_of_machine() >= std::size_t{1} << 38) GTEST_SKIP() << "a large machine";
#include "support/sanitized.h"
  std::string wide;
#include "support/sanitized.h"
  for (int row = 0; row < 2; ++row) {
#include "support/sanitized.h"
    for (int i = 0; i < 4096; ++i) wide += (i > 0 ? "," : "") + std::to_string((row + 1) * i + row);
#include "support/sanitized.h"
    wide += "\n";
#include "support/sanitized.h"
  }
#include "support/sanitized.h"
  write("wide.csv", wide);
#include "support/sanitized.h"
  // 2^24 neurons x 2^12 features x 4 bytes are 2^38 bytes.
#include "support/sanitized.h"
  for (const char* arithmetic : {"plain", "inner_products", "automatic"}) {
#include "support/sanitized.h"
    expect_refused(1,
#include "support/sanitized.h"
                   {"som", "train", "wide.csv", "-o", "x", "--rows", "4096", "--columns", "4096",
#include "support/sanitized.h"
                    "--arithmetic", arithmetic},
#include "support/sanitized.h"
                   {"4096 x 4096 neurons of 4096 features", "256.0 GiB", "choose fewer rows"});
#include "support/sanitized.h"
  }
#include "support/sanitized.h"
}
#include "support/sanitized.h"

#include "support/sanitized.h"
TEST_F(Output, ShortMemoryIsAnErrorLikeOthers) {
#include "support/sanitized.h"
#ifdef SOMATO_TESTS_SANITIZED
#include "support/sanitized.h"
  GTEST_SKIP() << "sanitizers need all the address space";
#include "support/sanitized.h"
#endif
#include "support/sanitized.h"
  write_data();
#include "support/sanitized.h"
  ProgramWorld world;
#include "support/sanitized.h"
  // Weights alone take 192 MiB, and the activity of one row 64.
#include "support/sanitized.h"
  const Words words{"som", "train",  "data.csv", "-o",        "x",   "--iterations",
#include "support/sanitized.h"
                    "1",   "--rows", "4096",     "--columns", "4096"};
#include "support/sanitized.h"
  world.memory = std::size_t{100} << 20;
#include "support/sanitized.h"
  expect_refused(1, words, {"need 192 MiB of memory", "limits leave this process"}, world);
#include "support/sanitized.h"
  world.memory = std::size_t{400} << 20;
#include "support/sanitized.h"
  expect_refused(1, words, {"not enough memory", "smaller map"}, world);
#include "support/sanitized.h"
}
#include "support/sanitized.h"

#include "support/sanitized.h"
}  // namespace
#include "support/sanitized.h"
}  // namespace somato
#include "support/sanitized.h"
