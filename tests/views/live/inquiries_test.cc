#include "views/live/inquiries.h"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "base/support/json_schema.h"
#include "views/live/view_systems.h"

namespace somato::live {
namespace {

using nlohmann::json;

// An answer, checked by its schema.
json checked(const Result<std::string>& answer, const std::string& name) {
  EXPECT_TRUE(
      testing::text_fits_schema(answer.value(), "view.json#/$defs/Answers/properties/" + name));
  return json::parse(answer.value());
}

InquiredSystem inquired_system() {
  auto recording = std::make_shared<const Recording>(testing::hand_recording(6, 2));
  return {testing::trained_model(testing::crossed_system(), *recording), recording};
}

TEST(Inquiries, TellWhatANeuronStandsFor) {
  Inquiries inquiries;
  const InquiredSystem inquired = inquired_system();
  const json answer = checked(inquiries.neuron(inquired, "map", 5), "neuron");
  EXPECT_EQ(answer["map"], "map");
  EXPECT_EQ(answer["neuron"], 5);
  std::map<std::string, std::size_t> elements;
  for (const json& plane : answer["planes"]) {
    ASSERT_EQ(plane["values"].size(), 1U);
    elements[plane["channel"]["name"]] = plane["values"][0].size();
  }
  EXPECT_EQ(elements["joints"], 3U);
  EXPECT_EQ(elements["touch"], 4U);
}

TEST(Inquiries, OrderExplorationsByTheirDistance) {
  Inquiries inquiries;
  const InquiredSystem inquired = inquired_system();
  const System& system = inquired.model->system;
  const Som& som = *som_of(system, *system.find("map"));
  for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
    const json nearest = checked(inquiries.neuron(inquired, "map", neuron), "neuron")["nearest"];
    ASSERT_EQ(nearest.size(), 6U);
    double before = 0.0;
    for (const json& one : nearest) {
      const std::size_t exploration = one["exploration"];
      const Sequence seen = testing::output_of(system, *inquired.recording, "unit", exploration);
      SomWorkspace workspace;
      EXPECT_NEAR(one["distance"], som.distance(seen.values[0], neuron, workspace), 1e-6);
      EXPECT_GE(one["distance"], before);
      before = one["distance"];
    }
  }
}

InquiredSystem with_explorations(InquiredSystem inquired, std::size_t count) {
  Recording recording = *inquired.recording;
  recording.explorations.resize(count);
  inquired.recording = std::make_shared<const Recording>(std::move(recording));
  return inquired;
}

TEST(Inquiries, EvaluateEachExplorationOnce) {
  std::size_t evaluated = 0;
  Inquiries inquiries([&] { return ++evaluated == 0; });
  const InquiredSystem inquired = inquired_system();
  ASSERT_TRUE(inquiries.neuron(with_explorations(inquired, 4), "map", 5));
  EXPECT_EQ(evaluated, 4U);
  const std::string grown = inquiries.neuron(inquired, "map", 5).value();
  EXPECT_EQ(evaluated, 6U);
  EXPECT_EQ(grown, Inquiries().neuron(inquired, "map", 5).value());
}

TEST(Inquiries, EndWhenAllIsOver) {
  std::size_t evaluated = 0;
  Inquiries inquiries([&] { return ++evaluated == 3; });
  const InquiredSystem inquired = inquired_system();
  EXPECT_FALSE(inquiries.neuron(inquired, "map", 5));
  EXPECT_EQ(evaluated, 3U);
  EXPECT_EQ(inquiries.neuron(inquired, "map", 5).value(),
            Inquiries().neuron(inquired, "map", 5).value());
}

// One that does not fit is near to nothing; the others are found all the same.
TEST(Inquiries, LeaveOutWhatDoesNotFit) {
  const InquiredSystem inquired = inquired_system();
  Recording recording = *inquired.recording;
  recording.explorations[2].channels.clear();
  const InquiredSystem broken{inquired.model, std::make_shared<const Recording>(recording)};
  const json answer = checked(Inquiries().neuron(broken, "map", 5), "neuron");
  EXPECT_EQ(answer["nearest"].size(), 5U);
}

TEST(Inquiries, TellWhereATaxelMatters) {
  Inquiries inquiries;
  const InquiredSystem inquired = inquired_system();
  const json answer = checked(inquiries.taxel(inquired, 2), "taxel");
  ASSERT_EQ(answer["maps"]["map"].size(), 12U);
  // The weights of an element of touch, summed over the code that it is crossed with.
  const Som& som = *som_of(inquired.model->system, *inquired.model->system.find("map"));
  double sum = 0.0;
  for (std::size_t code = 0; code < 12; ++code) sum += double{som.weight(7, code * 4 + 2)};
  EXPECT_NEAR(answer["maps"]["map"][7], sum, 1e-6);
}

TEST(Inquiries, RefuseWhatIsNotThere) {
  Inquiries inquiries;
  const InquiredSystem inquired = inquired_system();
  EXPECT_FALSE(inquiries.neuron(inquired, "none", 0));
  EXPECT_FALSE(inquiries.neuron(inquired, "map", 12));
  EXPECT_FALSE(inquiries.taxel(inquired, 4));
}

}  // namespace
}  // namespace somato::live
