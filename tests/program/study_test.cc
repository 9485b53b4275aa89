#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "program/program_test.h"

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
  const Json results = Json::parse(read("out/results.json"));
  EXPECT_EQ(results["study"], "small");
  EXPECT_EQ(results["seeds"], 3);
  ASSERT_EQ(results["systems"].size(), 2u);
  for (const Json& system : results["systems"]) {
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
  const Json results = Json::parse(read("out/results.json"));
  EXPECT_EQ(results["systems"][1]["protocol"], "leave_one_out");
  EXPECT_DOUBLE_EQ(results["systems"][1]["metrics"]["baseline_accuracy_standardized"]["mean"], 0.9);
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
  EXPECT_NE(
      shown.find("Written: deep/down/results.json, deep/down/map.svg, deep/down/system.somato"),
      std::string::npos);
  EXPECT_EQ(Json::parse(read("deep/down/results.json"))["seeds"], 1);
  const auto files = std::filesystem::directory_iterator(path("deep/down"));
  EXPECT_EQ(std::distance(files, std::filesystem::directory_iterator()), 3);
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
  Json results = Json::parse(read("out/results.json"));
  ASSERT_EQ(results["systems"].size(), 3u);
  const Json tested = results["systems"][2];
  EXPECT_EQ(tested["protocol"], "test_data");
  EXPECT_EQ(tested["samples"], 12);
  EXPECT_DOUBLE_EQ(tested["metrics"]["accuracy"]["values"][0], accuracy(tested["runs"][0]));
  const std::string other_hash = results["test_data_hash"];
  EXPECT_TRUE(other_hash.starts_with("fnv1a64:"));
  EXPECT_NE(results["data_hash"], other_hash);
  results.erase("test_data_hash");
  results["systems"].erase(2);
  EXPECT_EQ(results, Json::parse(read("plain/results.json")));
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
