#include "views/report/deciding_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "views/support/made_report.h"
#include "views/support/unpacked_json.h"

namespace somato {
namespace {

using testing::grasps;
using testing::Json;
using testing::MadeStudy;
using testing::report_of;
using testing::unpacked_row;

// Two wrong names of one sample in both runs, and one of another sample in the first run.
ReportFile with_confusions(const MadeStudy& made) {
  ReportFile file = made.file();
  for (ProtocolResults& protocol : file.results.parts[0].protocols) {
    for (Run& run : protocol.runs) {
      run.predictions = run.labels;
      run.predictions[5] = "object 3";
    }
    protocol.runs.front().predictions[9] = "object 1";
  }
  return file;
}

const MadeStudy& of_joints() {
  static const MadeStudy made(testing::small_study("none"), grasps(3, 4, 1));
  return made;
}

// Distances and contributions from the readings and the weights, by their definitions.
class SavedMap {
 public:
  explicit SavedMap(const MadeStudy& made)
      : made_(made), som_(*som_of(model().system, *model().system.find("map"))) {}

  std::vector<double> joints(std::size_t sample) const {
    const Matrix<float>& frames = made_.recording->explorations[sample].channels[0].frames;
    const auto last = frames.row(frames.rows() - 1);
    return {last.begin(), last.end()};
  }

  double distance(std::size_t sample, std::size_t neuron) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < 3; ++i) sum += std::pow(apart(sample, neuron, i), 2);
    return std::sqrt(sum);
  }

  // The nearest neuron of a class, or of all others.
  std::size_t nearest(std::size_t sample, const std::string& name, bool is_of_class = true) const {
    std::size_t nearest = som_.neurons();
    for (std::size_t n = 0; n < som_.neurons(); ++n) {
      const auto its_class = model().answer->labels[n];
      if (!its_class || (model().answer->classes[*its_class] == name) != is_of_class) continue;
      if (nearest == som_.neurons() || distance(sample, n) < distance(sample, nearest)) nearest = n;
    }
    return nearest;
  }

  double contribution(std::size_t sample, std::size_t a, std::size_t b, std::size_t i) const {
    return (std::pow(apart(sample, b, i), 2) - std::pow(apart(sample, a, i), 2)) /
           (distance(sample, a) + distance(sample, b));
  }

 private:
  const SystemModel& model() const { return made_.outcome.model; }

  double apart(std::size_t sample, std::size_t neuron, std::size_t i) const {
    return joints(sample)[i] - double{som_.weight(neuron, i)};
  }

  const MadeStudy& made_;
  const Som& som_;
};

Json deciding_of(const MadeStudy& made, const ReportFile& file) {
  return report_of({file}, made.sources())["systems"][0]["deciding"];
}

TEST(DecidingJson, HasTheContributionsBetweenConfusedClasses) {
  const Json deciding = deciding_of(of_joints(), with_confusions(of_joints()));
  EXPECT_EQ(deciding["label"], "object");
  EXPECT_EQ(deciding["unit"], "deg");
  EXPECT_EQ(deciding["products"], false);
  ASSERT_EQ(deciding["sources"].size(), 1U);
  EXPECT_EQ(deciding["sources"][0]["channel"]["name"], "joints");
  EXPECT_EQ(deciding["sources"][0]["channel"]["elements"].size(), 3U);
  ASSERT_EQ(deciding["decisions"].size(), 6U);
  const Json& first = deciding["decisions"][0];
  EXPECT_EQ(first["sample"], 5);
  EXPECT_EQ(first["label"], "object 2");
  EXPECT_EQ(first["predicted"], "object 3");
  EXPECT_EQ(first["confused"], 2);
  EXPECT_EQ(first["tests"], 2);
  const Json& second = deciding["decisions"][1];
  EXPECT_EQ(second["sample"], 9);
  EXPECT_EQ(second["confused"], 1);
  EXPECT_EQ((std::set<std::string>{second["nearest"], second["other"]}),
            (std::set<std::string>{"object 1", "object 3"}));
}

TEST(DecidingJson, SumsAreTheDifferencesOfTheDistances) {
  const SavedMap map(of_joints());
  const Json deciding = deciding_of(of_joints(), with_confusions(of_joints()));
  const Json& packed = deciding["sources"][0]["values"];
  const double step = packed["high"].get<double>() - packed["low"].get<double>();
  for (std::size_t d = 0; d < deciding["decisions"].size(); ++d) {
    const Json& one = deciding["decisions"][d];
    const std::size_t sample = one["sample"];
    const std::size_t a = map.nearest(sample, one["nearest"]);
    const std::size_t b = map.nearest(sample, one["other"]);
    EXPECT_LE(map.distance(sample, a), map.distance(sample, b));
    EXPECT_NEAR(one["of_nearest"], map.distance(sample, a), 1e-9);
    EXPECT_NEAR(one["of_other"], map.distance(sample, b), 1e-9);
    EXPECT_NEAR(one["sums"][0], map.distance(sample, b) - map.distance(sample, a), 1e-9);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(unpacked_row(packed, d)[i], map.contribution(sample, a, b, i), step / 65534.0);
    }
  }
}

