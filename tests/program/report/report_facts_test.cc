#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "bodies/objects/built_in_things.h"
#include "program/support/program_test.h"

namespace somato {
namespace {

using Json = nlohmann::json;

const std::set<std::string> kNames{"felt", "sponge", "boule", "block_1"};

// The names of things that a user has, which are also names of the simulator's tables, and three
// joints.
std::string foreign_table() {
  std::string table = "trial,object,j1,j2,j3\n";
  int trial = 0;
  for (int round = 0; round < 3; ++round) {
    for (const std::string& name : kNames) {
      ++trial;
      for (int frame = 0; frame < 3; ++frame) {
        const int value = static_cast<int>(name.size()) * 10 + round;
        table += fmt::format("{},{},{},{},{}\n", trial, name, value, frame, value - frame);
      }
    }
  }
  return table;
}

// Every string of the simulator's tables that describes a thing.
std::set<std::string> simulators_words() {
  std::set<std::string> words;
  for (const auto& [shape, name] : Choices<Shape>::all()) words.insert(name);
  for (const auto& [hardness, name] : Choices<Hardness>::all()) words.insert(name);
  for (const Material& material : declared_materials()) words.insert(material.name);
  for (const Object& object : built_in_objects()) words.insert(object.name);
  return words;
}

// The words of all texts in the data, without the names of its fields.
void add_words(const Json& data, std::set<std::string>& words) {
  if (data.is_string()) {
    std::string text = data.get<std::string>();
    for (char& c : text) c = std::isalnum(static_cast<unsigned char>(c)) || c == '_' ? c : ' ';
    std::istringstream split(text);
    for (std::string word; split >> word;) words.insert(word);
  } else if (data.is_structured()) {
    for (const Json& one : data) add_words(one, words);
  }
}

class ReportFacts : public ProgramTest {
 protected:
  void SetUp() override {
    if (has_no_pages(run({"report", "none.json", "-o", "x"}))) {
      GTEST_SKIP() << "the program was built without npm, so it has no page to fill";
    }
    write("grasps.csv", foreign_table());
    output_of({"import", "csv", "grasps.csv", "--channels", "joints=j1+j2+j3", "--labels", "object",
               "--exploration", "trial", "-o", "grasps.mcap"});
    write("study.toml",
          "[study]\nname = 'grasps'\nlabel = 'object'\nprotocols = ['k_folds']\nfolds = 3\n"
          "seeds = 2\n[module.joints]\ntype = 'channel'\nchannel = 'joints'\n"
          "[module.closed]\ntype = 'last'\ninput = 'joints'\n[module.map]\ntype = 'som'\n"
          "input = 'closed'\nrows = 4\ncolumns = 4\niterations = 100\n");
    output_of({"run", "study.toml", "--data", "grasps.mcap", "--out", "out"});
  }

  Json system_of(const Words& more = {}) const {
    Words words{"report", "out/results.json", "--data", "grasps.mcap", "-o", "report.html"};
    words.insert(words.end(), more.begin(), more.end());
    output_of(words);
    const std::string text = read("report.html");
    const std::string mark = "id=\"report-data\">";
    const std::size_t begin = text.find(mark) + mark.size();
    return Json::parse(text.substr(begin, text.find("</script>", begin) - begin))["systems"][0];
  }
};

TEST_F(ReportFacts, NothingOfTheSimulatorReachesTheReportOfOtherData) {
  const Json system = system_of();
  std::set<std::string> words;
  add_words(system, words);
  EXPECT_TRUE(words.contains("felt"));
  for (const std::string& word : simulators_words()) {
    if (!kNames.contains(word)) {
      EXPECT_FALSE(words.contains(word)) << word;
    }
  }
  ASSERT_EQ(system["things"].size(), kNames.size());
  for (const Json& thing : system["things"]) {
    for (const char* fact : {"shape", "size", "colour", "mass"}) EXPECT_TRUE(thing[fact].is_null());
    EXPECT_EQ(thing["material"], "");
    EXPECT_EQ(thing["hardness"], "");
  }
}

TEST_F(ReportFacts, TheTableOfTheUserDescribesThings) {
  write("mine.toml",
        "[object]\nfelt = { shape = 'block', width = 40, depth = 30, height = 20, "
        "material = 'cotton' }\n"
        "[material.cotton]\nhardness = 'soft'\ndensity = 200\n");
  const Json things = system_of({"--objects", "mine.toml"})["things"];
  for (const Json& thing : things) {
    const bool is_described = thing["name"] == "felt";
    EXPECT_EQ(thing["size"], is_described ? Json::array({40.0, 30.0, 20.0}) : Json());
    EXPECT_EQ(thing["material"], is_described ? "cotton" : "");
    EXPECT_TRUE(thing["colour"].is_null());
  }
}

}  // namespace
}  // namespace somato
