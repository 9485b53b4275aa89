#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <memory>

#include "program/support/program_test.h"
#include "somato/graph/som_model.h"

namespace somato {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMebibyte = std::size_t{1} << 20;

class HostileInputs : public ProgramTest {};

// Beyond what training accepts, every winner was the first neuron, and every distance infinite.
TEST_F(HostileInputs, RowsThatTrainingWouldRefuseAreNotMapped) {
  train();
  write("large.csv", "1,2,3\n3e37,4,1\n");
  for (const char* command : {"map", "quality"}) {
    expect_refused(1, {"som", command, "good.map", "large.csv"},
                   {"large.csv: row 2 has values too large for the map"});
  }
  write("tiny.csv", "1e-30,2\n2e-30,4\n3e-30,7\n");
  output_of({"som", "train", "tiny.csv", "-o", "tiny.map", "--standardize", "--rows", "3",
             "--columns", "3"});
  write("wide.csv", "1e-30,2\n1e20,2\n");
  for (const char* command : {"map", "quality"}) {
    expect_refused(1, {"som", command, "tiny.map", "wide.csv"},
                   {"wide.csv: row 2 has values too large"});
  }
}

TEST_F(HostileInputs, AStandardizationThatMakesNumbersInfiniteIsNotMapped) {
  write_data();
  output_of({"som", "train", "data.csv", "-o", "a.map", "--standardize", "--rows", "3", "--columns",
             "3"});
  SomModel model = load_som_model(path("a.map")).value();
  for (const auto& [mean, deviation] : {std::pair(0.0, 1e-308), std::pair(1e308, 1.0)}) {
    model.standardization->means[0] = mean;
    model.standardization->deviations[0] = deviation;
    ASSERT_TRUE(save_som_model(path("b.map"), model));
    expect_refused(1, {"som", "map", "b.map", "data.csv"},
                   {"data.csv: row 1 has values too large"});
  }
}

TEST_F(HostileInputs, AResultsFileNestedDeeplyIsRefused) {
  const std::string lists = std::string(100000, '[') + std::string(100000, ']');
  write("deep.json", "{\"x\":" + lists + ",\"a\":1,\"b\":2}");
  expect_refused(1, {"report", "deep.json", "-o", "x.html"}, {"deep.json:1:", "levels of nesting"});
}

TEST_F(HostileInputs, WhatNeverEndsIsNotReadWhole) {
  write_data();
  const auto refused = [&](const Words& words, const std::string& says) {
    const ProgramRun done = run(words);
    EXPECT_EQ(done.exit_code / 2, 0) << done.err;
    EXPECT_NE(done.err.find(says), std::string::npos) << done.err;
    EXPECT_LT(done.most_memory, 400 * kMebibyte);
  };
  refused({"run", "/dev/zero", "--data", kTrials, "--out", "o"}, "/dev/zero: the file is larger");
  refused({"report", "/dev/zero", "-o", "x.html"}, "/dev/zero: the file is larger");
  refused({"som", "train", "/dev/zero", "-o", "x", "--memory", "100MiB"},
          "/dev/zero: the file is larger than 104857600 bytes");
}

// A pipe without a writer: opening it would wait for ever.
TEST_F(HostileInputs, APipeAmongTheFilesOfAnImportIsRefused) {
  fs::create_directory(path("in"));
  write("in/a_1.csv", "t,x\n0,1\n1,2\n");
  ASSERT_EQ(mkfifo(path("in/b_1.csv").c_str(), 0600), 0);
  ProgramWorld world;
  world.seconds = 10;
  expect_refused(1,
                 {"import", "csv", "in", "-o", "x.mcap", "--files", "{object}_{trial:number}.csv",
                  "--time", "t", "--channels", "x=x"},
                 {"in/b_1.csv: ", "not a regular file"}, world);
}

// Two runs that write one journal spoiled it.
TEST_F(HostileInputs, AFolderInWhichAnotherRunWorksIsRefused) {
  write_study();
  fs::create_directory(path("out"));
  const int folder = open(path("out").c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(flock(folder, LOCK_EX), 0);
  const Words words{"run", "study.toml", "--data", kTrials, "--out", "out"};
  expect_refused(1, words, {"out: another somato process is using this folder"});
  close(folder);
  const std::string mine = fmt::format("out/.somato-{}-0.partial", getpid());
  write("out/.somato-2000000000-3.partial", "of a process that has ended");
  write(mine, "of a process that lives");
  EXPECT_EQ(run(words).exit_code, 0);
  EXPECT_FALSE(fs::exists(path("out/.somato-2000000000-3.partial")));
  EXPECT_TRUE(fs::exists(path(mine)));
}

TEST_F(HostileInputs, AClaimWithAMisspeltNameIsRefused) {
  write_study();
  const std::string study = read("study.toml");
  write("study.toml", study + "[[claim]]\ntext = 'x'\nmetric = 'acuracy'\nat_least = 0.5\n");
  const Words words{"run", "study.toml", "--data", kTrials, "--out", "out"};
  expect_refused(2, words, {"study.toml:", "unknown metric 'acuracy'", "did you mean 'accuracy'?"});
  write("study.toml", study +
                          "[[claim]]\ntext = 'x'\nmetric = 'accuracy'\nat_least = 0.5\n"
                          "protocol = 'leave_one_uot'\n");
  expect_refused(2, words, {"study.toml:", "unknown protocol", "did you mean 'leave_one_out'?"});
}

TEST_F(HostileInputs, AVariationWithAMisspeltKeyIsRefused) {
  write_study();
  write("study.toml", read("study.toml") + "[variation.v]\nmodule.map.rowz = 5\n");
  expect_refused(2, {"run", "study.toml", "--data", kTrials, "--out", "out"}, {"rowz", "'rows'"});
}

TEST_F(HostileInputs, FlagsWithoutEffectAreRefused) {
  expect_refused(
      2, {{{"explore", "--body", "texture", "--free", "-o", "x"}, {"--free: ", "no effect"}},
          {{"explore", "--body", "lucs2", "--taxels", "-o", "x"}, {"--taxels: "}},
          {{"explore", "--body", "hardness", "--images", "im", "-o", "x"},
           {"--images: ", "no effect"}}});
}

TEST_F(HostileInputs, APictureIsNotNamedAfterAnotherFormat) {
  train();
  expect_refused(2, {"som", "plot", "good.map", "-o", "p.JPG"},
                 {"p.JPG: ", "SVG, PNG or PDF, not jpg"});
}

TEST_F(HostileInputs, ControlCharactersOfNamesDoNotReachTheTerminal) {
  expect_refused(1, {"inspect", "a\x1B]0;b\n.mcap"}, {R"(a\x1B]0;b\x0A.mcap)"});
}

class HostileExploring : public ProgramTest {
 protected:
  Words explore(const std::string& body, const Words& more = {}) const {
    Words words{"explore",        "--body", body, "--settings", "s.toml",
                "--explorations", "1",      "-o", "x.mcap"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
};

// Each of these ran for ever.
TEST_F(HostileExploring, TimesWithoutEndAreRefused) {
  const std::vector<std::pair<std::string, std::string>> settings{
      {"lucs3", "[closing]\nsettle = 1e300\n"},
      {"lucs3", "[closing]\nsettle = 100000\n"},
      {"lucs3", "[closing]\niteration = 1e300\n"},
      {"lucs3", "[closing]\niteration = 1e-300\n"},
      {"lucs3", "[closing]\nlongest = 1e300\nstill = 0.0\n"},
      {"lucs2", "[grasp]\nsettle = 1e300\n"},
      {"hardness", "[press]\npatience = 1e300\n"}};
  for (const auto& [body, text] : settings) {
    write("s.toml", text);
    expect_refused(2, explore(body), {"s.toml:2: ", "must be a number"});
  }
}

TEST_F(HostileExploring, AnExplorationTakesNoMoreThanItsTime) {
  write("s.toml", "[texture_probe]\nstroke = 180.0\nlever_speed = 0.01\n[stroke]\nto = 180.0\n");
  const ProgramRun done = run(explore("texture", {"--longest", "4"}));
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_NE(done.err.find("more than 4 s of the body's time"), std::string::npos) << done.err;
  EXPECT_FALSE(fs::exists(path("x.mcap")));
}

TEST_F(HostileExploring, CtrlCEndsAnExplorationAtOnce) {
  write("s.toml", "[closing]\nsettle = 60\niteration = 10\n[simulation]\ntime_step = 0.0001\n");
  ProgramWorld world;
  world.terminal = true;
  world.interrupt_at = "exploring";
  world.seconds = 30;
  const ProgramRun done = run(explore("lucs3"), world);
  EXPECT_EQ(done.exit_code, 130);
  EXPECT_NE(done.err.find("stopping; press Ctrl-C again to end immediately"), std::string::npos)
      << done.err;
  EXPECT_FALSE(fs::exists(path("x.mcap")));
}

// Sensor readings are worth more than a picture.
TEST_F(HostileExploring, APictureThatCannotBeSavedDropsNoExploration) {
  write("s.toml", "");
  write(
      "things.toml",
      "[object]\ntube = { shape = 'cylinder', diameter = 60, height = 130, material = 'wood' }\n");
  fs::create_directories(path("im/tube-1-1.png"));
  const ProgramRun done = run(explore("lucs3", {"--objects", "things.toml", "--images", "im"}));
  EXPECT_EQ(done.exit_code, 3);
  EXPECT_NE(done.err.find("all explorations are recorded, but 1 picture could not be saved"),
            std::string::npos)
      << done.err;
  EXPECT_NE(output_of({"inspect", "x.mcap"}).find("whole"), std::string::npos);
}

}  // namespace
}  // namespace somato
