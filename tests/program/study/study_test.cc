#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/archives/checksum.h"
#include "program/support/program_test.h"

namespace somato {
namespace {

using Json = nlohmann::json;

class Study : public ProgramTest {
 protected:
  std::string run_study(const std::string& out, const Words& more = {}) const {
    Words words{"run", "study.toml", "--data", kTrials, "--out", out};
    words.insert(words.end(), more.begin(), more.end());
    return output_of(words);
  }

  Json part_of(const std::string& out) const {
    return Json::parse(read(out + "/results.json"))["parts"][0];
  }
};

// The share of predictions that are right, and whether winners keep the classes apart.
double accuracy(const Json& run) {
  double right = 0.0;
  for (std::size_t i = 0; i < run["labels"].size(); ++i) {
    right += run["labels"][i] == run["predictions"][i] ? 1.0 : 0.0;
  }
  return right / static_cast<double>(run["labels"].size());
}

double apart(const Json& run) {
  for (std::size_t i = 0; i < run["labels"].size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (run["winners"][i] == run["winners"][j] && run["labels"][i] != run["labels"][j])
        return 0.0;
    }
  }
  return 1.0;
}

TEST_F(Study, ItsMetricsFollowFromItsRuns) {
  write_study("3");
  run_study("out");
  const Json part = part_of("out");
  EXPECT_EQ(part["system"], "small");
  EXPECT_EQ(part["pairs"], Json::parse("[[0, 1], [0, 2], [0, 3]]"));
  ASSERT_EQ(part["protocols"].size(), 2u);
  for (const Json& system : part["protocols"]) {
    EXPECT_EQ(system["samples"], 30);
    ASSERT_EQ(system["runs"].size(), 3u);
    const Json& metrics = system["metrics"];
    for (std::size_t s = 0; s < 3; ++s) {
      const Json& run = system["runs"][s];
      EXPECT_EQ(run["seed"], s + 1);
      ASSERT_EQ(run["winners"].size(), 30u);
      EXPECT_DOUBLE_EQ(metrics["accuracy"]["values"][s], accuracy(run));
      if (system["protocol"] == "train_is_test") {
        EXPECT_EQ(metrics["individuals_apart"]["values"][s], apart(run));
      }
    }
    for (const auto& [name, metric] : metrics.items()) {
      const std::vector<double> values = metric["values"];
      ASSERT_EQ(values.size(), 3u) << name;
      const double mean = (values[0] + values[1] + values[2]) / 3.0;
      double squares = 0.0;
      for (const double value : values) squares += (value - mean) * (value - mean);
      EXPECT_NEAR(metric["mean"], mean, 1e-12) << name;
      EXPECT_NEAR(metric["sd"], std::sqrt(squares / 2.0), 1e-12) << name;
    }
  }
}

// 27 of 30, as the example's README says of the standardized joints of the last frame.
TEST_F(Study, TheBaselineIsTheExamples) {
  write_study();
  run_study("out");
  const Json protocol = part_of("out")["protocols"][1];
  EXPECT_EQ(protocol["protocol"], "leave_one_out");
  EXPECT_DOUBLE_EQ(protocol["metrics"]["baseline_accuracy_standardized"]["mean"], 0.9);
}

TEST_F(Study, TheSameBytesAgainAndForEveryNumberOfThreads) {
  write_study("3");
  run_study("first");
  const std::string results = read("first/results.json");
  const std::string picture = read("first/map.svg");
  const std::string system = read("first/system.somato");
  ASSERT_FALSE(results.empty());
  ASSERT_FALSE(picture.empty());
  for (const char* threads : {"1", "2", "3"}) {
    run_study(threads, {"--threads", threads});
    EXPECT_TRUE(read(std::string(threads) + "/results.json") == results) << threads;
    EXPECT_TRUE(read(std::string(threads) + "/map.svg") == picture) << threads;
    EXPECT_TRUE(read(std::string(threads) + "/system.somato") == system) << threads;
  }
}

TEST_F(Study, ShowsATableAndWhereItsFilesAre) {
  write_study("3");
  const std::string shown = run_study("deep/down", {"--seeds", "1"});
  EXPECT_NE(shown.find("small: train_is_test by object, 30 samples, 1 seed"), std::string::npos);
  const Json metrics = part_of("deep/down")["protocols"][0]["metrics"];
  const auto mean = [&](const char* name) { return metrics[name]["mean"].get<double>(); };
  EXPECT_NE(shown.find(fmt::format("  {:<20} {:<18.3f} {:<10} {:.3f}\n", "accuracy",
                                   mean("accuracy"), "0.167", mean("baseline_accuracy"))),
            std::string::npos)
      << shown;
  EXPECT_NE(shown.find(fmt::format("  {:<20} {:<18.3f} {:.3f}\n", "individuals_apart",
                                   mean("individuals_apart"), mean("individuals_apart_chance"))),
            std::string::npos)
      << shown;
  EXPECT_EQ(shown.find("classes_separated"), std::string::npos);
  EXPECT_NE(
      shown.find("Written: deep/down/results.json, deep/down/map.svg, deep/down/system.somato"),
      std::string::npos);
  EXPECT_EQ(part_of("deep/down")["pairs"].size(), 1u);
  const auto files = std::filesystem::directory_iterator(path("deep/down"));
  EXPECT_EQ(std::distance(files, std::filesystem::directory_iterator()), 3);
}

// Names of refined maps are longer than the others.
TEST_F(Study, ItsColumnsAreAsWideAsItsNames) {
  write_study();
  write("study.toml", read("study.toml") + "refine = 'glvq'\nrefine_passes = 2\n");
  std::istringstream lines(run_study("out"));
  std::size_t column = std::string::npos;
  std::size_t others = 0;
  std::size_t refined = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.find(" map  ") != std::string::npos) column = line.find("map  ");
    const bool is_refined = line.starts_with("  refined_");
    if (!is_refined && !line.starts_with("  accuracy ")) continue;
    EXPECT_EQ(line.find_first_of("0123456789"), column) << line;
    (is_refined ? refined : others) += 1;
  }
  EXPECT_GT(refined, 0U);
  EXPECT_EQ(others, 2U);  // of two protocols
}

