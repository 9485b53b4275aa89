#include "somato/maps/t_mpsom.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

using Places = std::vector<std::size_t>;

// The third network of the papers.
TMpsomParameters third() {
  TMpsomParameters parameters;
  parameters.shape = {46, 23};
  parameters.input_sizes = {90, 45};
  return parameters;
}

void expect_refused(const TMpsomParameters& parameters, const std::string& what,
                    const std::string& advice) {
  const Result<void> valid = parameters.validate();
  ASSERT_FALSE(valid) << what;
  EXPECT_EQ(valid.error().kind, ErrorKind::kUsage);
  EXPECT_NE(valid.error().what.find(what), std::string::npos) << valid.error().what;
  EXPECT_NE(valid.error().advice.find(advice), std::string::npos) << valid.error().advice;
}

TEST(TMpsomParameters, AcceptAnAxisAnInputAndSharedAxes) {
  EXPECT_TRUE(third().validate());
  TMpsomParameters three = third();
  three.input_sizes = {90, 45, 10};
  three.input_axes = {0, 1, 0};
  EXPECT_TRUE(three.validate());
  three.shape = {6, 5, 4};
  three.input_axes = {};
  EXPECT_TRUE(three.validate());
  EXPECT_EQ(three.axes(), (Places{0, 1, 2}));
}

TEST(TMpsomParameters, RefuseAGridThatDoesNotGoWithTheInputs) {
  expect_refused(TMpsomParameters{}, "'shape' is empty", "[46, 23]");
  TMpsomParameters p = third();
  p.input_sizes = {};
  expect_refused(p, "'input_sizes' is empty", "[90, 45]");
  p.input_sizes = {90, 45, 10};
  expect_refused(p, "3 inputs do not fit a grid of 2 axes", "'input_axes'");
  p.input_axes = {0, 1};
  expect_refused(p, "'input_axes' lists 2 axes for 3 inputs", "one axis for each");
  p.input_axes = {0, 1, 2};
  expect_refused(p, "axis 2 of a grid of 2 axes", "counted from 0");
  p.input_axes = {1, 1, 1};
  expect_refused(p, "no input is spread along axis 0", "remove that axis");
}

TEST(TMpsomParameters, RefuseNumbersOutOfRange) {
  TMpsomParameters p = third();
  p.shape = {46, 0};
  expect_refused(p, "'shape' must be a whole number, 1 to 4096, not 0", "");
  p = third();
  p.input_sizes = {0, 45};
  expect_refused(p, "'input_sizes' must be", "");
  p = third();
  p.arbor_sigma = 0.0;
  expect_refused(p, "'arbor_sigma' must be a number, above 0", "");
  p = third();
  p.learning_rate_start = 1.5;
  expect_refused(p, "'learning_rate_start' must be a number, 0 to 1", "");
  p = third();
  p.learning_rate_end = 0.2;
  expect_refused(p, "'learning_rate_end' is above 'learning_rate_start'", "must not increase");
  p.learning_rate_schedule = ScheduleShape::kExponential;
  p.learning_rate_end = 0.0;
  expect_refused(p, "learning rate cannot start or end at 0", "linear");
  p = third();
  p.iterations = 0;
  expect_refused(p, "'iterations' must be", "");
}

// Each single number is in range; their product is above 2^64.
TEST(TMpsomParameters, RefuseMoreWeightsThanCanBeCounted) {
  TMpsomParameters p;
  p.shape = {4096, 4096, 4096, 4096, 4096, 4096};
  p.input_sizes = {1, 1, 1, 1, 1, 1};
  expect_refused(p, "more than 4294967296 weights", "fewer neurons");
  p.shape = {4096};
  p.input_sizes = {100'000'000};
  expect_refused(p, "more than 4294967296 weights", "fewer neurons");
  p.input_sizes = {1'048'576};  // 2^12 * 2^20 is the most
  EXPECT_TRUE(p.validate());
  p.input_sizes = {1'048'577};
  expect_refused(p, "more than 4294967296 weights", "fewer neurons");
}

TEST(TMpsomParameters, KnowThePlaceOfEveryNeuron) {
  TMpsomParameters p;
  p.shape = {2, 3, 4};
  EXPECT_EQ(p.neurons(), 24U);
  // 23 = (1 * 3 + 2) * 4 + 3 and 6 = (0 * 3 + 1) * 4 + 2.
  EXPECT_EQ((Places{p.place(23, 0), p.place(23, 1), p.place(23, 2)}), (Places{1, 2, 3}));
  EXPECT_EQ((Places{p.place(6, 0), p.place(6, 1), p.place(6, 2)}), (Places{0, 1, 2}));
}

TEST(TMpsomParameters, AreWrittenAndReadAgain) {
  TMpsomParameters p = third();
  p.input_sizes = {90, 45, 3};
  p.input_axes = {0, 1, 1};
  p.combination = TMpsomCombination::kAdded;
  p.arbor_sigma = 0.7;
  p.input_norm = TMpsomNorm::kNone;
  p.seed = 77;
  EXPECT_NE(parameters_to_toml(p).find("input_axes = [0, 1, 1]\ncombination = \"added\"\n"),
            std::string::npos);
  Table table;
  for (const auto& parameter : TMpsomParameters::declarations().all()) {
    table.entries.push_back({parameter.info.name, "", parameter.read(p)});
  }
  const Result<TMpsomParameters> read = read_parameters<TMpsomParameters>(table);
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, p);
}

TEST(TMpsomParameters, SayWhatThePapersDoNotGive) {
  for (const char* name :
       {"arbor_sigma", "neighbourhood_sigma", "learning_rate_start", "learning_rate_schedule",
        "learning_rate_end", "input_norm", "weight_norm"}) {
    const auto parameter = TMpsomParameters::declarations().find(name);
    ASSERT_TRUE(parameter) << name;
    EXPECT_NE(parameter->info.text.find("ot given in the paper"), std::string::npos) << name;
  }
}

TEST(TMpsomParameters, LetTheLearningRateFallInAStraightLine) {
  TMpsomParameters p = third();
  p.learning_rate_start = 0.5;
  p.learning_rate_end = 0.1;
  p.iterations = 4;
  const double expected[] = {0.5, 0.4, 0.3, 0.2, 0.1, 0.1};
  for (std::uint64_t t = 0; t < 6; ++t) {
    EXPECT_NEAR(p.learning_rate().at(t), expected[t], 1e-15) << t;
  }
}

TEST(TMpsomParameters, DecreaseTheLearningRateAsSet) {
  TMpsomParameters p = third();
  p.learning_rate_schedule = ScheduleShape::kExponential;
  p.learning_rate_start = 0.4;
  p.learning_rate_end = 0.1;
  p.learning_rate_reached_at = 2;
  const double expected[] = {0.4, 0.2, 0.1, 0.1};
  for (std::uint64_t t = 0; t < 4; ++t) {
    EXPECT_NEAR(p.learning_rate().at(t), expected[t], 1e-15) << t;
  }
}

}  // namespace
}  // namespace somato
