#include <csignal>
#include <functional>
#include <thread>

#include "base/support/sanitized.h"
#include "program/support/reproducing.h"

namespace somato {
namespace {

using Json = nlohmann::json;

class Sweep : public Reproduce {
 protected:
  // Small maps of two presses of each of the probe's things, and what is claimed of them.
  void write_system(const std::string& iterations = "50") const {
    write("press.toml",
          press("press", iterations, "4") +
              "[variation.single]\nmodule.map.rows = 1\nmodule.map.columns = 1\n"
              "[[claim]]\ntext = 'Five are named.'\nmetric = 'classes_separated'\nat_least = 5\n"
              "[[claim]]\ntext = 'One neuron names fewer.'\nvariation = 'single'\n"
              "than_system = 'press'\nmetric = 'accuracy'\nat_most = 0\n");
  }

  void write_sweep(const std::string& head = "design = 'sobol'\npoints = 9\n") const {
    write("over.toml", "[sweep]\npairs = 2\nrecordings = 1\n" + head + kUnknowns);
  }

  static Words sweep(const std::string& out, const Words& more = {}) {
    Words words{"sweep", "press.toml", "--over", "over.toml", "--out", out};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  void expect_same(const std::string& a, const std::string& b) const {
    EXPECT_TRUE(read(a + "/sweep.json") == read(b + "/sweep.json"));
    EXPECT_TRUE(read(a + "/sweep.svg") == read(b + "/sweep.svg"));
  }

  // The folder of an inference has a page, that of a sweep a picture.
  void expect_page_of_inference(const Json& json) const {
    if (has_no_pages(run({"report", "none.json", "-o", "x"}))) return;
    EXPECT_EQ(output_of({"report", "out", "-o", "report.html"}),
              "report.html: 0 systems, 0 claims, 1 inference\n");
    const std::string page = read("report.html");
    EXPECT_NE(page.find("\"claims\":[],"), std::string::npos);
    for (const auto& claim : json["claims"]) {
      EXPECT_NE(page.find(claim["text"].get<std::string>()), std::string::npos);
    }
    expect_refused(2, {"report", "out", "out/inference.json", "-o", "x.html"}, {"given twice"});
    fs::remove(path("out/inference.json"));
    expect_refused(1, {"report", "out", "-o", "x.html"}, {"neither results.json nor"});
  }

  static inline const std::string kUnknowns =
      "[unknown.rate]\nkey = 'module.map.learning_rate_start'\ntext = 'Not given.'\n"
      "low = 0.01\nhigh = 1.0\nscale = 'logarithmic'\n"
      "[unknown.noise]\nkey = 'explore.hardness_probe.force_noise'\ntext = 'Not given.'\n"
      "values = [0.0, 0.04]\n";
};

TEST_F(Sweep, SaysWhereClaimsHold) {
  write_system();
  write_sweep();
  const std::string shown = output_of(sweep("out"));
  for (const char* said : {"9 points (sobol) of 2 unknowns, 2 pairs at each", "Five are named.",
                           "single: One neuron names fewer.", "out/sweep.json, out/sweep.svg"}) {
    EXPECT_NE(shown.find(said), std::string::npos) << said << "\n is not in\n" << shown;
  }
  const Json json = Json::parse(read("out/sweep.json"));
  EXPECT_EQ(json["points"].size(), 9U);
  EXPECT_EQ(json["points"][0]["values"]["rate"], 0.01);
  EXPECT_EQ(json["points"][1]["values"]["noise"], 0.04);
  EXPECT_NE(json["points"][0]["recordings"], json["points"][1]["recordings"]);
  EXPECT_EQ(json["claims"][1]["points"], 9);
  EXPECT_EQ(json["unknowns"][0]["system"], "0.3");  // the default of a map
  EXPECT_EQ(output_of(sweep("out", {"--json"})), read("out/sweep.json"));
  EXPECT_EQ(output_of(sweep("out", {"--quiet"})), "");
}

// A point is what reproduce finds in a system with these values.
TEST_F(Sweep, FindsWhatReproduceFinds) {
  write_system();
  write_sweep("design = 'one_at_a_time'\n");
  output_of(sweep("out"));
  const Json points = Json::parse(read("out/sweep.json"))["points"];
  ASSERT_EQ(points.size(), 8U);  // the system, five rates, two noises
  const auto values_of = [&](const std::string& system, const std::string& out) {
    write(out + ".toml", system);
    output_of({"reproduce", out + ".toml", "--out", out, "--pairs", "2", "--recordings", "1"});
    const Json results = Json::parse(read(out + "/results.json"))["parts"][0]["protocols"][0];
    return results["metrics"]["classes_separated"]["values"];
  };
  std::string system = read("press.toml");
  EXPECT_EQ(points[0]["claims"][0]["values"], values_of(system, "same"));
  std::string rate = system;
  rate.insert(rate.find("iterations"), "learning_rate_start = 1.0\n");
  EXPECT_EQ(points[5]["values"]["rate"], 1.0);
  EXPECT_EQ(points[5]["claims"][0]["values"], values_of(rate, "rate"));
  system.insert(system.find("[variation"), "[explore.hardness_probe]\nforce_noise = 0.04\n");
  EXPECT_EQ(points[7]["values"]["noise"], 0.04);
  EXPECT_EQ(points[7]["claims"][0]["values"], values_of(system, "noise"));
}

// Two systems share the draws, and the settings that agree with an observation are run again.
TEST_F(Sweep, InfersSettingsFromObservedValues) {
  write_system();
  std::string other = read("press.toml");
  other.replace(other.find("name = 'press'"), 14, "name = 'other'");
  write("other.toml", other);
  write_sweep();
  write("targets.toml",
        "[inference]\naccepted = 0.3\nbodies = 3\npairs = 1\ntruths = 4\n"
        "[[target]]\ntext = 'Four are named.'\nsystem = 'other'\nmetric = 'classes_separated'\n"
        "observed = 4\nscale = 1\n");
  const Words command{"sweep",     "press.toml",   "other.toml", "--over", "over.toml",
                      "--targets", "targets.toml", "--out",      "out"};
  const std::string shown = output_of(command);
  for (const char* said : {"press, other: 9 draws with 2 pairs each", "1 target", "Five are named.",
                           "of 3 settings of the posterior", "out/inference.json"}) {
    EXPECT_NE(shown.find(said), std::string::npos) << said << "\n is not in\n" << shown;
  }
  const Json json = Json::parse(read("out/inference.json"));
  EXPECT_EQ(json["systems"], Json::array({"press", "other"}));
  EXPECT_EQ(json["claims"].size(), 4U);
  EXPECT_GE(json["accepted"], 6);  // 0.3 of 18 maps
  EXPECT_EQ(json["bodies"].size(), 3U);
  // The seeds of the fresh recordings are others, and a file of a body is the system that was run.
  const Json draws = Json::parse(read("out/sweep.json"))["points"];
  for (const auto& draw : draws) {
    for (const auto& recording : draw["recordings"]) {
      EXPECT_FALSE(fs::exists(path("out/fresh/recordings/" + recording.get<std::string>())));
      EXPECT_FALSE(fs::exists(path("out/recordings/" + recording.get<std::string>())));
    }
  }
  const std::string body = read("out/bodies/02/other.toml");
  EXPECT_NE(body.find("learning_rate_start = " + json["bodies"][1]["rate"].dump()),
            std::string::npos)
      << body;
  output_of({"reproduce", "out/bodies/02/other.toml", "--out", "again", "--pairs", "1",
             "--recordings", "1"});
  EXPECT_EQ(output_of(command), shown) << "nothing is left to run";
  expect_page_of_inference(json);
}

// Settings of sensors are played on two recordings that are explored once.
class StockedSweep : public Sweep {
 protected:
  void write_stocked(const std::string& more = "", const std::string& head = "stock = 2\n") const {
    write_system();
    write("over.toml", "[sweep]\npairs = 2\nrecordings = 2\ndesign = 'sobol'\npoints = 4\n" + head +
                           "[unknown.bits]\nkey = 'explore.hardness_probe.potentiometer_bits'\n"
                           "text = 'Not given.'\nvalues = [4, 12]\n"
                           "[unknown.noise]\nkey = 'explore.hardness_probe.force_noise'\n"
                           "text = 'Not given.'\nvalues = [0.0, 0.04]\n" +
                           more);
  }

