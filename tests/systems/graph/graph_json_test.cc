#include "systems/graph/graph_json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

#include "base/support/json_schema.h"
#include "systems/support/systems.h"

namespace somato::detail {
namespace {

using Json = nlohmann::ordered_json;

System small_system() {
  const std::string text = testing::channels({"height", "joints"}) +
                           testing::module("rest", "last", "input = 'joints'") +
                           testing::module("map", "som", "input = 'rest'\nrows = 2\ncolumns = 3");
  return testing::build(text, testing::hand_recording(2, 1));
}

Json graph() {
  return graph_json(small_system(), "map", [](std::size_t module) { return Json(module); });
}

TEST(GraphJson, DescribesInputsAndOutputOfAModule) {
  const Json modules = graph()["modules"];
  ASSERT_EQ(modules.size(), 4U);
  EXPECT_EQ(modules[1]["channel"], "joints");
  EXPECT_EQ(modules[1]["shape"], (Json{3}));
  EXPECT_EQ(modules[2]["inputs"][0]["module"], "joints");
  EXPECT_EQ(modules[3]["type"], "som");
  EXPECT_EQ(modules[3]["parameters"], 3);
  EXPECT_EQ(modules[3]["learns"], true);
}

// Two words, one for each: the pages know no other.
TEST(GraphJson, DistinguishesFramesAndExplorations) {
  const Json modules = graph()["modules"];
  EXPECT_EQ(modules[1]["rate"], "frame");
  EXPECT_EQ(modules[2]["rate"], "exploration");
}

TEST(GraphJson, GivesASingleNumberNoAxes) {
  EXPECT_EQ(graph()["modules"][0]["shape"], Json::array());
}

TEST(GraphJson, NamesWhatNoPaperGives) {
  const Json names = graph()["modules"][3]["not_given"];
  for (const ParameterInfo& info : small_system().modules()[3].type->parameters) {
    const bool named = std::find(names.begin(), names.end(), info.name) != names.end();
    EXPECT_EQ(named, info.text.find("not given in the paper") != std::string::npos ||
                         info.text.find("Not given in the paper") != std::string::npos)
        << info.name;
  }
}

TEST(GraphJson, DescribesThePhases) {
  const Json phases = graph()["phases"];
  ASSERT_EQ(phases.size(), 1U);
  EXPECT_EQ(phases[0]["learn"], (Json{"map"}));
  EXPECT_EQ(phases[0]["of"], "explorations");
}

TEST(GraphJson, DescribesGridsAndGraphs) {
  EXPECT_EQ(
      grid_json(Grid(2, 3, Lattice::kHexagonal, Topology::kTorus)),
      Json::parse(R"({"rows": 2, "columns": 3, "lattice": "hexagonal", "topology": "torus"})"));
  const auto star = std::make_shared<const NeuronGraph>(
      4, std::vector<NeuronGraph::Edge>{{0, 2}, {1, 2}, {2, 3}});
  const Json json = grid_json(Grid(star));
  EXPECT_EQ(json["rows"], 1);
  EXPECT_EQ(json["columns"], 4);
  EXPECT_EQ(json["edges"], Json::parse("[[0, 2], [1, 2], [2, 3]]"));
  ASSERT_EQ(json["cells"].size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(json["cells"][i], Json({star->cells()[i].row, star->cells()[i].column}));
  }
  EXPECT_TRUE(testing::fits_schema(json, "parts.json#/$defs/GridData"));
}

}  // namespace
}  // namespace somato::detail
