#include <algorithm>

#include "program/support/reproducing.h"

namespace somato {
namespace {

using Json = nlohmann::json;

// The page shows metrics without the values of each wrong grouping.
Json without_groupings(Json metrics) {
  for (Json& metric : metrics) metric.erase("of_each");
  return metrics;
}

class Report : public Reproduce {
 protected:
  void SetUp() override {
    if (has_no_pages(run({"report", "none.json", "-o", "x"}))) {
      GTEST_SKIP() << "the program was built without npm, so it has no page to fill";
    }
  }

  void make_results() const {
    write_study("2");
    output_of({"run", "study.toml", "--data", kTrials, "--out", "out"});
  }

  // The data in the page.
  Json data_of(const std::string& page) const {
    const std::string text = read(page);
    const std::string mark = "id=\"report-data\">";
    const std::size_t begin = text.find(mark) + mark.size();
    return Json::parse(text.substr(begin, text.find("</script>", begin) - begin));
  }

  static bool says(const Json& sentences, const std::string& part) {
    return std::any_of(sentences.begin(), sentences.end(), [&](const Json& sentence) {
      return sentence.get<std::string>().find(part) != std::string::npos;
    });
  }
};

TEST_F(Report, OfAStudyWithAllThatIsAtHand) {
  make_results();
  const std::string said =
      output_of({"report", "out/results.json", "--data", kTrials, "-o", "report.html"});
  EXPECT_EQ(said, "report.html: 1 system, 0 claims\n");
  const Json report = data_of("report.html");
  const Json results = Json::parse(read("out/results.json"));
  const Json& system = report["systems"][0];
  EXPECT_EQ(system["missing"], Json::array());
  EXPECT_EQ(system["file"], "out/results.json");
  const Json& protocols = results["parts"][0]["protocols"];
  EXPECT_EQ(system["protocols"][0]["metrics"], without_groupings(protocols[0]["metrics"]));
  EXPECT_EQ(system["protocols"][1]["runs"][1]["winners"], protocols[1]["runs"][1]["winners"]);
  EXPECT_EQ(system["trained"]["seed"], 1);
  EXPECT_EQ(system["trained"]["file"], "out/system.somato");
  EXPECT_EQ(system["samples"].size(), protocols[0]["samples"]);
  EXPECT_TRUE(read("report.html").starts_with("<!doctype html>"));
}

TEST_F(Report, FindsARecordingBesideTheResultsByWhatIsInIt) {
  write_study("1");
  output_of({"import", "icub_grasp", kTrials, "-o", "grasps.mcap"});
  output_of({"run", "study.toml", "--data", "grasps.mcap", "--out", "out"});
  output_of({"explore", "--body", "hardness", "--explorations", "1", "-o", "out/a_press.mcap"});
  write("out/broken.mcap", read("grasps.mcap").substr(0, 5000));
  fs::rename(path("grasps.mcap"), path("out/some.mcap"));
  output_of({"report", "out/results.json", "-o", "report.html"});
  const Json system = data_of("report.html")["systems"][0];
  EXPECT_EQ(system["missing"], Json::array());
  EXPECT_EQ(system["samples"].size(), 30U);
  EXPECT_EQ(system["recordings"], Json::array({"grasps.mcap"}));  // as it was called
}

TEST_F(Report, SaysWhatIsMissing) {
  make_results();
  fs::remove(path("out/system.somato"));
  const std::string said = output_of({"report", "out/results.json", "-o", "report.html"});
  EXPECT_NE(said.find("The trained system was not found"), std::string::npos);
  EXPECT_NE(said.find("The recording was not found"), std::string::npos);
  const Json system = data_of("report.html")["systems"][0];
  EXPECT_TRUE(says(system["missing"], "--model"));
  EXPECT_TRUE(says(system["missing"], "--data"));
  EXPECT_TRUE(system["trained"].is_null());
}

TEST_F(Report, ARecordingOfSomethingElseIsNotTaken) {
  make_results();
  output_of({"explore", "--body", "hardness", "--explorations", "1", "-o", "press.mcap"});
  output_of({"report", "out/results.json", "--data", "press.mcap", "-o", "report.html"});
  const Json system = data_of("report.html")["systems"][0];
  EXPECT_TRUE(system["samples"].is_null());
  EXPECT_TRUE(says(system["missing"], "The recording was not found"));
  EXPECT_TRUE(says(system["missing"], "'press.mcap' is not the one of these results"));
}

// For example the working folder, which also contains results of others.
TEST_F(Report, FindsTheRecordingInAFolderWithResultsBelow) {
  make_results();
  fs::create_directories(path("all/out"));
  fs::copy(path("out/results.json"), path("all/out/results.json"));
  output_of({"import", "icub_grasp", kTrials, "-o", "all/grasps.mcap"});
  output_of({"report", "out/results.json", "--data", "all", "-o", "report.html"});
  EXPECT_EQ(data_of("report.html")["systems"][0]["samples"].size(), 30U);
}

// The same study, trained with another seed: its file says so by its hash.
TEST_F(Report, AnotherModelIsNotTaken) {
  make_results();
  fs::rename(path("out"), path("first"));
  std::string other = read("study.toml");
  other.insert(other.find("name"), "first_seed = 7\n");
  write("study.toml", other);
  output_of({"run", "study.toml", "--data", kTrials, "--out", "out"});
  fs::copy(path("first/results.json"), path("out/results.json"),
           fs::copy_options::overwrite_existing);
  output_of({"report", "out/results.json", "-o", "report.html"});
  const Json system = data_of("report.html")["systems"][0];
  EXPECT_TRUE(system["trained"].is_null());
  EXPECT_TRUE(says(system["missing"], "out/system.somato: the trained system is not the one"));
  output_of({"report", "out/results.json", "--model", "first/system.somato", "-o", "report.html"});
  const Json found = data_of("report.html")["systems"][0];
  EXPECT_EQ(found["trained"]["file"], "first/system.somato");
  EXPECT_EQ(found["trained"]["seed"], 1);
}

TEST_F(Report, OfAReproductionFindsItsRecordings) {
  write("press.toml", press() +
                          "[[claim]]\ntext = 'Named rightly </script><b>'\n"
                          "metric = 'accuracy'\nat_least = 0.5\npublished = 1\n" +
                          "[variation.a]\nmodule.map.iterations = 60\n"
                          "[variation.b]\nmodule.map.iterations = 70\n");
  output_of(reproduce("press.toml", "out"));
  output_of({"report", "out/results.json", "-o", "report.html"});
  const Json report = data_of("report.html");
  const Json found = results("out");
  ASSERT_EQ(report["systems"].size(), 3U);
  const Json names = {found["recordings"][0]["name"], found["recordings"][1]["name"]};
  for (std::size_t i = 0; i < 3; ++i) {
    const Json& system = report["systems"][i];
    EXPECT_EQ(system["recordings"], names);
    EXPECT_EQ(system["protocols"][0]["metrics"],
              without_groupings(found["parts"][i]["protocols"][0]["metrics"]));
    EXPECT_EQ(system["protocols"][0]["runs"][2]["recording"], 1);
    EXPECT_EQ(system["samples"].size(), 16U);
    EXPECT_EQ(system["missing"], Json::array());
    EXPECT_EQ(system["trained"]["seed"], 2011);
    EXPECT_EQ(system["graph"]["map"], "map");
    EXPECT_EQ(system["moments"], report["systems"][0]["moments"]);  // of the same explorations
    EXPECT_EQ(system["moments"].size(), 16U);
  }
  EXPECT_EQ(report["moments"].size(), 16U);
  EXPECT_EQ(report["systems"][0]["settings"]["explore"]["body"], "\"hardness\"");
  ASSERT_EQ(report["claims"].size(), 1U);
  EXPECT_EQ(report["claims"][0]["text"], "Named rightly </script><b>");
  EXPECT_EQ(report["claims"][0]["share"], found["claims"][0]["share"]);
  EXPECT_EQ(report["claims"][0]["values"],
            found["parts"][0]["protocols"][0]["metrics"]["accuracy"]["values"]);
  EXPECT_EQ(report["curves"][0]["x"], "iterations");
  EXPECT_EQ(report["curves"][0]["lines"][0]["points"].size(), 3U);
  EXPECT_EQ(read("report.html").find("</script><b>"), std::string::npos);
}

TEST_F(Report, OfSeveralResultsAtOnce) {
  make_results();
  fs::create_directory(path("more"));
  fs::copy(path("out/results.json"), path("more/results.json"));
  EXPECT_TRUE(output_of({"report", "out/results.json", "more/results.json", "-o", "report.html"})
                  .starts_with("report.html: 2 systems"));
}

TEST_F(Report, RefusesWhatCannotBe) {
  make_results();
  const Words report{"report", "out/results.json", "-o", "report.html"};
  const auto with = [&](Words more) {
    more.insert(more.begin(), report.begin(), report.end());
    return more;
  };
  write("bad.json", read("out/results.json").substr(0, 400));
  write("nan.json", "{\"version\": 4, \"parts\": NaN}");
  write("foreign.json", "{\"version\": 1, \"study\": \"a\"}");
  write("old.json", R"({"version": 3, "study": "a", "systems": []})");
  write("junk.somato", "junk");
  expect_refused(2, {"report", "-o", "x"}, {"RESULTS is required"});
  expect_refused(2, {"report", "out/results.json"}, {"--output is required"});
  expect_refused(1, {"report", "none.json", "-o", "x"}, {"none.json"});
  expect_refused(1, {"report", "bad.json", "-o", "x"},
                 {"bad.json", "ends too early", "use a results.json"});
  expect_refused(1, {"report", "nan.json", "-o", "x"}, {"nan.json", "not valid JSON"});
  expect_refused(1, {"report", "foreign.json", "-o", "x"}, {"foreign.json", "not a results.json"});
  expect_refused(1, {"report", "old.json", "-o", "x"},
                 {"old.json: written by an earlier version of Somato (format 3, supported is 4)",
                  "of this version again"});
  expect_refused(1, {"report", "out/map.svg", "-o", "x"}, {"out/map.svg", "not valid JSON"});
  expect_refused(2, {"report", "out/results.json", "./out/results.json", "-o", "x"}, {"twice"});
  expect_refused(2, {"report", "out/results.json", "-o", "out/results.json"}, {"overwrite"});
  expect_refused(1, {"report", "out/results.json", "-o", "no/where.html"}, {"no/where.html"});
  expect_refused(1, {"report", "out/results.json", "-o", "out"}, {"out"});
  expect_refused(1, with({"--model", "junk.somato"}), {"junk.somato"});
  expect_refused(1, with({"--model", "none.somato"}), {"none.somato"});
  expect_refused(1, with({"--data", "none"}), {"none"});
  expect_refused(
      2, {"report", "out/results.json", "--model", "out/system.somato", "-o", "out/system.somato"},
      {"overwrite"});
}

TEST_F(Report, IsSavedWhollyOrNotAtAll) {
  make_results();
  write("report.html", "as it was");
  ProgramWorld world;
  world.largest_file = 4096;
  const ProgramRun done = run({"report", "out/results.json", "-o", "report.html"}, world);
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_EQ(read("report.html"), "as it was");
}

}  // namespace
}  // namespace somato
