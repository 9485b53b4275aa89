#include <nlohmann/json.hpp>

#include "program/support/program_test.h"
#include "somato/studies/own_systems.h"

namespace somato {
namespace {

using Json = nlohmann::json;

class Conventions : public ProgramTest {
 protected:
  Json json_of(Words arguments) const {
    arguments.emplace_back("--json");
    const std::string text = output_of(arguments);
    const Json json = Json::parse(text, nullptr, false);
    EXPECT_FALSE(json.is_discarded()) << text;
    return json;
  }
};

TEST_F(Conventions, QuietCommandsPrintOnlyTheRequestedOutput) {
  write_study();
  const Words study{"run", "study.toml", "--data", kTrials, "--out", "out"};
  ProgramWorld terminal;
  terminal.terminal = true;
  Words quiet = study;
  quiet.emplace_back("--quiet");
  const ProgramRun silent = run(quiet, terminal);
  EXPECT_EQ(silent.exit_code, 0);
  EXPECT_EQ(silent.out, "");
  EXPECT_EQ(silent.err, "");
  const ProgramRun loud = run(study, terminal);
  EXPECT_NE(loud.out.find("Written: "), std::string::npos);
  EXPECT_NE(loud.err.find("small: "), std::string::npos) << "progress";
  EXPECT_EQ(output_of({"systems", "--quiet"}), output_of({"systems"}));
  EXPECT_EQ(output_of({"import", "icub_grasp", kTrials, "-o", "grasps.mcap", "--quiet"}), "");
  write("named.csv", "a,b,c\n1,2,3\n4,5,7\n2,9,1\n");
  output_of({"som", "train", "named.csv", "-o", "named.map", "--skip", "c", "--quiet"});
  EXPECT_NE(run({"som", "map", "named.map", "named.csv"}).err.find("left out c"),
            std::string::npos);
  EXPECT_EQ(run({"som", "map", "named.map", "named.csv", "--quiet"}).err, "");
  const ProgramRun wrong = run({"inspect", "missing.mcap", "--quiet"});
  EXPECT_NE(wrong.err.find("missing.mcap"), std::string::npos);
}

TEST_F(Conventions, StudiesAndTheirVectorsArePrintedAsTheirFiles) {
  write_study();
  const std::string printed =
      output_of({"run", "study.toml", "--data", kTrials, "-o", "out", "--json"});
  EXPECT_EQ(printed, read("out/results.json"));
  const std::string vectors = output_of(
      {"information", "study.toml", "--data", kTrials, "-o", "information.json", "--json"});
  EXPECT_EQ(vectors, read("information.json"));
}

TEST_F(Conventions, RecordingsArePrintedAsJson) {
  output_of({"import", "icub_grasp", kTrials, "-o", "grasps.mcap"});
  const Json json = json_of({"inspect", "grasps.mcap"});
  EXPECT_EQ(json["explorations"], 30);
  EXPECT_EQ(json["size"], std::filesystem::file_size(path("grasps.mcap")));
  EXPECT_EQ(json["whole"], true);
  std::size_t counted = 0;
  ASSERT_EQ(json["labels"][0]["label"], "object");
  for (const Json& value : json["labels"][0]["values"]) {
    counted += value["explorations"].get<std::size_t>();
  }
  EXPECT_EQ(counted, 30u);
  ASSERT_FALSE(json["channels"].empty());
  const Json saved = json_of({"recover", "grasps.mcap", "-o", "saved.mcap"});
  EXPECT_EQ(saved["explorations"], 30);
  EXPECT_EQ(saved["lossless"], true);
}

// The same answers as in CSV, which another test compares with the study's.
TEST_F(Conventions, AnswersAreTheSameAsJson) {
  write_study();
  output_of({"run", "study.toml", "--data", kTrials, "--out", "out"});
  const Json answers = json_of({"apply", "out/system.somato", kTrials})["answers"];
  ASSERT_EQ(answers.size(), 30u);
  std::string csv = "exploration,source,winner,row,column,distance,object,given_object\n";
  for (const Json& one : answers) {
    csv += one["exploration"].dump() + "," + one["source"].dump() + ",";
    for (const char* name : {"winner", "row", "column"}) csv += one[name].dump() + ",";
    char distance[32];
    std::snprintf(distance, sizeof distance, "%.9g", one["distance"].get<double>());
    csv += std::string(distance) + "," + one["object"].get<std::string>() + "," +
           one["given_object"].get<std::string>() + "\n";
  }
  EXPECT_EQ(csv, output_of({"apply", "out/system.somato", kTrials}));
}

TEST_F(Conventions, MapsArePrintedAsJson) {
  train();
  const Json quality = json_of({"som", "quality", "good.map", "data.csv"});
  EXPECT_EQ(quality["samples"], 12);
  EXPECT_EQ(quality["neurons"], 20);
  std::string lines;
  const auto ordered = nlohmann::ordered_json::parse(
      output_of({"som", "quality", "good.map", "data.csv", "--json"}));
  for (const auto& [name, value] : ordered.items()) {
    char figure[32];
    std::snprintf(figure, sizeof figure, "%.6g", value.get<double>());
    lines += name + " " + figure + "\n";
  }
  EXPECT_EQ(lines, output_of({"som", "quality", "good.map", "data.csv"}));
  const Json winners = json_of({"som", "map", "good.map", "data.csv"});
  ASSERT_EQ(winners.size(), 12U);
  std::string csv = "sample,winner,row,column,distance\n";
  for (const Json& one : winners) {
    for (const char* name : {"sample", "winner", "row", "column"}) csv += one[name].dump() + ",";
    char distance[32];
    std::snprintf(distance, sizeof distance, "%.9g\n", one["distance"].get<double>());
    csv += distance;
  }
  EXPECT_EQ(csv, output_of({"som", "map", "good.map", "data.csv"}));
}

TEST_F(Conventions, ListsArePrintedAsJson) {
  const Json systems = json_of({"systems"});
  ASSERT_EQ(systems["systems"].size(), 9u);
  EXPECT_EQ(
      systems["systems"][5],
      Json::parse(R"({"name": "texture", "file": "systems/texture.toml", "body": "probes"})"));
  const Json modules = json_of({"modules"})["modules"];
  const Json one = json_of({"modules", "one_hot"});
  EXPECT_EQ(one["type"], "one_hot");
  EXPECT_NE(std::find(modules.begin(), modules.end(), one), modules.end());
  const Json explained = json_of({"run", "texture_fabricslide", "--explain"});
  EXPECT_EQ(explained["modules"].back()["type"], "som");
  EXPECT_GT(explained["learned_memory"], 0);
}

TEST_F(Conventions, OwnFilesAreFoundByNameAndByPathFromAnywhere) {
  for (const char* name : {"icub_joints", "studies/icub_joints.toml"}) {
    SCOPED_TRACE(name);
    EXPECT_NE(output_of({"run", name, "--explain"}).find("joints"), std::string::npos);
    EXPECT_EQ(output_of({"systems", name}), std::string(find_own_file("icub_joints").value().text));
  }
  expect_refused(2, {{{"systems", "textur"}, {"unknown system 'textur'", "texture"}},
                     {{"systems", "texture", "--json"}, {"--json: the file is TOML"}},
                     {{"modules", "--markdown", "--json"}, {"--markdown", "omit --json"}}});
  // A file of that name in the folder is the one that is meant.
  write("texture", "not a study");
  EXPECT_EQ(run({"run", "texture", "--explain"}).exit_code, 2);
}

TEST_F(Conventions, TheManualPageNamesEveryCommand) {
  write("somato.1", output_of({"reference", "--man"}));
  const ProgramRun man = run_other({"groff", "-man", "-ww", "-P-cbou", "-Tascii", "somato.1"});
  EXPECT_EQ(man.exit_code, 0);
  EXPECT_EQ(man.err, "");
  for (const char* text : {"somato som train DATA", "--radius-start VALUE", "EXIT STATUS"}) {
    EXPECT_NE(man.out.find(text), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace somato
