#include <algorithm>
#include <nlohmann/json.hpp>

#include "program/program_test.h"
#include "somato/recording/recording_file.h"

namespace somato {
namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

class Reproduce : public ProgramTest {
 protected:
  // Small maps of two presses of each of the probe's things: done in a moment.
  static std::string press(const std::string& name = "press", const std::string& iterations = "50",
                           const std::string& side = "3") {
    return "[study]\nname = '" + name +
           "'\nlabel = 'material'\nprotocols = ['train_is_test', 'leave_one_out']\n"
           "[module.potentiometer]\ntype = 'channel'\nchannel = 'potentiometer'\nshape = [1]\n"
           "[module.reading]\ntype = 'last'\ninput = 'potentiometer'\n"
           "[module.map]\ntype = 'som'\ninput = 'reading'\nrows = " +
           side + "\ncolumns = " + side + "\niterations = " + iterations +
           "\n[explore]\nbody = 'hardness'\nexplorations = 2\n";
  }
  // Lines of press(), which ends with its table [explore].
  static constexpr int kLines = 20;

  static Words reproduce(const std::string& system, const std::string& out,
                         const Words& more = {}) {
    Words words{"reproduce", system, "--out", out, "--pairs", "3", "--recordings", "2"};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  Json results(const std::string& out) const { return Json::parse(read(out + "/results.json")); }

  // Files below a folder, by their paths in it.
  Words files(const std::string& folder) const {
    Words found;
    for (const auto& entry : fs::recursive_directory_iterator(path(folder))) {
      if (entry.is_regular_file()) found.push_back(fs::relative(entry, path(folder)).string());
    }
    std::sort(found.begin(), found.end());
    return found;
  }

  std::vector<fs::file_time_type> times(const std::string& folder) const {
    std::vector<fs::file_time_type> found;
    for (const std::string& file : files(folder)) {
      found.push_back(fs::last_write_time(path(folder + "/" + file)));
    }
    return found;
  }
};

TEST_F(Reproduce, SpreadsPairsOverRecordings) {
  write("press.toml", press());
  const std::string shown = output_of(reproduce("press.toml", "out"));
  EXPECT_NE(shown.find("Written: out/results.json, maps in out/maps"), std::string::npos) << shown;
  const Json json = results("out");
  EXPECT_EQ(json["version"], 1);
  EXPECT_EQ(json["pairs"], 3);
  EXPECT_EQ(json["seed"], 2011);
  ASSERT_EQ(json["recordings"].size(), 2U);
  EXPECT_EQ(json["recordings"][0]["seed"], 2011);
  EXPECT_EQ(json["recordings"][1]["seed"], 2012);
  EXPECT_EQ(json["recordings"][0]["explorations"], 16);
  EXPECT_NE(json["recordings"][0]["data_hash"], json["recordings"][1]["data_hash"]);
  ASSERT_EQ(json["systems"].size(), 1U);
  const Json& system = json["systems"][0];
  EXPECT_EQ(system["pairs"], Json::parse("[[0, 2011], [0, 2012], [1, 2013]]"));
  ASSERT_EQ(system["protocols"].size(), 2U);
  for (const Json& protocol : system["protocols"]) {
    EXPECT_EQ(protocol["metrics"]["accuracy"]["values"].size(), 3U);
    for (const Json& run : protocol["runs"]) EXPECT_EQ(run["winners"].size(), 16U);
  }
  const Words made = files("out");
  ASSERT_EQ(made.size(), 4U) << ::testing::PrintToString(made);
  EXPECT_EQ(made[0], "maps/press.svg");
  EXPECT_TRUE(made[1].starts_with("recordings/hardness-") && made[1].ends_with("-2011.mcap"));
  EXPECT_TRUE(made[2].starts_with("recordings/hardness-") && made[2].ends_with("-2012.mcap"));
  EXPECT_EQ(made[3], "results.json");
}

// What each pair gives is what 'run' gives on its recording with its seeds.
TEST_F(Reproduce, FindsWhatRunFinds) {
  write("press.toml", press());
  output_of(reproduce("press.toml", "out"));
  const Json system = results("out")["systems"][0];
  std::string alone = press();
  alone.insert(alone.find("label"), "first_seed = 2011\nseeds = 2\n");
  write("alone.toml", alone);
  const std::string recording = system["recordings"][0];
  output_of({"run", "alone.toml", "--data", "out/recordings/" + recording, "--out", "run"});
  const Json expected = results("run")["systems"];
  for (std::size_t p = 0; p < 2; ++p) {
    const Json& protocol = system["protocols"][p];
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(protocol["runs"][i], expected[p]["runs"][i]);
      EXPECT_EQ(protocol["metrics"]["quantization_error"]["values"][i],
                expected[p]["metrics"]["quantization_error"]["values"][i]);
    }
  }
}

TEST_F(Reproduce, KeepsWhatItExploredAndFindsItAgain) {
  write("press.toml", press());
  output_of(reproduce("press.toml", "out"));
  const auto before = times("out/recordings");
  const std::string first = read("out/results.json");
  ASSERT_EQ(before.size(), 2U);
  output_of(reproduce("press.toml", "out"));
  EXPECT_EQ(times("out/recordings"), before);
  EXPECT_TRUE(read("out/results.json") == first);
  // Explored with other settings or another seed, they are others.
  output_of(reproduce("press.toml", "out", {"--seed", "2012"}));
  EXPECT_EQ(files("out/recordings").size(), 3U);
  std::string more = press();
  more.replace(more.find("explorations = 2"), 16, "explorations = 3");
  write("press.toml", more);
  output_of(reproduce("press.toml", "out"));
  EXPECT_EQ(files("out/recordings").size(), 5U);
  EXPECT_EQ(results("out")["recordings"][0]["explorations"], 24);
}

TEST_F(Reproduce, OtherThingsUnderTheSamePathAreExploredAnew) {
  const std::string bark = "[material.bark]\nroughness = 80.0\nhardness = \"soft\"\nstiffness = ";
  const std::string moss =
      "[material.moss]\nroughness = 9.0\nhardness = \"hard\"\nstiffness = 90.0\n";
  write("things.toml", bark + "2.0\n" + moss);
  write("press.toml", press() + "objects = 'things.toml'\n");
  output_of(reproduce("press.toml", "out"));
  const Json before = results("out")["recordings"];
  EXPECT_EQ(before[0]["explorations"], 4);
  write("things.toml", bark + "40.0\n" + moss);
  output_of(reproduce("press.toml", "out"));
  const Json after = results("out")["recordings"];
  EXPECT_NE(after[0]["name"], before[0]["name"]);
  EXPECT_NE(after[0]["data_hash"], before[0]["data_hash"]);
}

TEST_F(Reproduce, TheSameBytesForEveryNumberOfThreads) {
  write("press.toml", press());
  output_of(reproduce("press.toml", "one", {"--threads", "1"}));
  output_of(reproduce("press.toml", "three", {"--threads", "3"}));
  EXPECT_EQ(files("three"), files("one"));
  for (const std::string& file : files("one")) {
    EXPECT_TRUE(read("three/" + file) == read("one/" + file)) << file;
  }
}

// A variation and a claim of the file: how it came out is told and written.
TEST_F(Reproduce, JudgesClaims) {
  write("press.toml", press() +
                          "[variation.single]\nmodule.map.rows = 1\nmodule.map.columns = 1\n"
                          "[[claim]]\ntext = 'One neuron tells nothing exactly.'\n"
                          "variation = 'single'\nmetric = 'told_exactly'\nat_most = 0\n"
                          "[[claim]]\ntext = 'Nine neurons tell more.'\nthan_variation = 'single'\n"
                          "metric = 'told_exactly'\nat_least = 1\n");
  const std::string shown = output_of(reproduce("press.toml", "out"));
  EXPECT_NE(shown.find("press, single: One neuron tells nothing exactly."), std::string::npos);
  const Json json = results("out");
  ASSERT_EQ(json["systems"].size(), 2U);
  EXPECT_EQ(json["systems"][1]["variation"], "single");
  ASSERT_EQ(json["claims"].size(), 2U);
  EXPECT_EQ(json["claims"][0]["share"], 1.0);
  EXPECT_EQ(json["claims"][0]["mean"], 0.0);
  EXPECT_EQ(json["claims"][0]["pairs"], 3);
  // With all samples at one neuron nothing is told, so the difference is the metric itself.
  const Json& nine = json["systems"][0]["protocols"][0]["metrics"]["told_exactly"];
  EXPECT_EQ(json["claims"][1]["mean"], nine["mean"]);
  EXPECT_TRUE(fs::exists(path("out/maps/press-single.svg")));
}

class ReproduceGiven : public Reproduce {
 protected:
  // Four recordings of the probe in explored/recordings.
  ReproduceGiven() {
    write("press.toml", press());
    output_of(
        {"reproduce", "press.toml", "--out", "explored", "--pairs", "4", "--recordings", "4"});
    for (const std::string& file : files("explored/recordings")) recordings_.push_back(file);
  }

