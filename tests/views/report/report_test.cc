#include "views/report/report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "somato/maps/som_quality.h"
#include "views/support/made_report.h"
#include "views/support/unpacked_json.h"

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
  const Json results = Json::parse(to_json(small().file().results));
  const Json& protocols = results["parts"][0]["protocols"];
  EXPECT_EQ(report["version"], 2);
  EXPECT_EQ(report["somato"], "1.2.3");
  const Json& system = report["systems"][0];
  EXPECT_EQ(system["file"], "results.json");
  EXPECT_EQ(system["name"], "small");
  EXPECT_EQ(system["data_hash"], results["recordings"][0]["hash"]);
  EXPECT_EQ(system["settings"], results["parts"][0]["parameters"]);
  ASSERT_EQ(system["protocols"].size(), protocols.size());
  for (std::size_t i = 0; i < protocols.size(); ++i) {
    const Json& expected = protocols[i];
    const Json& found = system["protocols"][i];
    EXPECT_EQ(found["protocol"], expected["protocol"]);
    Json metrics = expected["metrics"];
    for (Json& metric : metrics) metric.erase("of_each");
    EXPECT_EQ(found["metrics"], metrics);
    for (std::size_t run = 0; run < expected["runs"].size(); ++run) {
      Json of_report = found["runs"][run];
      EXPECT_EQ(of_report["recording"], 0);
      of_report.erase("recording");
      Json of_results = expected["runs"][run];
      if (of_results.contains("map")) {
        of_report["map"].erase("u_matrix");  // packed
        of_results["map"].erase("u_matrix");
      }
      EXPECT_EQ(of_report, of_results);
    }
  }
}