  // The time of exploring stands on standard error.
  void explore_and_play(const Words& words) const {
    const ProgramRun done = run(words);
    EXPECT_EQ(done.exit_code, 0) << done.err;
  }

  Json values_at(const std::string& out, std::size_t point) const {
    return Json::parse(read(out + "/sweep.json"))["points"][point]["claims"][0]["values"];
  }
};

TEST_F(StockedSweep, FindsWhatASweepThatExploresFinds) {
  write_stocked("", "");
  explore_and_play(sweep("explored"));
  write_stocked();
  explore_and_play(sweep("played"));
  EXPECT_EQ(files("explored/recordings").size(), 8U);
  const Words stock = files("played/stock");
  EXPECT_EQ(stock.size(), 4U) << "two recordings with each noise of the force";
  for (std::size_t point = 0; point < 4; ++point) {
    EXPECT_EQ(values_at("played", point), values_at("explored", point));
  }
  EXPECT_NE(values_at("played", 0), values_at("played", 1)) << "the bits matter";
  const auto made = times("played/stock");
  write_stocked("", "stock = 3\n");
  explore_and_play(sweep("played"));
  EXPECT_EQ(files("played/stock"), stock) << "the points need no third recording";
  EXPECT_EQ(times("played/stock"), made);
}

TEST_F(StockedSweep, PartsGiveTheSameBytes) {
  write_stocked();
  explore_and_play(sweep("one"));
  for (const char* part : {"3/3", "1/3", "2/3"}) explore_and_play(sweep("three", {"--part", part}));
  expect_same("one", "three");
  EXPECT_EQ(files("one/stock"), files("three/stock"));
}

TEST_F(StockedSweep, DrawsTakeRecordingsInTurnWithNoiseOfTheirOwn) {
  write_stocked("", "stock = 3\n");
  write("targets.toml",
        "[inference]\naccepted = 0.5\nbodies = 2\npairs = 2\ntruths = 2\n"
        "[[target]]\ntext = 'Four are named.'\nsystem = 'press'\nmetric = 'classes_separated'\n"
        "observed = 4\nscale = 1\n");
  explore_and_play(sweep("out", {"--targets", "targets.toml"}));
  const Json points = Json::parse(read("out/sweep.json"))["points"];
  // Draw d and recording r take number (2 d + r) of three, and the seeds follow each other.
  const std::vector<std::vector<std::string>> expected{
      {"2011-2011", "2012-2012"}, {"2013-2013", "2011-2014"}, {"2012-2015", "2013-2016"}};
  for (std::size_t draw = 0; draw < expected.size(); ++draw) {
    for (std::size_t r = 0; r < 2; ++r) {
      EXPECT_EQ(points[draw]["recordings"][r], "hardness-stock-" + expected[draw][r]);
    }
  }
  EXPECT_FALSE(files("out/fresh/stock").empty());
}

// One grasp of each of two tubes, of which the second has the size of the first or another one.
TEST_F(StockedSweep, TablesOfObjectsArePutTogether) {
  write("tubes.toml",
        "[study]\nname = 'tubes'\nlabel = 'object'\nprotocols = ['train_is_test']\n"
        "[module.joints]\ntype = 'channel'\nchannel = 'joints'\nshape = [11]\n"
        "[module.closed]\ntype = 'last'\ninput = 'joints'\n"
        "[module.map]\ntype = 'som'\ninput = 'closed'\nrows = 3\ncolumns = 3\niterations = 50\n"
        "[explore]\nbody = 'lucs3'\nexplorations = 1\n"
        "[[claim]]\ntext = 'Both are named.'\nmetric = 'accuracy'\nat_least = 1\n");
  const std::string tube =
      " = { shape = 'cylinder', diameter = 40, height = 140, material = 'wood' }\n";
  write(
      "over.toml",
      "[sweep]\npairs = 1\nrecordings = 1\ndesign = 'full_factorial'\nstock = 1\n"
      "[explore.object]\nfirst" +
          tube + "second" + tube +
          "[unknown.size]\nkey = 'explore.object.second.diameter'\ntext = 'x'\nvalues = [40, 70]\n"
          "[unknown.noise]\nkey = 'explore.simulation.joint_noise'\ntext = 'x'\nvalues = [0.1]\n");
  explore_and_play({"sweep", "tubes.toml", "--over", "over.toml", "--out", "out"});
  EXPECT_EQ(files("out/stock").size(), 2U) << "equal tubes share their grasps";
  const Json points = Json::parse(read("out/sweep.json"))["points"];
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[1]["claims"][0]["values"][0], 1.0) << "tubes of 40 and 70 mm are separated";
}

TEST_F(StockedSweep, RefusesUnknownsThatCannotBeInAStock) {
  write_stocked(
      "[unknown.force]\nkey = 'explore.hardness_probe.force'\ntext = 'x'\nlow = 1.0\nhigh = 2.0\n");
  const ProgramRun refused = run(sweep("out"));
  EXPECT_NE(refused.exit_code, 0);
  EXPECT_NE(refused.err.find("the unknown 'force' changes what is explored"), std::string::npos)
      << refused.err;
  EXPECT_FALSE(fs::exists(path("out")));
}

TEST_F(Sweep, PartsInAnyOrderOneKilledAreTheSameBytesAsOneRun) {
  write_system(std::to_string(testing::fewer_if_sanitized(8000)));
  write_sweep();
  output_of(sweep("one"));
  ProgramWorld killed;
  killed.terminal = true;
  killed.interrupt_at = " left";
  killed.interrupt_with = SIGKILL;
  EXPECT_EQ(run(sweep("seven", {"--part", "2/7", "--threads", "1"}), killed).signal, SIGKILL);
  EXPECT_TRUE(fs::exists(path("seven/parts/2-of-7/unfinished")));
  for (const std::string part : {"5", "3", "7", "1", "6", "4"}) {
    const std::string shown = output_of(sweep("seven", {"--part", part + "/7"}));
    EXPECT_TRUE(shown.starts_with("Part " + part + " of 7 is done.\n")) << shown;
    EXPECT_FALSE(fs::exists(path("seven/sweep.json")));
  }
  const Json status = Json::parse(output_of(sweep("seven", {"--part", "3/7", "--json"})));
  EXPECT_EQ(status["part"], 3);
  EXPECT_EQ(status["parts"], 7);
  EXPECT_EQ(status["points"], 9);
  EXPECT_LT(status["done"], 9);
  EXPECT_GE(status["done"], 7);
  const std::string shown = output_of(sweep("seven", {"--part", "2/7"}));
  EXPECT_NE(shown.find("Written: seven/sweep.json"), std::string::npos) << shown;
  expect_same("seven", "one");
  EXPECT_FALSE(fs::exists(path("seven/parts/2-of-7/unfinished")));
}

TEST_F(Sweep, WithoutPartRunsWhatIsMissingAndMorePointsRunTheNewOnesOnly) {
  write_system();
  write_sweep();
  output_of(sweep("out", {"--part", "1/2"}));
  output_of(sweep("out"));
  EXPECT_EQ(files("out/parts/1-of-2").size(), 2U * 5);  // two studies a point
  EXPECT_EQ(files("out/parts/1-of-1").size(), 2U * 4);
  write_sweep("design = 'sobol'\npoints = 12\n");
  output_of(sweep("out"));
  EXPECT_EQ(files("out/parts/1-of-1").size(), 2U * 7);
  output_of(sweep("new"));
  expect_same("out", "new");
}

// Results of other pairs, seeds, settings or recordings are not reused.
TEST_F(Sweep, AnotherSweepInTheSameFolderFindsItsOwn) {
  write_system();
  write_sweep("design = 'sobol'\npoints = 2\n");
  output_of(sweep("out"));
  const auto expect_own = [&](const std::string& name) {
    SCOPED_TRACE(name);
    output_of(sweep("out"));
    output_of(sweep(name));
    expect_same("out", name);
  };
  write_sweep("design = 'sobol'\npoints = 2\nseed = 5\n");
  expect_own("seed");
  write("over.toml",
        "[sweep]\npairs = 3\nrecordings = 1\ndesign = 'sobol'\npoints = 2\n" + kUnknowns);
  expect_own("pairs");
  write("over.toml",
        "[sweep]\npairs = 3\nrecordings = 2\ndesign = 'sobol'\npoints = 2\n" + kUnknowns);
  expect_own("recordings");
  write_system("60");
  expect_own("iterations");
}

TEST_F(Sweep, PartsAtTheSameTimeDoNotDisturbEachOther) {
  write_system("1000");
  write_sweep();
  output_of(sweep("one"));
  std::vector<ProgramRun> runs(3);
  std::vector<std::thread> threads;
  threads.reserve(runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    threads.emplace_back([&, i] {
      runs[i] = run(sweep("three", {"--part", std::to_string(i + 1) + "/3", "--threads", "1"}));
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const ProgramRun& done : runs) {
    EXPECT_EQ(done.exit_code, 0) << done.err;
    EXPECT_EQ(done.err, "");
  }
  expect_same("three", "one");
  EXPECT_EQ(files("three/recordings"), files("one/recordings"));
}

TEST_F(Sweep, TheSameBytesForEveryNumberOfThreads) {
  write_system();
  write_sweep("design = 'latin_hypercube'\npoints = 5\n");
  output_of(sweep("one", {"--threads", "1"}));
  output_of(sweep("three", {"--threads", "3"}));
  expect_same("one", "three");
}

TEST_F(Sweep, TakesItsPartFromSlurmAndSaysSo) {
  write_system();
  write_sweep();
  const auto task = [&](const std::string& id, const std::string& first, const std::string& count) {
    ProgramWorld world;
    world.environment = {{"SLURM_ARRAY_TASK_ID", id}, {"SLURM_ARRAY_TASK_COUNT", count}};
    if (!first.empty()) world.environment.emplace_back("SLURM_ARRAY_TASK_MIN", first);
    return world;
  };
  const std::string shown = run(sweep("out"), task("5", "3", "4")).out;
  EXPECT_TRUE(shown.starts_with("Part 3 of 4 (SLURM_ARRAY_TASK_ID = 5) is done.\n")) << shown;
  EXPECT_EQ(files("out/parts/3-of-4").size(), 2U * 2);  // points 3 and 7
  EXPECT_TRUE(run(sweep("out"), task("2", "", "4")).out.starts_with("Part 2 of 4 "));
  EXPECT_TRUE(run(sweep("out", {"--part", "1/9"}), task("2", "", "4"))
                  .out.starts_with("Part 1 of 9 is done.\n"));
  expect_refused(2, sweep("out"), {"SLURM_ARRAY_TASK_ID", "--part K/N"}, task("7", "3", "4"));
  expect_refused(2, sweep("out"), {"SLURM_ARRAY_TASK_ID", "--part K/N"}, task("x", "3", "4"));
}

TEST_F(Sweep, RecordingsMayBeGiven) {
  write_system();
  write_sweep();
  output_of({"explore", "--body", "hardness", "--explorations", "2", "-o", "given.mcap"});
  expect_refused(2, sweep("out", {"--data", "given.mcap"}),
                 {"over.toml:12", "force_noise", "has no effect with --data"});
  write("over.toml", "[sweep]\ndesign = 'one_at_a_time'\npairs = 2\n" +
                         kUnknowns.substr(0, kUnknowns.find("[unknown.noise]")));
  output_of(sweep("out", {"--data", "given.mcap"}));
  const Json json = Json::parse(read("out/sweep.json"));
  EXPECT_EQ(json["points"][0]["recordings"], Json::parse("[\"given.mcap\"]"));
  // Another recording with the same name is processed again.
  output_of(
      {"explore", "--body", "hardness", "--explorations", "2", "--seed", "9", "-o", "given.mcap"});
  output_of(sweep("out", {"--data", "given.mcap"}));
  EXPECT_EQ(files("out/parts/1-of-1").size(), 2U * 2 * 6);
  // And so are other seeds.
  write("over.toml", "[sweep]\ndesign = 'one_at_a_time'\npairs = 2\nseed = 5\n" +
                         kUnknowns.substr(0, kUnknowns.find("[unknown.noise]")));
  output_of(sweep("out", {"--data", "given.mcap"}));
  EXPECT_EQ(files("out/parts/1-of-1").size(), 3U * 2 * 6);
}

TEST_F(Sweep, InterruptedResumesWithTheSameBytes) {
  write_system(std::to_string(testing::fewer_if_sanitized(4000)));
  write_sweep();
  ProgramWorld world;
  world.terminal = true;
  world.interrupt_at = " left";
  const ProgramRun done = run(sweep("out", {"--threads", "1"}), world);
  EXPECT_EQ(done.exit_code, 130);
  // The signal may arrive in the study or while the next point's recording is explored.
  EXPECT_NE(done.err.find("the same command resumes"), std::string::npos) << done.err;
  EXPECT_FALSE(fs::exists(path("out/sweep.json")));
  output_of(sweep("out"));
  output_of(sweep("whole"));
  expect_same("out", "whole");
}

TEST_F(Sweep, DamagedResultsAreComputedAgain) {
  write_system();
  write_sweep();
  output_of(sweep("out"));
  const std::string before = read("out/sweep.json");
  const Words kept = files("out/parts/1-of-1");
  write("out/parts/1-of-1/" + kept[0], "damaged");
  write("out/parts/1-of-1/" + kept[1], read("out/parts/1-of-1/" + kept[1]).substr(0, 100));
  output_of(sweep("out"));
  EXPECT_TRUE(read("out/sweep.json") == before);
}

TEST_F(Sweep, RefusesBeforeAnythingRuns) {
  write_system();
  write_sweep();
  const auto over = [&](const std::string& name, const std::string& text) {
    write(name, text);
    return Words{"sweep", "press.toml", "--over", name, "--out", "out"};
  };
  const std::string head = "[sweep]\ndesign = 'one_at_a_time'\n[unknown.u]\ntext = 'x'\n";
  expect_refused(1, {"sweep", "press.toml", "--over", "none.toml", "--out", "out"},
                 {"none.toml", "cannot open"});
  expect_refused(2, {{{"sweep", "press.toml"}, {"--over is required"}},
                     {over("a.toml", head + "key = 'module.mpa.rows'\nvalues = [1]\n"),
                      {"a.toml:3", "did you mean 'map'?"}},
                     {over("b.toml", head + "key = 'module.map.rows'\nvalues = [3, 0]\n"),
                      {"b.toml:3", "rows"}},
                     {over("c.toml", head + "key = 'explore.press.step'\nlow = -1\nhigh = 1\n"),
                      {"c.toml:3", "step"}},
                     {over("d.toml", head + "key = 'module.map.rows'\nvalues = []\n"),
                      {"d.toml:3", "has no values"}},
                     {over("e.toml", head), {"e.toml:3", "has no key"}},
                     {over("f.toml", head + "key = 'module.map.rows'\nvalues = ['a']\n"),
                      {"f.toml:3", "whole number"}},
                     {sweep("out", {"--part", "0/7"}), {"--part", "is not a part"}},
                     {sweep("out", {"--part", "8/7"}), {"--part", "is not a part"}},
                     {sweep("out", {"--part", "3"}), {"--part", "is not a part"}},
                     {sweep("out", {"--part", "a/b"}), {"--part", "is not a part"}},
                     {{"sweep", "choices", "--over", "over.toml"}, {"not a question"}}});
}

TEST_F(Sweep, TheSamePartTwiceAtOnceIsRefused) {
  write_system("4000");
  write_sweep();
  ProgramWorld world;
  world.terminal = true;
  world.interrupt_at = " left";
  world.before_interrupt = [&](const std::string&) {
    const ProgramRun second = run(sweep("out", {"--part", "2/3"}));
    EXPECT_EQ(second.exit_code, 1);
    EXPECT_NE(second.err.find("another somato process is using this folder"), std::string::npos);
    EXPECT_EQ(run(sweep("out", {"--part", "1/9"})).exit_code, 0);
  };
  EXPECT_EQ(run(sweep("out", {"--part", "2/3", "--threads", "1"}), world).exit_code, 130);
}

}  // namespace
}  // namespace somato
