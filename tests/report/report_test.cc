#include "somato/report/report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

#include "somato/maps/som_quality.h"
#include "support/made_report.h"

namespace somato {
namespace {

using testing::grasps;
using testing::Json;
using testing::learning_study;
using testing::MadeStudy;
using testing::report_of;
using testing::small_study;

const MadeStudy& small() {
  static const MadeStudy made(small_study("none"), grasps(3, 4, 1));
  return made;
}

const MadeStudy& learning() {
  static const MadeStudy made(learning_study(), grasps(3, 4, 1));
  return made;
}

Json whole_report(const MadeStudy& made) {
  return report_of({made.file()}, made.sources());
}

bool says(const Json& missing, const std::string& part) {
  return std::any_of(missing.begin(), missing.end(), [&](const Json& sentence) {
    return sentence.get<std::string>().find(part) != std::string::npos;
  });
}

TEST(Report, HasTheValuesOfResultsJson) {
  const Json report = whole_report(small());
  const Json results = Json::parse(to_json(small().outcome.results));
  EXPECT_EQ(report["version"], 1);
  EXPECT_EQ(report["somato"], "1.2.3");
  const Json& system = report["systems"][0];
  EXPECT_EQ(system["file"], "results.json");
  EXPECT_EQ(system["name"], "small");
  EXPECT_EQ(system["data_hash"], results["data_hash"]);
  ASSERT_EQ(system["protocols"].size(), results["systems"].size());
  for (std::size_t i = 0; i < results["systems"].size(); ++i) {
    const Json& expected = results["systems"][i];
    const Json& found = system["protocols"][i];
    EXPECT_EQ(found["protocol"], expected["protocol"]);
    EXPECT_FALSE(found.contains("name"));  // that of the system, which stands above
    Json metrics = expected["metrics"];
    for (Json& metric : metrics) metric.erase("of_each");
    EXPECT_EQ(found["metrics"], metrics);
    for (std::size_t run = 0; run < expected["runs"].size(); ++run) {
      Json of_report = found["runs"][run];
      EXPECT_EQ(of_report["recording"], 0);
      of_report.erase("recording");
      EXPECT_EQ(of_report, expected["runs"][run]);
    }
  }
}

TEST(Report, HasAllThatThereIsAndMissesNothing) {
  const Json system = whole_report(small())["systems"][0];
  EXPECT_EQ(system["missing"], Json::array());
  EXPECT_EQ(system["recordings"], Json::array({"made.mcap"}));
  EXPECT_EQ(system["grid"], Json::parse(R"({"rows": 5, "columns": 5, "lattice": "rectangular",
                                            "topology": "plane"})"));
  EXPECT_EQ(system["samples"].size(), 12U);
  EXPECT_EQ(system["samples"][4]["object"], "object 2");
  EXPECT_EQ(system["trained"]["seed"], 5);
  EXPECT_EQ(system["trained"]["file"], "system.somato");
}

TEST(Report, DrawsTheGraphAsItWasBuilt) {
  for (const bool with_model : {false, true}) {
    const Json system =
        report_of({learning().file(with_model)}, learning().sources())["systems"][0];
    const Json& graph = system["graph"];
    EXPECT_EQ(graph["map"], "map");
    const System& built = learning().outcome.model.system;
    ASSERT_EQ(graph["modules"].size(), built.modules().size());
    for (std::size_t i = 0; i < built.modules().size(); ++i) {
      const Json& module = graph["modules"][i];
      EXPECT_EQ(module["name"], built.modules()[i].name);
      EXPECT_EQ(module["type"], built.modules()[i].type->name);
      EXPECT_EQ(module["sparse"], built.modules()[i].output.sparse);
      EXPECT_EQ(module["inputs"].size(), built.modules()[i].inputs.size());
    }
    const Json& product = graph["modules"][4];
    EXPECT_EQ(product["shape"], Json::array({2, 4, 5}));
    EXPECT_EQ(product["rate"], "frame");
    EXPECT_EQ(product["inputs"][1], Json::parse(R"({"port": "inputs", "module": "wrist_code"})"));
    EXPECT_EQ(graph["modules"][1]["shape"], Json::array());  // a single number
    EXPECT_EQ(graph["modules"][0]["channel"], "joints");
    EXPECT_EQ(graph["modules"][2]["parameters"]["outside"], "\"clamp\"");
    EXPECT_EQ(graph["modules"][10]["learns"], true);
  }
}

TEST(Report, ListsEveryParameterThatNoPaperGives) {
  const Json list = whole_report(learning())["systems"][0]["not_given"];
  std::set<std::pair<std::string, std::string>> found;
  for (const Json& one : list) {
    EXPECT_NE(one["text"].get<std::string>().find("ot given in the paper"), std::string::npos);
    EXPECT_TRUE(found.emplace(one["part"], one["name"]).second);
  }
  EXPECT_TRUE(found.contains({"module.binding", "arbor_sigma"}));
  EXPECT_TRUE(found.contains({"module.fingers_code", "low"}));
  std::size_t expected = 0;
  for (const SystemModule& module : learning().outcome.model.system.modules()) {
    for (const ParameterInfo& info : module.type->parameters) {
      if (info.text.find("ot given in the paper") != std::string::npos) ++expected;
    }
  }
  EXPECT_EQ(list.size(), expected);
}

// Mean distance to the neighbours, by a plain loop over the weights.
TEST(Report, TheUMatrixIsThatOfTheWeights) {
  const Json matrix = whole_report(small())["systems"][0]["trained"]["u_matrix"];
  const Som& som = small().outcome.map();
  ASSERT_EQ(matrix.size(), som.neurons());
  for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
    double sum = 0.0;
    for (const std::size_t other : som.grid().neighbours(neuron)) {
      double squared = 0.0;
      for (std::size_t e = 0; e < som.input_size(); ++e) {
        const double d = double{som.weight(neuron, e)} - double{som.weight(other, e)};
        squared += d * d;
      }
      sum += std::sqrt(squared);
    }
    const double mean = sum / static_cast<double>(som.grid().neighbours(neuron).size());
    EXPECT_NEAR(matrix[neuron].get<double>(), mean, 1e-5 * mean);
  }
}

TEST(Report, HitsAndLabelsAreThoseOfTheSavedSystem) {
  const Json trained = whole_report(learning())["systems"][0]["trained"];
  std::vector<int> hits(16);
  for (const std::size_t winner : learning().outcome.winners) ++hits[winner];
  EXPECT_EQ(trained["hits"], Json(hits));
  EXPECT_EQ(trained["classes"], Json::array({"object 1", "object 2", "object 3"}));
  for (std::size_t neuron = 0; neuron < 16; ++neuron) {
    EXPECT_EQ(trained["neuron_classes"][neuron].is_null(), hits[neuron] == 0);
  }
}

TEST(Report, PlanesOfAShortInputAreItsWeights) {
  const Json planes = whole_report(small())["systems"][0]["trained"]["planes"];
  ASSERT_EQ(planes.size(), 1U);
  EXPECT_EQ(planes[0]["channel"]["name"], "joints");
  EXPECT_EQ(planes[0]["channel"]["elements"], Json::array({"1", "2", "3"}));
  EXPECT_EQ(planes[0]["unit"], "deg");
  const Som& som = small().outcome.map();
  for (std::size_t neuron = 0; neuron < 25; ++neuron) {
    for (std::size_t joint = 0; joint < 3; ++joint) {
      const double weight = double{som.weight(neuron, joint)};
      EXPECT_NEAR(planes[0]["values"][neuron][joint].get<double>(), weight, 1e-5 * weight);
    }
  }
}

TEST(Report, ReceptiveFieldsAreWhatATMpsomHears) {
  const Json fields = whole_report(learning())["systems"][0]["trained"]["receptive_fields"];
  ASSERT_EQ(fields.size(), 2U);
  EXPECT_EQ(fields[1]["module"], "binding");
  EXPECT_EQ(fields[1]["input"], "wrist_code");
  EXPECT_EQ(fields[1]["axis"], 1);
  EXPECT_EQ(fields[1]["shape"], Json::array({4, 5}));
  EXPECT_EQ(fields[1]["elements"], 5);
  EXPECT_EQ(fields[1]["neurons"].size(), 20U);
  // Neuron (0, 4) is at the end of the axis: exp(-(5 - k)^2 / 2) of its weights, each below 1.
  const Json& last = fields[1]["weights"][4];
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_LE(
        last[k].get<double>(),
        std::exp(-(4.0 - static_cast<double>(k)) * (4.0 - static_cast<double>(k)) / 2) + 1e-6);
  }
  EXPECT_GT(last[4].get<double>(), 0.0);
}

