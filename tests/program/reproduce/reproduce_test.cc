#include <algorithm>

#include "base/support/sanitized.h"
#include "program/support/reproducing.h"
#include "somato/recording/recording_file.h"

namespace somato {
namespace {

using Json = nlohmann::json;

TEST_F(Reproduce, SpreadsPairsOverRecordings) {
  write("press.toml", press());
  const std::string shown = output_of(reproduce("press.toml", "out"));
  EXPECT_NE(shown.find("Written: out/results.json, maps in out/maps"), std::string::npos) << shown;
  const Json json = results("out");
  EXPECT_EQ(json["version"], 4);
  ASSERT_EQ(json["recordings"].size(), 2U);
  EXPECT_EQ(json["recordings"][0]["seed"], 2011);
  EXPECT_EQ(json["recordings"][1]["seed"], 2012);
  EXPECT_EQ(json["recordings"][0]["explorations"], 16);
  EXPECT_NE(json["recordings"][0]["hash"], json["recordings"][1]["hash"]);
  ASSERT_EQ(json["parts"].size(), 1U);
  const Json& system = json["parts"][0];
  EXPECT_EQ(system["study"], press());
  EXPECT_EQ(system["model"]["path"], "systems/press.somato");
  EXPECT_EQ(system["model"]["seed"], 2011);
  EXPECT_EQ(system["recordings"], Json::parse("[0, 1]"));
  EXPECT_EQ(system["pairs"], Json::parse("[[0, 2011], [0, 2012], [1, 2013]]"));
  ASSERT_EQ(system["protocols"].size(), 2U);
  for (const Json& protocol : system["protocols"]) {
    EXPECT_EQ(protocol["metrics"]["accuracy"]["values"].size(), 3U);
    for (const Json& run : protocol["runs"]) EXPECT_EQ(run["winners"].size(), 16U);
  }
  const Words made = files("out");
  ASSERT_EQ(made.size(), 5U) << ::testing::PrintToString(made);
  EXPECT_EQ(made[0], "maps/press.svg");
  EXPECT_TRUE(made[1].starts_with("recordings/hardness-") && made[1].ends_with("-2011.mcap"));
  EXPECT_TRUE(made[2].starts_with("recordings/hardness-") && made[2].ends_with("-2012.mcap"));
  EXPECT_EQ(made[3], "results.json");
  EXPECT_EQ(made[4], "systems/press.somato");
}

// Each pair gives the results of 'run' on its recording with its seeds.
TEST_F(Reproduce, FindsWhatRunFinds) {
  write("press.toml", press());
  output_of(reproduce("press.toml", "out"));
  const Json found = results("out");
  const Json system = found["parts"][0];
  std::string single = press();
  single.insert(single.find("label"), "first_seed = 2011\nseeds = 2\n");
  write("single.toml", single);
  const std::string recording = found["recordings"][0]["name"];
  output_of({"run", "single.toml", "--data", "out/recordings/" + recording, "--out", "run"});
  const Json expected = results("run")["parts"][0]["protocols"];
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

TEST_F(Reproduce, OtherThingsUnderTheSamePathAreExploredAgain) {
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
  EXPECT_NE(after[0]["hash"], before[0]["hash"]);
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

// The study of a variation is written for the results, with what explored: run for itself, it finds
// the same.
TEST_F(Reproduce, TheStudyOfAVariationRunsAgain) {
  write("press.toml", press() + "[variation.single]\nmodule.map.rows = 1\n");
  output_of(reproduce("press.toml", "out"));
  const Json part = results("out")["parts"][1];
  EXPECT_EQ(part["variation"], "single");
  write("single.toml", part["study"].get<std::string>());
  output_of(reproduce("single.toml", "again"));
  const Json again = results("again");
  EXPECT_EQ(again["recordings"], results("out")["recordings"]);
  EXPECT_EQ(again["parts"][0]["protocols"], part["protocols"]);
  EXPECT_EQ(again["parts"][0]["parameters"], part["parameters"]);
}

// A variation and a claim of the file: the outcome is printed and written.
TEST_F(Reproduce, JudgesClaims) {
  write("press.toml",
        press() +
            "[variation.single]\nmodule.map.rows = 1\nmodule.map.columns = 1\n"
            "[[claim]]\ntext = 'One neuron separates no class.'\n"
            "paper = 'P11'\nvariation = 'single'\nmetric = 'classes_separated'\nat_most = 0\n"
            "published = 0\njudged_by = 'central_range'\ncontradicted_by = 'Fig. 8'\n"
            "[[claim]]\ntext = 'Nine neurons separate more.'\nthan_variation = 'single'\n"
            "metric = 'classes_separated'\nat_least = 1\nat_most = 8\n");
  const std::string shown = output_of(reproduce("press.toml", "out"));
  EXPECT_NE(shown.find("press, single: One neuron separates no class."), std::string::npos);
  const Json json = results("out");
  ASSERT_EQ(json["parts"].size(), 2U);
  EXPECT_EQ(json["parts"][1]["variation"], "single");
  ASSERT_EQ(json["claims"].size(), 2U);
  EXPECT_EQ(json["claims"][0]["share"], 1.0);
  EXPECT_EQ(json["claims"][0]["mean"], 0.0);
  EXPECT_EQ(json["claims"][0]["values"].size(), 3U);
  EXPECT_EQ(json["claims"][0]["verdict"], "cannot be decided here");
  EXPECT_EQ(json["claims"][0]["reason"], "3 pairs; 20 are needed");
  // With other groupings, one neuron does not separate classes either.
  EXPECT_EQ(json["claims"][0]["chance_share"], 1.0);
  EXPECT_TRUE(json["claims"][1]["chance_share"].is_null());
  EXPECT_NE(shown.find("Claims of papers"), std::string::npos);
  EXPECT_LT(shown.find("One neuron separates"), shown.find("Comparisons of our own"));
  EXPECT_GT(shown.find("Nine neurons separate more. (classes_separated less that of single between "
                       "1 and 8)"),
            shown.find("Comparisons of our own"));
  EXPECT_NE(
      shown.find("    as written: cannot be decided here (classes_separated range with 0: mean "
                 "0.000, central 90 % 0.00 to 0.00, by chance 0.00 to 0.00, 100 % of the pairs)\n"
                 "      3 pairs; 20 are needed\n"),
      std::string::npos);
  EXPECT_NE(shown.find("    contradicted by Fig. 8\n"), std::string::npos);
  EXPECT_NE(shown.find("The same as written in the texts\n  cannot be decided here"),
            std::string::npos);
  EXPECT_EQ(json["claims"][0]["as_written"]["judged_by"], "central_range");
  EXPECT_FALSE(json["claims"][1].contains("as_written"));
  EXPECT_NE(shown.find("cannot be decided here       1\n"), std::string::npos);
  // With all samples at one neuron nothing is separated, so the difference is the metric itself.
  const Json& nine = json["parts"][0]["protocols"][0]["metrics"]["classes_separated"];
  EXPECT_EQ(json["claims"][1]["mean"], nine["mean"]);
  EXPECT_TRUE(fs::exists(path("out/maps/press-single.svg")));
}

TEST_F(Reproduce, RefusesBeforeAnythingMoves) {
  write("press.toml", press());
  write("broken.toml", "[study]\nname = 'x'\nname = \n");
  write("key.toml", "[study]\nnmae = 'x'\n" + press().substr(press().find("[module")));
  write("explore.toml", press() + "explorationss = 3\n");
  write("range.toml", press() + "[explore.press]\nstep = -1\n");
  write("bodiless.toml", press().substr(0, press().find("body")));
  write("variation.toml", press() + "[variation.v]\nmodule.mpa.rows = 3\n");
  write("module.toml", press() + "[variation.v]\nmodule.map.rows = 0\n");
  write("claim.toml", press() + "[[claim]]\ntext = 't'\nmetric = 'accuracy'\n");
  write("question.toml", "[question]\nname = 'q'\nsystems = ['hardnes']\n");
  fs::create_directory(path("empty"));
  const auto line = [](const std::string& file, int number) {
    return file + ".toml:" + std::to_string(number);
  };
  expect_refused(1, reproduce("none.toml", "out"), {"none.toml", "cannot open"});
  expect_refused(1, reproduce("press.toml", "out", {"--data", "nowhere"}),
                 {"nowhere: there is no such file or folder"});
  expect_refused(1, reproduce("press.toml", "out", {"--data", "empty"}), {"empty: no recordings"});
  expect_refused(
      2,
      {{reproduce("hardnes", "out"), {"unknown system 'hardnes'", "did you mean 'hardness'?"}},
       {reproduce("broken.toml", "out"), {"broken.toml:3"}},
       {reproduce("key.toml", "out"), {line("key", 2), "did you mean 'name'?"}},
       {reproduce("explore.toml", "out"),
        {line("explore", kLines + 1), "did you mean 'explorations'?"}},
       {reproduce("range.toml", "out"), {line("range", kLines + 2), "step"}},
       {reproduce("bodiless.toml", "out"), {"does not define an exploration"}},
       {reproduce("variation.toml", "out"), {line("variation", kLines + 2), "did you mean 'map'?"}},
       {reproduce("module.toml", "out"), {line("module", kLines + 2), "rows"}},
       {reproduce("claim.toml", "out"), {line("claim", kLines + 1), "the claim has no bound"}},
       {reproduce("question.toml", "out"), {"question.toml:1", "did you mean 'hardness'?"}},
       {reproduce("press.toml", "out", {"--pairs", "0"}), {"--pairs"}},
       {{"reproduce", "press.toml", "press.toml", "--out", "out"},
        {"press.toml:1", "'press' is requested twice"}}});
}

// Where a file or folder is in the way.
TEST_F(Reproduce, ThatCannotBeWrittenSaysSo) {
  write("press.toml", press());
  write("file", "");
  expect_refused(
      1, reproduce("press.toml", "file/out"),
      {"file/out/recordings: the folder cannot be created", "a writable folder for --out"});
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
    EXPECT_NE(done.err.find("the same command"), std::string::npos) << done.err;
    return done;
  }
};

TEST_F(ReproduceInterrupted, ResumesWithTheSameBytesOnThreads) {
  write("press.toml", press("press", std::to_string(testing::fewer_if_sanitized(20000)), "9"));
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

TEST_F(Reproduce, ExploresThingsThatTheSystemDeclares) {
  const std::string things =
      "[explore.material.cork]\nstiffness = 8.0\n[explore.material.slate]\nstiffness = 90.0\n";
  write("press.toml", press() + things);
  output_of(reproduce("press.toml", "out"));
  const auto part = results("out")["parts"][0];
  EXPECT_EQ(part["protocols"][0]["runs"][0]["labels"],
            nlohmann::json::array({"cork", "cork", "slate", "slate"}))
      << part["protocols"][0];
  // Another stiffness is another recording, with another name.
  write("press.toml", press() + things + "[explore.material.felt_2]\nstiffness = 1.0\n");
  output_of(reproduce("press.toml", "out"));
  EXPECT_EQ(results("out")["parts"][0]["protocols"][0]["runs"][0]["labels"].size(), 6U);
  write("wrong.toml",
        press() + things + "[explore.object.a]\nshape = 'spere'\nmaterial = 'cork'\n");
  const auto refused = run(reproduce("wrong.toml", "wrong"));
  EXPECT_NE(refused.err.find("did you mean 'sphere'?"), std::string::npos) << refused.err;
}

}  // namespace
}  // namespace somato