TEST(DecidingJson, ThenHasTheSamplesBetweenTwoClasses) {
  const SavedMap map(of_joints());
  const Json deciding = deciding_of(of_joints(), with_confusions(of_joints()));
  const auto margin = [&](std::size_t sample, const std::string& answer) {
    const double a = map.distance(sample, map.nearest(sample, answer));
    const double b = map.distance(sample, map.nearest(sample, answer, false));
    return (b - a) / (b + a);
  };
  std::set<std::size_t> listed;
  double last = 0.0;
  for (std::size_t d = 0; d < deciding["decisions"].size(); ++d) {
    const Json& one = deciding["decisions"][d];
    const std::size_t sample = one["sample"];
    EXPECT_TRUE(listed.insert(sample).second);
    if (d < 2) continue;
    EXPECT_EQ(one["answer"], one["nearest"]);
    EXPECT_EQ(one["confused"], 0);
    EXPECT_EQ(one["predicted"], "");
    EXPECT_EQ(one["tests"], 2);
    EXPECT_GE(margin(sample, one["answer"]), last);
    last = margin(sample, one["answer"]);
  }
  for (std::size_t sample = 0; sample < 12; ++sample) {
    if (listed.contains(sample)) continue;
    double least = std::numeric_limits<double>::infinity();
    for (const char* name : {"object 1", "object 2", "object 3"}) {
      if (margin(sample, name) >= 0.0) least = std::min(least, margin(sample, name));
    }
    EXPECT_GE(least, last);
  }
}

// One of the two is not the class next to the answer.
TEST(DecidingJson, ComparesTheClassesOfTheConfusion) {
  for (const std::string predicted : {"object 1", "object 3"}) {
    ReportFile file = with_confusions(of_joints());
    for (ProtocolResults& protocol : file.results.parts[0].protocols) {
      for (auto& run : protocol.runs) run.predictions[5] = predicted;
    }
    const Json first = deciding_of(of_joints(), file)["decisions"][0];
    EXPECT_EQ(first["sample"], 5);
    EXPECT_EQ((std::set<std::string>{first["nearest"], first["other"]}),
              (std::set<std::string>{"object 2", predicted}));
  }
}

// A class that the saved map does not have cannot be compared.
TEST(DecidingJson, OfAnUnknownClassIsOfTheNearestTwo) {
  ReportFile file = with_confusions(of_joints());
  for (ProtocolResults& protocol : file.results.parts[0].protocols) {
    for (auto& run : protocol.runs) run.predictions[5] = "unknown";
  }
  const Json first = deciding_of(of_joints(), file)["decisions"][0];
  EXPECT_EQ(first["predicted"], "unknown");
  EXPECT_EQ(first["nearest"], first["answer"]);
  EXPECT_NE(first["other"], "unknown");
}

TEST(DecidingJson, IsNullWithoutModelOrRecording) {
  for (const bool with_model : {false, true}) {
    const ReportFile file = of_joints().file();
    const Json system =
        report_of({file}, of_joints().sources(!with_model, with_model))["systems"][0];
    EXPECT_TRUE(system["deciding"].is_null());
  }
  ReportSources one_class = of_joints().sources();
  one_class.model = [](const std::string&, const ModelFile&) -> Result<ReportModel> {
    ReportModel model = of_joints().model();
    model.model.answer->labels =
        NeuronLabels({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
    return model;
  };
  const Json system = report_of({of_joints().file()}, one_class)["systems"][0];
  EXPECT_FALSE(system["trained"].is_null());
  EXPECT_TRUE(system["deciding"].is_null());
}

// A system through which contributions are traced to elements of a channel and to a module.
TEST(DecidingJson, SumsAreThoseOfAllSources) {
  const MadeStudy made(testing::learning_study(), grasps(3, 4, 1));
  const Json deciding = deciding_of(made, with_confusions(made));
  ASSERT_EQ(deciding["sources"].size(), 2U);
  EXPECT_EQ(deciding["sources"][1]["is_channel"], false);
  for (const Json& one : deciding["decisions"]) {
    double sum = 0.0;
    for (const Json& of_source : one["sums"]) sum += of_source.get<double>();
    EXPECT_NEAR(sum, one["of_other"].get<double>() - one["of_nearest"].get<double>(), 1e-9);
  }
}

// Elements that are not read are missing; those of a large channel are not listed.
TEST(DecidingJson, ListsAtMost1024Elements) {
  for (const std::size_t elements : {1024UL, 1025UL}) {
    Recording wide = grasps(2, 2, 3);
    for (Exploration& exploration : wide.explorations) {
      Channel& joints = exploration.channels[0];
      Matrix<float> frames(1, elements, 0.5F);
      frames(0, 0) = joints.frames(3, 0);
      joints = {"joints", "deg", {}, std::move(frames), {}};
    }
    const MadeStudy made(testing::study_from("[study]\nname = 'wide'\nseeds = 1\n"
                                             "protocols = ['train_is_test']\n[module.joints]\n"
                                             "type = 'channel'\nchannel = 'joints'\n"
                                             "elements = ['1', '3']\n"
                                             "[module.closed]\ntype = 'last'\ninput = 'joints'\n"
                                             "[module.map]\ntype = 'som'\ninput = 'closed'\n"
                                             "rows = 2\ncolumns = 3\niterations = 30\n"),
                         std::move(wide));
    const Json deciding = deciding_of(made, made.file());
    const Json& source = deciding["sources"][0];
    const bool is_listed = elements == 1024;
    EXPECT_EQ(source["values"]["columns"], is_listed ? 1024 : 0);
    EXPECT_EQ(source["channel"]["elements"].size(), is_listed ? 1024U : 0U);
    const Json& one = deciding["decisions"][0];
    const double difference = one["of_other"].get<double>() - one["of_nearest"].get<double>();
    EXPECT_NEAR(one["sums"][0], difference, 1e-9);
    if (!is_listed) continue;
    const std::vector<double> row = unpacked_row(source["values"], 0);
    EXPECT_TRUE(std::isnan(row[1]) && std::isnan(row[3]));
    EXPECT_NEAR(row[0] + row[2], difference, 1e-4 * std::fabs(difference) + 1e-6);
  }
}

}  // namespace
}  // namespace somato