TEST(Report, WithoutRecordingAndModelItSaysWhatIsMissing) {
  const Json report = report_of({small().file(false)}, small().sources(false));
  const Json& system = report["systems"][0];
  EXPECT_TRUE(system["trained"].is_null());
  EXPECT_TRUE(system["samples"].is_null());
  EXPECT_EQ(system["moments"], Json::array());
  EXPECT_TRUE(system["graph"].is_null());  // its channel does not say how many joints there are
  EXPECT_TRUE(says(system["missing"], "trained system"));
  EXPECT_TRUE(says(system["missing"], "--model"));
  EXPECT_TRUE(says(system["missing"], "recording"));
  EXPECT_TRUE(says(system["missing"], "--data"));
  EXPECT_TRUE(says(system["missing"], "graph"));
}

TEST(Report, AModelOfAnotherSystemIsNotUsed) {
  ReportFile file = small().file(false);
  file.models.push_back(learning().model());
  const Json system = report_of({file}, small().sources())["systems"][0];
  EXPECT_TRUE(system["trained"].is_null());
  EXPECT_TRUE(says(system["missing"], "'system.somato' has other settings"));
}

// The same settings, trained with another seed: it may be looked at, and is not called what it is
// not.
TEST(Report, AModelOfAnotherSeedIsToldApart) {
  StudyDescription description = small_study("none");
  description.study.first_seed = 77;
  const MadeStudy other(description, grasps(3, 4, 1));
  ReportFile file = small().file(false);
  file.models.push_back(other.model());
  const Json system = report_of({file}, small().sources())["systems"][0];
  EXPECT_TRUE(system["trained"]["seed"].is_null());
  EXPECT_TRUE(says(system["missing"], "winners of 'system.somato' are those of no run"));
}