  Json given(const std::string& system, const std::string& data, const Words& more = {}) const {
    Words words = reproduce(system, "given", {"--data", data});
    words.insert(words.end(), more.begin(), more.end());
    output_of(words);
    return results("given");
  }

  Words recordings_;
};

TEST_F(ReproduceGiven, MayBeAFile) {
  const Json json = given("press.toml", "explored/recordings/" + recordings_[2]);
  ASSERT_EQ(json["recordings"].size(), 1U);
  EXPECT_EQ(json["recordings"][0]["name"], recordings_[2]);
  EXPECT_EQ(json["recordings"][0]["source"], "given");
  EXPECT_EQ(json["systems"][0]["pairs"], Json::parse("[[0, 2011], [0, 2012], [0, 2013]]"));
  EXPECT_TRUE(files("given/recordings").empty());
}

// All of them, whatever --recordings says of exploring, as far as there are pairs.
TEST_F(ReproduceGiven, MayBeAFolderOfFiles) {
  for (const char* folder : {"explored/recordings", "explored/recordings/"}) {
    const Json json =
        given("press.toml", folder, {"--test-data", "explored/recordings/" + recordings_[3]});
    ASSERT_EQ(json["recordings"].size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(json["recordings"][i]["name"], recordings_[i]);
    EXPECT_EQ(json["systems"][0]["pairs"], Json::parse("[[0, 2011], [1, 2012], [2, 2013]]"));
    EXPECT_EQ(json["systems"][0]["protocols"][2]["protocol"], "test_data");
  }
}

TEST_F(ReproduceGiven, ThatDoesNotFitIsPassedOverForAllAndAnErrorWhenNamed) {
  const std::string data = "explored/recordings/" + recordings_[0];
  const Json json = given("all", data);
  ASSERT_EQ(json["systems"].size(), 1U);
  EXPECT_EQ(json["systems"][0]["system"], "hardness");
  EXPECT_EQ(json["not_applicable"].size(), 8U);
  bool texture = false;
  for (const Json& one : json["not_applicable"]) {
    const std::string reason = one["reason"];
    texture = texture || (one["system"] == "texture" &&
                          reason.find("unknown channel 'sound'") != std::string::npos);
  }
  EXPECT_TRUE(texture);
  const ProgramRun named = run(reproduce("texture", "named", {"--data", data}));
  EXPECT_EQ(named.exit_code, 2);
  EXPECT_NE(named.err.find("unknown channel 'sound'"), std::string::npos) << named.err;
  EXPECT_TRUE(files("named").empty());
}

// One has labels that leave nothing to name under leave_one_out: one press of each material.
TEST_F(ReproduceGiven, ThatCannotBeMeasuredAlikeIsAnError) {
  std::string once = press();
  once.replace(once.find("explorations = 2"), 16, "explorations = 1");
  write("once.toml", once);
  output_of({"reproduce", "once.toml", "--out", "once", "--pairs", "1"});
  fs::copy(path("once/recordings"), path("explored/recordings"));
  const ProgramRun done = run({"reproduce", "press.toml", "--data", "explored/recordings", "--out",
                               "given", "--pairs", "5"});
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_NE(done.err.find("do not let the same things be measured"), std::string::npos) << done.err;
  EXPECT_FALSE(fs::exists(path("given/results.json")));
}

// The example's grasps, in the data set's own format.
class ReproduceDataSets : public Reproduce {
 protected:
  ReproduceDataSets() {
    for (const char* name : {"sets/a", "sets/b"}) {
      fs::create_directories(path(name));
      fs::copy(kTrials, path(name));
    }
    fs::remove(*fs::directory_iterator(path("sets/b")));
    write("joints.toml",
          "[study]\nname = 'joints'\nprotocols = ['train_is_test']\n[recording]\n"
          "format = 'icub_grasp'\n[module.joints]\ntype = 'channel'\nchannel = 'joints'\n"
          "[module.closed]\ntype = 'last'\ninput = 'joints'\n[module.map]\ntype = 'som'\n"
          "input = 'closed'\nrows = 3\ncolumns = 3\niterations = 50\n");
  }
};

TEST_F(ReproduceDataSets, MayBeOneOrAFolderOfThem) {
  for (const char* data : {"sets/a", "sets/a/"}) {
    output_of(reproduce("joints.toml", "out", {"--data", data}));
    const Json json = results("out");
    ASSERT_EQ(json["recordings"].size(), 1U);
    EXPECT_EQ(json["recordings"][0]["name"], "a") << data;
    EXPECT_EQ(json["recordings"][0]["explorations"], 30);
  }
  output_of(reproduce("joints.toml", "out", {"--data", "sets"}));
  const Json json = results("out");
  ASSERT_EQ(json["recordings"].size(), 2U);
  EXPECT_EQ(json["recordings"][0]["name"], "a");
  EXPECT_EQ(json["recordings"][1]["name"], "b");
  EXPECT_LT(json["recordings"][1]["explorations"], 30);
}

TEST_F(ReproduceDataSets, AreNotForSystemsOfBodies) {
  const ProgramRun done = run(reproduce("hardness", "out", {"--data", "sets"}));
  EXPECT_EQ(done.exit_code, 2);
  EXPECT_NE(done.err.find("this is run on recordings, and --data holds none; give --data a file"),
            std::string::npos)
      << done.err;
  write("press.toml", press());
  // Nor can a system for data sets do without them.
  expect_refused(2, reproduce("joints.toml", "none"),
                 {"joints.toml:1", "'joints' does not say what explores", "give --data"});
}

TEST_F(Reproduce, RefusesBeforeAnythingMoves) {
  write("press.toml", press());
  write("broken.toml", "[study]\nname = 'x'\nname = \n");
  write("key.toml", "[study]\nnmae = 'x'\n" + press().substr(press().find("[module")));
  write("explore.toml", press() + "explorationss = 3\n");
  write("range.toml", press() + "[explore.press]\nstep = -1\n");
  write("bodiless.toml", press().substr(0, press().find("body")));
  write("variation.toml", press() + "[variation.v]\nmodule.mpa.rows = 3\n");
  write("claim.toml", press() + "[[claim]]\ntext = 't'\nmetric = 'accuracy'\n");
  write("question.toml", "[question]\nname = 'q'\nsystems = ['hardnes']\n");
  fs::create_directory(path("empty"));
  const auto line = [](const std::string& file, int number) {
    return file + ".toml:" + std::to_string(number);
  };
  expect_refused(1, reproduce("none.toml", "out"), {"none.toml", "cannot open"});
  expect_refused(1, reproduce("press.toml", "out", {"--data", "nowhere"}),
                 {"nowhere: there is no such file or folder"});
  expect_refused(1, reproduce("press.toml", "out", {"--data", "empty"}),
                 {"empty: there are no recordings"});
  expect_refused(
      2,
      {{reproduce("hardnes", "out"), {"unknown system 'hardnes'", "did you mean 'hardness'?"}},
       {reproduce("broken.toml", "out"), {"broken.toml:3"}},
       {reproduce("key.toml", "out"), {line("key", 2), "did you mean 'name'?"}},
       {reproduce("explore.toml", "out"),
        {line("explore", kLines + 1), "did you mean 'explorations'?"}},
       {reproduce("range.toml", "out"), {line("range", kLines + 2), "step"}},
       {reproduce("bodiless.toml", "out"), {"does not say what explores"}},
       {reproduce("variation.toml", "out"), {line("variation", kLines + 2), "did you mean 'map'?"}},
       {reproduce("claim.toml", "out"), {line("claim", kLines + 1), "a claim needs a bound"}},
       {reproduce("question.toml", "out"), {"question.toml:1", "did you mean 'hardness'?"}},
       {reproduce("press.toml", "out", {"--pairs", "0"}), {"--pairs"}},
       {{"reproduce", "press.toml", "press.toml", "--out", "out"},
        {"press.toml:1", "'press' is asked for twice"}}});
}

// Where a file or folder is in the way.
TEST_F(Reproduce, ThatCannotBeWrittenSaysSo) {
  write("press.toml", press());
  write("file", "");
  expect_refused(1, reproduce("press.toml", "file/out"),
                 {"file/out/recordings: the folder cannot be made", "give --out a folder"});
}

// Ctrl-C at what standard error says.
class ReproduceInterrupted : public Reproduce {
 protected:
  ProgramRun interrupted(const Words& words, const std::string& at) const {
    ProgramWorld world;
    world.terminal = true;
    world.interrupt_at = at;
    const ProgramRun done = run(words, world);
    EXPECT_EQ(done.exit_code, 130);
    EXPECT_EQ(done.out, "");
    EXPECT_NE(done.err.find("the same command goes on from there"), std::string::npos) << done.err;
    return done;
  }
};

TEST_F(ReproduceInterrupted, GoesOnWithTheSameBytesOnThreads) {
  write("press.toml", press("press", "20000", "9"));
  for (const std::string threads : {"1", "3"}) {
    const Words words = reproduce("press.toml", "out" + threads, {"--threads", threads});
    interrupted(words, " left");
    bool journal = false;
    for (const std::string& file : files("out" + threads)) {
      journal = journal || file == "unfinished/press-0.journal";
      EXPECT_TRUE(file.ends_with(".journal") || file.ends_with(".mcap") || file.ends_with(".svg"))
          << file;
    }
    EXPECT_TRUE(journal);
    const std::string kept = read("out" + threads + "/unfinished/press-0.journal");
    EXPECT_GT(std::count(kept.begin(), kept.end(), '\n'), 1);
    output_of(words);
    EXPECT_FALSE(fs::exists(path("out" + threads + "/unfinished")));
  }
  output_of(reproduce("press.toml", "whole"));
  for (const std::string& file : files("whole")) {
    EXPECT_TRUE(read("out1/" + file) == read("whole/" + file)) << file;
    EXPECT_TRUE(read("out3/" + file) == read("whole/" + file)) << file;
  }
}

// A recording is there whole or not at all.
TEST_F(ReproduceInterrupted, WhileExploringLeavesWholeRecordingsOnly) {
  write("things.toml", R"([object]
tube = { shape = "cylinder", diameter = 62, height = 121, material = "hard_board" }
cone = { shape = "cone", diameter = 80, height = 110, material = "wood" }
)");
  write("grasp.toml",
        "[study]\nname = 'grasp'\nprotocols = ['train_is_test']\n[module.joints]\n"
        "type = 'channel'\nchannel = 'joints'\n[module.closed]\ntype = 'last'\n"
        "input = 'joints'\n[module.map]\ntype = 'som'\ninput = 'closed'\nrows = 3\n"
        "columns = 3\niterations = 50\n[explore]\nbody = 'lucs3'\nobjects = 'things.toml'\n"
        "explorations = 40\n");
  interrupted(reproduce("grasp.toml", "out", {"--threads", "1"}), " left");
  for (const std::string& file : files("out")) {
    ASSERT_TRUE(file.starts_with("recordings/") && file.ends_with(".mcap")) << file;
    const auto recording = read_recording(path("out/" + file));
    ASSERT_TRUE(recording) << file;
    EXPECT_EQ(recording->explorations.size(), 80U);
  }
}

}  // namespace
}  // namespace somato
