#include <nlohmann/json.hpp>
#include <sstream>

#include "program/support/program_test.h"
#include "recordings/imports/icub_grasp.h"
#include "somato/graph/system_model.h"

namespace somato {
namespace {

using Json = nlohmann::json;

std::vector<Words> rows_of(const std::string& csv) {
  std::vector<Words> rows;
  std::istringstream in(csv);
  for (std::string line; std::getline(in, line);) {
    rows.emplace_back();
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(field);
  }
  return rows;
}

class Apply : public ProgramTest {
 protected:
  void train_system() const {
    write_study();
    output_of({"run", "study.toml", "--data", kTrials, "--out", "out"});
  }
};

// Under train_is_test the first seed's map is the one that is saved.
TEST_F(Apply, AnswersAsTheStudyDid) {
  train_system();
  const auto rows = rows_of(output_of({"apply", "out/system.somato", kTrials}));
  const Json run = Json::parse(read("out/results.json"))["parts"][0]["protocols"][0]["runs"][0];
  ASSERT_EQ(rows.size(), 31u);
  EXPECT_EQ(rows[0], (Words{"exploration", "source", "winner", "row", "column", "distance",
                            "object", "given_object"}));
  const SystemModel model = load_system(path("out/system.somato")).value();
  const Som& map = *som_of(model.system, model.system.find("map").value());
  const Recording recording = import_icub_grasp(kTrials).value();
  SomWorkspace workspace;
  for (std::size_t i = 0; i < 30; ++i) {
    const Words& row = rows[i + 1];
    ASSERT_EQ(row.size(), 8u);
    const std::size_t winner = run["winners"][i];
    EXPECT_EQ(row[0], std::to_string(i + 1));
    EXPECT_NE(row[1].find(recording.explorations[i].source), std::string::npos) << row[1];
    EXPECT_EQ(row[2], std::to_string(winner));
    EXPECT_EQ(row[3], std::to_string(winner / 3));
    EXPECT_EQ(row[4], std::to_string(winner % 3));
    EXPECT_EQ(row[6], run["predictions"][i].get<std::string>());
    EXPECT_EQ(row[7], run["labels"][i].get<std::string>());
    const Channel& joints = **find_channel(recording.explorations[i], "joints");
    const auto closed = joints.frames.row(joints.frames.rows() - 1);
    const SignalView view = SignalView::dense(closed);
    EXPECT_NEAR(std::stod(row[5]), map.distance(view, winner, workspace), 1e-6);
  }
}

// Ten balls are known; all other objects are not.
TEST_F(Apply, ReadsWhatIsTooFarAsUnknown) {
  write("wary.toml",
        "[study]\nname = 'wary'\nseeds = 1\nprotocols = ['train_is_test']\n"
        "only = ['ball_small', 'ball_large']\nunknown = true\nfalse_alarm_rate = 0.1\n"
        "[module.joints]\ntype = 'channel'\nchannel = 'joints'\n"
        "[module.closed]\ntype = 'last'\ninput = 'joints'\n"
        "[module.map]\ntype = 'som'\ninput = 'closed'\nrows = 3\ncolumns = 3\n");
  output_of({"run", "wary.toml", "--data", kTrials, "--out", "out"});
  const SystemModel model = load_system(path("out/system.somato")).value();
  const auto rows = rows_of(output_of({"apply", "out/system.somato", kTrials}));
  EXPECT_EQ(rows[0], (Words{"exploration", "source", "winner", "row", "column", "distance",
                            "object", "given_object", "novelty", "nearest_object"}));
  std::size_t unknown = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const bool is_far = std::stod(rows[i][8]) > 1.0;
    EXPECT_EQ(rows[i][6], is_far ? "unknown" : rows[i][9]);
    if (is_far) unknown += rows[i][7].starts_with("ball") ? 0 : 1;
  }
  EXPECT_GT(unknown, 5U);
  const std::string lines =
      output_of({"live", "--model", "out/system.somato", "--recording", kTrials, "--speed", "max"});
  std::istringstream in(lines);
  std::size_t exploration = 0;
  for (std::string text; std::getline(in, text);) {
    const Json line = Json::parse(text);
    if (!line["final"]) continue;
    const Words& row = rows.at(++exploration);
    EXPECT_EQ(line["value"], row[6]);
    EXPECT_EQ(line["nearest"], row[9]);
    EXPECT_NEAR(line["novelty"].get<double>(), std::stod(row[8]), 1e-6);
    const bool is_learned = row[7].starts_with("ball");
    EXPECT_EQ(line["right"], row[6] == (is_learned ? row[7] : "unknown")) << row[7];
  }
  EXPECT_EQ(exploration, 30U);
}

TEST_F(Apply, SavesWhatItShowsForAnyNumberOfThreads) {
  train_system();
  const std::string shown = output_of({"apply", "out/system.somato", kTrials});
  for (const char* threads : {"1", "2", "4"}) {
    EXPECT_EQ(output_of({"apply", "out/system.somato", kTrials, "-o", "answers.csv", "--threads",
                         threads, "--format", "icub_grasp"}),
              "");
    EXPECT_EQ(read("answers.csv"), shown) << threads;
  }
}

TEST_F(Apply, SavesTheContributionsOfSensors) {
  train_system();
  const std::string shown = output_of(
      {"apply", "out/system.somato", kTrials, "--contributions", "sensors.csv", "--threads", "2"});
  EXPECT_EQ(shown, output_of({"apply", "out/system.somato", kTrials}));
  const auto rows = rows_of(read("sensors.csv"));
  EXPECT_EQ(rows[0], (Words{"exploration", "source", "nearest_object", "other_object", "distance",
                            "other_distance", "channel", "element", "\"contribution (deg)\""}));
  const Recording recording = import_icub_grasp(kTrials).value();
  const Channel& joints = **find_channel(recording.explorations[0], "joints");
  const std::size_t elements = joints.element_names.size();
  ASSERT_EQ(rows.size(), 1 + 30 * elements);
  const auto answers = rows_of(shown);
  for (std::size_t i = 0; i < 30; ++i) {
    double sum = 0.0;
    for (std::size_t e = 0; e < elements; ++e) {
      const Words& row = rows[1 + i * elements + e];
      EXPECT_EQ(row[0], std::to_string(i + 1));
      EXPECT_EQ(row[2], answers[i + 1][6]);
      EXPECT_NE(row[3], row[2]);
      EXPECT_EQ(row[6], "joints");
      EXPECT_EQ(row[7], joints.element_names[e]);
      sum += std::stod(row[8]);
    }
    const Words& row = rows[1 + i * elements];
    EXPECT_GE(std::stod(row[4]), std::stod(answers[i + 1][5]) - 1e-6);
    EXPECT_NEAR(sum, std::stod(row[5]) - std::stod(row[4]), 1e-5);
  }
}

// As many rows as an interrupt at the first progress cannot miss.
TEST_F(Apply, AnInterruptKeepsTheOldContributions) {
  std::string head = "kind";
  std::string values;
  for (std::size_t i = 0; i < 30; ++i) {
    head += ",c" + std::to_string(i);
    values += "," + std::to_string(i % 7);
  }
  std::string rows;
  for (const char* kind : {"a", "b", "a", "b", "a", "b"}) {
    rows += kind + values + (kind[0] == 'a' ? "1\n" : "\n");
  }
  write("short.csv", head + "\n" + rows);
  while (rows.size() < 1500000) rows += rows;
  write("long.csv", head + "\n" + rows);
  write("table.toml",
        "[study]\nname = 'table'\nlabel = 'kind'\nseeds = 1\nprotocols = ['train_is_test']\n"
        "[recording]\nlabel_column = 'kind'\n"
        "[module.columns]\ntype = 'channel'\nchannel = 'columns'\n"
        "[module.now]\ntype = 'last'\ninput = 'columns'\n"
        "[module.map]\ntype = 'som'\ninput = 'now'\nrows = 2\ncolumns = 2\niterations = 30\n");
  output_of({"run", "table.toml", "--data", "short.csv", "--out", "out"});
  write("sensors.csv", "old");
  const auto before = contents();
  ProgramWorld world;
  world.terminal = true;
  world.interrupt_at = "contributions: ";
  const ProgramRun stopped = run({"apply", "out/system.somato", "long.csv", "--contributions",
                                  "sensors.csv", "-o", "answers.csv"},
                                 world);
  EXPECT_EQ(stopped.exit_code, 130) << stopped.err;
  EXPECT_NE(stopped.err.find("the contributions were not saved"), std::string::npos) << stopped.err;
  EXPECT_EQ(stopped.out, "");
  EXPECT_TRUE(contents() == before);
}

TEST_F(Apply, RefusesContributionsOfOneClass) {
  train_system();
  SystemModel model = load_system(path("out/system.somato")).value();
  const std::size_t neurons = model.answer->labels.neurons();
  model.answer->labels = NeuronLabels(std::vector<std::optional<std::size_t>>(neurons, 0));
  model.answer->votes = {};
  ASSERT_TRUE(save_system(path("one.somato"), model));
  write("sensors.csv", "old");
  expect_refused(1, {"apply", "one.somato", kTrials, "--contributions", "sensors.csv"},
                 {"contributions compare two classes", "train the system"});
  EXPECT_EQ(read("sensors.csv"), "old");
}

TEST_F(Apply, RefusesOtherFiles) {
  train_system();
  train();
  write("notes", "not a system");
  std::string damaged = read("out/system.somato");
  damaged[damaged.size() / 2] ^= 1;
  write("damaged", damaged);
  expect_refused(
      1, {{{"apply", "good.map", kTrials}, {"good.map: the file contains 'som', not 'system'"}},
          {{"apply", "study.toml", kTrials}, {"study.toml: this is not a model file of Somato"}},
          {{"apply", "notes", kTrials}, {"notes: this is not a model file of Somato"}},
          {{"apply", "damaged", kTrials}, {"damaged: "}},
          {{"apply", "missing", kTrials}, {"missing: cannot open", "No such file"}},
          {{"apply", "out/system.somato", "missing"}, {"missing: ", "there is no such file"}},
          {{"apply", "out/system.somato", "notes"}, {"notes: "}},
          {{"apply", "out/system.somato", kTrials, "-o", "nowhere/answers"},
           {"nowhere/answers: cannot save"}}});
  expect_refused(
      2, {{{"apply", "out/system.somato", kTrials, "--format", "icub_grip"},
           {"--format: unknown format 'icub_grip'", "did you mean 'icub_grasp'?"}},
          {{"apply", "out/system.somato", kTrials, "-o", "out/system.somato"}, {"given twice"}},
          {{"apply", "out/system.somato"}, {"DATA is required"}},
          {{"apply", "out/system.somato", kTrials, "--threads", "0"}, {"--threads: "}}});
}

// Forces instead of joints.
TEST_F(Apply, RefusesOtherChannels) {
  train_system();
  std::filesystem::create_directory(path("press"));
  write("press/Material_wood_raw_1.csv", "Fx,Fy,Fz\n0,0,1\n0,0,2\n");
  expect_refused(1, {"apply", "out/system.somato", "press"},
                 {"press: the recording does not fit the system: unknown channel 'joints'",
                  "recordings with the same channels"});
}

TEST_F(Apply, RefusesASystemWithoutAnAnswer) {
  train_system();
  const SystemModel model = load_system(path("out/system.somato")).value();
  ASSERT_TRUE(save_system(path("mute"), model.system));
  expect_refused(1, {"apply", "mute", kTrials},
                 {"mute: the system has no output map", "'somato run'"});
}

}  // namespace
}  // namespace somato