TEST(Report, AnotherRecordingIsNotUsed) {
  const MadeStudy other(small_study("none"), grasps(3, 4, 2));
  const Json system = report_of({small().file()}, other.sources())["systems"][0];
  EXPECT_TRUE(system["samples"].is_null());
  EXPECT_EQ(system["trained"]["hits"], Json::array());
  EXPECT_TRUE(says(system["missing"], "recording is not at hand"));
}

TEST(Report, ARecordingOfAnotherLengthIsNotUsedWhateverItsHash) {
  ReportSources sources = small().sources();
  sources.recording = [](const std::string&) {
    return ReportRecording{"wrong", std::make_shared<const Recording>(grasps(3, 5, 1))};
  };
  const Json system = report_of({small().file()}, sources)["systems"][0];
  EXPECT_TRUE(system["samples"].is_null());
  EXPECT_TRUE(says(system["missing"], "15 explorations"));
}

TEST(Report, AWinnerThatIsNotOnTheMapIsRefused) {
  ReportFile file = small().file();
  file.results.parts[0].protocols[0].runs[0].winners[3] = 25;
  const auto report = make_report({file}, small().sources());
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().where, "results.json");
  EXPECT_NE(report.error().what.find("neuron 25"), std::string::npos);
}

TEST(Report, SamplesAreThoseThatWereAskedAbout) {
  StudyDescription description = small_study("none");
  description.study.only = {"object 3", "object 1"};
  const MadeStudy made(description, grasps(3, 4, 1));
  const Json system = whole_report(made)["systems"][0];
  ASSERT_EQ(system["samples"].size(), 8U);
  EXPECT_EQ(system["samples"][4]["object"], "object 3");
  EXPECT_EQ(system["things"].size(), 2U);
  EXPECT_EQ(system["moments"].size(), 2U);
  EXPECT_EQ(system["trained"]["seed"], 5);
}

TEST(Report, ManyFilesStandOneAfterTheOther) {
  const Json report = report_of({small().file(false), learning().file(false)}, small().sources());
  EXPECT_EQ(report["systems"].size(), 2U);
  EXPECT_EQ(report["systems"][1]["name"], "learning");
}

TEST(Report, IsTheSameForAnyNumberOfThreads) {
  ReportSources sources = learning().sources();
  const std::string one = make_report({learning().file()}, sources)->json;
  sources.threads = 3;
  EXPECT_EQ(make_report({learning().file()}, sources)->json, one);
}

const std::string kPage =
    R"(<html><script type="application/json" id="report-data">null</script><p>null</p></html>)";

TEST(ReportPage, HasTheReportInItsPlace) {
  EXPECT_EQ(report_page(kPage, R"({"a": 1})").value(),
            R"(<html><script type="application/json" id="report-data">{"a": 1}</script>)"
            "<p>null</p></html>");
}

TEST(ReportPage, NothingInItEndsItsElement) {
  const Json hostile = {{"</script><script>alert(1)</script>", "<!-- \xE2\x80\xA8 \xE2\x80\xA9 <"}};
  const std::string page = report_page(kPage, hostile.dump()).value();
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_EQ(page.find("<!--"), std::string::npos);
  EXPECT_EQ(page.find("\xE2\x80\xA8"), std::string::npos);
  EXPECT_EQ(page.find("\xE2\x80\xA9"), std::string::npos);
  const std::size_t begin = page.find("report-data\">") + 13;
  const std::string between = page.substr(begin, page.find("</script>") - begin);
  EXPECT_EQ(Json::parse(between), hostile);
}

TEST(ReportPage, NeedsOnePlace) {
  EXPECT_FALSE(report_page("<html></html>", "{}"));
  EXPECT_FALSE(report_page(kPage + kPage, "{}"));
}

}  // namespace
}  // namespace somato