TEST(Report, AMetricWithoutAValueIsNull) {
  ReportFile file = small().file();
  Metric& metric = file.results.parts[0].protocols[0].metrics[0];
  metric.values[0] = std::nan("");
  const Json report = report_of({file}, small().sources());
  const Json& found = report["systems"][0]["protocols"][0]["metrics"][metric.name];
  EXPECT_TRUE(found["mean"].is_null());
  EXPECT_TRUE(found["sd"].is_null());
  EXPECT_TRUE(found["values"][0].is_null());
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
        report_of({learning().file()}, learning().sources(true, with_model))["systems"][0];
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

// The first seed is that of the saved system; packed numbers are exact to half a step.
TEST(Report, EverySeedHasItsUMatrix) {
  const ReportFile file = small().file();
  const auto& runs = file.results.parts[0].protocols[0].runs;
  ASSERT_EQ(runs.size(), 2U);
  const Json system = whole_report(small())["systems"][0];
  for (std::size_t i = 0; i < 2; ++i) {
    const Json map = system["protocols"][0]["runs"][i]["map"];
    EXPECT_EQ(map["grid"], system["grid"]);
    const std::vector<double> distances = testing::unpacked(map["u_matrix"]);
    const std::vector<double>& expected = runs[i].map->u_matrix;
    ASSERT_EQ(distances.size(), expected.size());
    const double range = *std::max_element(expected.begin(), expected.end());
    for (std::size_t neuron = 0; neuron < expected.size(); ++neuron) {
      EXPECT_NEAR(distances[neuron], expected[neuron], range / 65534.0 + 1e-5 * range);
    }
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

TEST(Report, TheSamplesLieOnTheSavedMapInTheirOrder) {
  const Json system = whole_report(learning())["systems"][0];
  EXPECT_EQ(system["trained"]["winners"], Json(learning().outcome.winners));
  EXPECT_EQ(system["samples"].size(), learning().outcome.winners.size());
}

TEST(Report, PlanesOfAShortInputAreItsWeights) {
  const Json planes = whole_report(small())["systems"][0]["trained"]["planes"];
  ASSERT_EQ(planes.size(), 1U);
  EXPECT_EQ(planes[0]["channel"]["name"], "joints");
  EXPECT_EQ(planes[0]["channel"]["elements"], Json::array({"1", "2", "3"}));
  EXPECT_EQ(planes[0]["unit"], "deg");
  const Json& values = planes[0]["values"];
  const double step = (values["high"].get<double>() - values["low"].get<double>()) / 65534.0;
  const Som& som = small().outcome.map();
  for (std::size_t neuron = 0; neuron < 25; ++neuron) {
    for (std::size_t joint = 0; joint < 3; ++joint) {
      const double weight = double{som.weight(neuron, joint)};
      EXPECT_NEAR(testing::unpacked_row(values, neuron)[joint], weight, step);
    }
  }
}

TEST(Report, ReceptiveFieldsAreArborTimesWeights) {
  const Json fields = whole_report(learning())["systems"][0]["trained"]["receptive_fields"];
  ASSERT_EQ(fields.size(), 2U);
  EXPECT_EQ(fields[1]["module"], "binding");
  EXPECT_EQ(fields[1]["input"], "wrist_code");
  EXPECT_EQ(fields[1]["axis"], 1);
  EXPECT_EQ(fields[1]["shape"], Json::array({4, 5}));
  EXPECT_EQ(fields[1]["elements"], 5);
  EXPECT_EQ(fields[1]["neurons"].size(), 20U);
  // Neuron (0, 4) is at the end of the axis: exp(-(5 - k)^2 / 2) of its weights, each below 1.
  const auto last = testing::unpacked_row(fields[1]["weights"], 4);
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_LE(
        last[k],
        std::exp(-(4.0 - static_cast<double>(k)) * (4.0 - static_cast<double>(k)) / 2) + 1e-5);
  }
  EXPECT_GT(last[4], 0.0);
}

TEST(Report, WithoutRecordingAndModelItSaysWhatIsMissing) {
  const Json report = report_of({small().file()}, small().sources(false, false));
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

TEST(Report, RequestsTheModelNamedInTheResults) {
  ReportFile file = small().file();
  file.path = "some/results.json";
  file.results.parts[0].model = ModelFile{"a/b.somato", "fnv1a64:12", 6};
  ReportSources sources = small().sources();
  std::string wanted;
  sources.model = [&](const std::string& results, const ModelFile& model) -> Result<ReportModel> {
    wanted = results + " " + model.path + " " + model.hash;
    return small().model();
  };
  const Json system = report_of({file}, sources)["systems"][0];
  EXPECT_EQ(wanted, "some/results.json a/b.somato fnv1a64:12");
  EXPECT_EQ(system["trained"]["seed"], 6);
}

TEST(Report, SaysWhyTheModelIsNotAtHand) {
  ReportSources sources = small().sources();
  sources.model = [](const std::string&, const ModelFile&) -> Result<ReportModel> {
    return fail(ErrorKind::kData, "it is another", "system.somato", "do this");
  };
  const Json system = report_of({small().file()}, sources)["systems"][0];
  EXPECT_TRUE(system["trained"].is_null());
  EXPECT_TRUE(says(system["missing"], "--model (system.somato: it is another; do this)"));
}

// The model of the same settings is there, but no fact says that it is theirs.
TEST(Report, WithoutANameOfAModelNoneIsUsed) {
  ReportFile file = small().file();
  file.results.parts[0].model.reset();
  const Json system = report_of({file}, small().sources())["systems"][0];
  EXPECT_TRUE(system["trained"].is_null());
  EXPECT_TRUE(says(system["missing"], "No trained system was saved"));
}

TEST(Report, AStudyThatCannotBeReadHasNoGraph) {
  ReportFile file = small().file();
  file.results.parts[0].study = "[study]\nnmae = 'small'\n";
  const Json system = report_of({file}, small().sources(true, false))["systems"][0];
  EXPECT_TRUE(system["graph"].is_null());
  EXPECT_TRUE(says(system["missing"], "the study of 'small':2"));
}

TEST(Report, AnotherRecordingIsNotUsed) {
  const MadeStudy other(small_study("none"), grasps(3, 4, 2));
  const Json system = report_of({small().file()}, other.sources())["systems"][0];
  EXPECT_TRUE(system["samples"].is_null());
  EXPECT_EQ(system["trained"]["hits"], Json::array());
  EXPECT_TRUE(says(system["missing"], "recording was not found"));
}

TEST(Report, ARecordingOfAnotherLengthIsNotUsedWhateverItsHash) {
  ReportSources sources = small().sources();
  sources.recording = [](const std::string&) {
    return std::make_shared<const Recording>(grasps(3, 5, 1));
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

TEST(Report, SamplesAreThoseOfTheStudy) {
  StudyDescription description = small_study("none");
  description.study.only = {"object 3", "object 1"};
  const MadeStudy made(description, grasps(3, 4, 1));
  const Json system = whole_report(made)["systems"][0];
  ASSERT_EQ(system["samples"].size(), 8U);
  EXPECT_EQ(system["samples"][4]["object"], "object 3");
  EXPECT_EQ(system["things"].size(), 2U);
  EXPECT_EQ(system["moments"].size(), 8U);
  EXPECT_EQ(system["trained"]["seed"], 5);
}

TEST(Report, ManyFilesStandOneAfterTheOther) {
  const Json report = report_of({small().file(), learning().file()}, small().sources(true, false));
  EXPECT_EQ(report["systems"].size(), 2U);
  EXPECT_EQ(report["systems"][1]["name"], "learning");
}

TEST(Report, HasThePlacesOfEachChannelOnce) {
  const auto elements = small().recording->explorations[0].channels[0].frames.columns();
  ReportSources sources = small().sources();
  ChannelPlaces joints{"joints", "hand.toml:1", {}, {}, {}, {}};
  for (std::size_t i = 0; i < elements; ++i) joints.places.push_back({static_cast<double>(i), 2});
  sources.places = {joints};
  const Json report = report_of({small().file()}, sources);
  ASSERT_EQ(report["placed"].size(), 1U);
  EXPECT_EQ(report["placed"][0]["name"], "joints");
  EXPECT_EQ(report["placed"][0]["layout"]["places"].size(), elements);
  EXPECT_FALSE(report_of({small().file()}, small().sources()).contains("placed"));

  sources.places[0].places.push_back({-1, 2});
  const auto other = make_report({small().file()}, sources);
  ASSERT_FALSE(other);
  EXPECT_NE(other.error().what.find("'joints' has"), std::string::npos);
  sources.places[0].channel = "joint";
  const auto unknown = make_report({small().file()}, sources);
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().advice, "did you mean 'joints'?");
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