TEST_F(Study, ShowsEveryMetricOnRequest) {
  write_study("2");
  const std::string shown = run_study("out", {"--all-metrics"});
  const Json part = part_of("out");
  for (const Json& protocol : part["protocols"]) {
    for (const auto& [name, metric] : protocol["metrics"].items()) {
      const auto line = fmt::format("  {:<33} {:.3f} +- {:.3f}\n", name,
                                    metric["mean"].get<double>(), metric["sd"].get<double>());
      EXPECT_NE(shown.find(line), std::string::npos) << name << shown;
    }
  }
}

// All that a page or a script needs to know without a guess.
TEST_F(Study, ItsResultsNameWhatTheyAreMadeOf) {
  write_study("2");
  const std::string claim = "\n# As it stands.\n[[claim]]\ntext = 'Some are right.'\n";
  write("study.toml", read("study.toml") + claim + "metric = 'accuracy'\nat_least = 0.1\n");
  run_study("out");
  const Json results = Json::parse(read("out/results.json"));
  EXPECT_EQ(results["version"], 4);
  ASSERT_EQ(results["recordings"].size(), 1u);
  EXPECT_EQ(results["recordings"][0]["name"], std::filesystem::path(kTrials).filename().string());
  EXPECT_EQ(results["recordings"][0]["source"], "given");
  EXPECT_EQ(results["recordings"][0]["explorations"], 30);
  const Json& part = results["parts"][0];
  EXPECT_EQ(part["study"], read("study.toml"));
  EXPECT_EQ(part["parameters"]["module.map"]["type"], "\"som\"");
  EXPECT_EQ(part["model"]["path"], "system.somato");
  EXPECT_EQ(part["model"]["seed"], 1);
  EXPECT_EQ(part["model"]["hash"],
            fmt::format("fnv1a64:{:016x}", fnv1a64(read("out/system.somato"))));
  ASSERT_EQ(results["claims"].size(), 1u);
  EXPECT_EQ(results["claims"][0]["values"], part["protocols"][0]["metrics"]["accuracy"]["values"]);
  EXPECT_EQ(results["claims"][0]["reason"], "2 pairs; 20 are needed");
}

// The study in the results gives the same results, byte by byte.
TEST_F(Study, RunsAgainFromItsResults) {
  write_study("2");
  run_study("out");
  write("again.toml", part_of("out")["study"].get<std::string>());
  output_of({"run", "again.toml", "--data", kTrials, "--out", "again"});
  EXPECT_TRUE(read("again/results.json") == read("out/results.json"));
}

// Trials 1 to 3 of every object to learn from, 4 and 5 to be tested with.
TEST_F(Study, IsTestedWithARecordingOfItsOwn) {
  for (const char* folder : {"learn", "test"}) std::filesystem::create_directory(path(folder));
  for (const auto& entry : std::filesystem::directory_iterator(kTrials)) {
    const std::string name = entry.path().filename().string();
    const bool learned = name.find_first_of("123") != std::string::npos;
    std::filesystem::copy(entry.path(), path(learned ? "learn" : "test"));
  }
  write_study();
  output_of({"run", "study.toml", "--data", "learn", "--test-data", "test", "--out", "out"});
  output_of({"run", "study.toml", "--data", "learn", "--out", "plain"});
  Json part = part_of("out");
  ASSERT_EQ(part["protocols"].size(), 3u);
  const Json tested = part["protocols"][2];
  EXPECT_EQ(tested["protocol"], "test_data");
  EXPECT_EQ(tested["samples"], 12);
  EXPECT_DOUBLE_EQ(tested["metrics"]["accuracy"]["values"][0], accuracy(tested["runs"][0]));
  const Json recordings = Json::parse(read("out/results.json"))["recordings"];
  ASSERT_EQ(recordings.size(), 2u);
  EXPECT_EQ(recordings[0]["name"], "learn");
  EXPECT_EQ(recordings[1]["name"], "test");
  EXPECT_TRUE(recordings[1]["hash"].get<std::string>().starts_with("fnv1a64:"));
  EXPECT_NE(recordings[0]["hash"], recordings[1]["hash"]);
  EXPECT_EQ(part["test_recordings"], Json::parse("[1]"));
  part["test_recordings"].clear();
  part["protocols"].erase(2);
  EXPECT_EQ(part, part_of("plain"));
  EXPECT_TRUE(read("out/system.somato") == read("plain/system.somato"));
  // The winners are those that the saved system finds.
  const std::string answers = output_of({"apply", "out/system.somato", "test"});
  std::istringstream lines(answers);
  std::string line;
  std::getline(lines, line);
  for (const Json& winner : tested["runs"][0]["winners"]) {
    std::getline(lines, line);
    EXPECT_NE(line.find("," + winner.dump() + ","), std::string::npos) << line;
  }
}

}  // namespace
}  // namespace somato
