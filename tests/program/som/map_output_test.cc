// The output of `som map`, row by row and number by number.

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "program/support/program_test.h"
#include "somato/files/npy.h"
#include "somato/graph/som_model.h"

namespace somato {
namespace {

// Rows on a line, so that most of a map has no sample of a label.
constexpr std::size_t kManyRows = 70000;  // more than are read at once

float value_of(std::size_t row) {
  return static_cast<float>(row * 7919 % 10007) / 1000.0F;
}

class MapOutput : public ProgramTest {
 protected:
  void SetUp() override {
    Matrix<float> rows(kManyRows, 2);
    for (std::size_t i = 0; i < kManyRows; ++i) {
      rows(i, 0) = value_of(i);
      rows(i, 1) = value_of(i) * value_of(i) / 10.0F;
    }
    ASSERT_TRUE(write_npy(path("many.npy"), rows));
    std::string few;
    for (std::size_t i = 0; i < 40; ++i) {
      few += fmt::format("{},{},{}\n", rows(i, 0), rows(i, 1),
                         rows(i, 0) < 5.0F ? "low" : "\"a \"\"high\"\", one\"");
    }
    write("few.csv", few);
    output_of({"som", "train", "few.csv", "--label-column", "3", "-o", "a.map", "--rows", "6",
               "--columns", "8", "--iterations", "500"});
    rows_ = std::move(rows);
  }

  // The first 40 rows one after the other, by plain loops.
  std::string expected_line(const SomModel& model, std::size_t sample) const {
    std::optional<std::size_t> winner;
    std::optional<std::size_t> named;
    for (std::size_t neuron = 0; neuron < model.som.neurons(); ++neuron) {
      const double distance = distance_of(model, sample, neuron);
      if (!winner || distance < distance_of(model, sample, *winner)) winner = neuron;
      if (!model.labels[neuron]) continue;
      if (!named || distance < distance_of(model, sample, *named)) named = neuron;
    }
    unnamed_winners_ += model.labels[*winner] ? 0 : 1;
    const std::string& name = model.classes[*model.labels[*named]];
    return fmt::format("{},{},{},{},{:.9g},{}", sample + 1, *winner, *winner / 8, *winner % 8,
                       distance_of(model, sample, *winner),
                       name == "low" ? name : "\"a \"\"high\"\", one\"");
  }

  double distance_of(const SomModel& model, std::size_t sample, std::size_t neuron) const {
    const double x = double{rows_(sample, 0)} - double{model.som.weight(neuron, 0)};
    const double y = double{rows_(sample, 1)} - double{model.som.weight(neuron, 1)};
    return std::sqrt(std::fma(y, y, x * x));
  }

  Matrix<float> rows_;
  mutable std::size_t unnamed_winners_ = 0;
};

TEST_F(MapOutput, EveryLineIsThatOfItsRowForAnyNumberOfThreads) {
  const std::string text = output_of({"som", "map", "a.map", "many.npy", "--threads", "1"});
  EXPECT_EQ(output_of({"som", "map", "a.map", "many.npy", "--threads", "3"}), text);
  const SomModel model = load_som_model(path("a.map")).value();
  std::istringstream lines(text);
  std::string line;
  ASSERT_TRUE(std::getline(lines, line));
  EXPECT_EQ(line, "sample,winner,row,column,distance,label");
  std::size_t sample = 0;
  for (; std::getline(lines, line); ++sample) {
    if (sample % 97 == 0 || sample > kManyRows - 3 || (sample > 65530 && sample < 65540)) {
      ASSERT_EQ(line, expected_line(model, sample));
    }
  }
  EXPECT_EQ(sample, kManyRows);
  EXPECT_GT(unnamed_winners_, 10U);
}

TEST_F(MapOutput, JsonHasTheSameNumbers) {
  const std::string csv = output_of({"som", "map", "a.map", "few.csv", "--label-column", "3"});
  const auto json = nlohmann::ordered_json::parse(
      output_of({"som", "map", "a.map", "few.csv", "--label-column", "3", "--json"}));
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  ASSERT_EQ(json.size(), 40U);
  for (const auto& row : json) {
    ASSERT_TRUE(std::getline(lines, line));
    const std::string label = row["label"] == "low" ? "low" : "\"a \"\"high\"\", one\"";
    EXPECT_EQ(fmt::format("{},{},{},{},{:.9g},{}", row["sample"].get<std::size_t>(),
                          row["winner"].get<std::size_t>(), row["row"].get<std::size_t>(),
                          row["column"].get<std::size_t>(), row["distance"].get<double>(), label),
              line);
  }
}

TEST_F(MapOutput, RefusesThreadsThatAreNoNumber) {
  expect_refused(2, {"som", "map", "a.map", "few.csv", "--threads", "none"}, {"--threads"});
}

}  // namespace
}  // namespace somato
