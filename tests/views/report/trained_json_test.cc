#include "views/report/trained_json.h"

#include <gtest/gtest.h>

#include <set>

#include "base/support/json_schema.h"
#include "systems/model/learned_parts.h"
#include "systems/support/systems.h"
#include "views/support/unpacked_json.h"

namespace somato {
namespace {

using detail::receptive_fields_json;
using testing::build;
using testing::channels;
using testing::hand_recording;
using testing::module;
using Json = nlohmann::ordered_json;

System felt(const std::string& settings) {
  const Recording recording = hand_recording(3, 2);
  return testing::trained(
      build(channels({"joints", "touch", "wrist"}) +
                module("code", "one_hot", "input = 'joints'\nlow = 0\nhigh = 1\nelements = 30") +
                module("felt", "t_mpsom", settings + "\niterations = 5"),
            recording),
      recording, 3);
}

TEST(ReceptiveFields, AreArborTimesWeightOfNeuronsOfAllColumns) {
  const System system = felt("inputs = ['code', 'touch']\nshape = [46, 22]");
  std::vector<std::string> missing;
  const Json fields = receptive_fields_json(system, missing);
  ASSERT_EQ(fields.size(), 2U);
  EXPECT_TRUE(missing.empty());
  EXPECT_TRUE(
      testing::fits_schema(fields, "report.json#/$defs/TrainedData/properties/receptive_fields"));
  const auto map = t_mpsom_of(system, *system.find("felt"));
  for (std::size_t input = 0; input < 2; ++input) {
    const Json& field = fields[input];
    const auto neurons = field["neurons"].get<std::vector<std::size_t>>();
    const std::size_t elements = field["elements"];
    EXPECT_EQ(elements, input == 0 ? 90U : 4U);
    EXPECT_LE(neurons.size() * elements, 20000U);
    EXPECT_GE(neurons.size() * elements, input == 0 ? 10000U : 1012U * 4U);
    std::set<std::size_t> columns;
    for (const std::size_t neuron : neurons) columns.insert(neuron % 22);
    EXPECT_EQ(columns.size(), 22U);
    const std::vector<double> weights = testing::unpacked(field["weights"]);
    ASSERT_EQ(weights.size(), neurons.size() * elements);
    const double range = field["weights"]["high"].get<double>();
    for (std::size_t i = 0; i < neurons.size(); i += 37) {
      for (std::size_t k = 0; k < elements; ++k) {
        const double expected =
            double{map->weights(input)(neurons[i], k)} * double{map->arbor(input)(neurons[i], k)};
        EXPECT_NEAR(weights[i * elements + k], expected, 0.51 / 65534.0 * range + 1e-6 * range);
      }
    }
  }
}

TEST(ReceptiveFields, OfOtherThanTwoAxesAreLeftOutInWords) {
  const System system = felt("inputs = ['code', 'touch', 'wrist']\nshape = [3, 3, 3]");
  std::vector<std::string> missing;
  EXPECT_EQ(receptive_fields_json(system, missing), Json::array());
  ASSERT_EQ(missing.size(), 1U);
  EXPECT_NE(missing[0].find("'felt'"), std::string::npos);
}

}  // namespace
}  // namespace somato
