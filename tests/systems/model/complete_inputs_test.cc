#include "systems/model/complete_inputs.h"

#include <gtest/gtest.h>

#include <limits>

namespace somato {
namespace {

constexpr float kUnknownValue = std::numeric_limits<float>::quiet_NaN();

// Two neurons with the weights 0 1 2 and 3 4 5.
SomModel model_of_two(Similarity similarity = Similarity::kEuclidean) {
  SomParameters parameters;
  parameters.rows = 1;
  parameters.columns = 2;
  parameters.similarity = similarity;
  SomModel model;
  model.som = Som(resolve(parameters, 4, 3).value(), Matrix<float>(2, 3, {0, 1, 2, 3, 4, 5}));
  return model;
}

std::vector<float> completed(const SomModel& model, MissingFill missing, std::vector<float> row) {
  // The order in which arguments are evaluated differs between compilers.
  const std::size_t columns = row.size();
  const Samples samples(Matrix<float>(1, columns, std::move(row)));
  const Samples complete = complete_inputs(model, missing, samples);
  return {complete[0].values.begin(), complete[0].values.end()};
}

TEST(CompleteInputs, AreFilledFromMeansBeforeTheStandardization) {
  SomModel model = model_of_two();
  model.means = {10, 20, 30};
  EXPECT_EQ(completed(model, MissingFill::kMean, {1, kUnknownValue, 3}),
            (std::vector<float>{1, 20, 3}));
  model.standardization = Standardization{{10, 10, 10}, {2, 2, 2}};
  EXPECT_EQ(completed(model, MissingFill::kMean, {12, kUnknownValue, 8}),
            (std::vector<float>{1, 5, -1}));
}

TEST(CompleteInputs, AreFilledFromTheWinnerByTheKnownValues) {
  EXPECT_EQ(completed(model_of_two(), MissingFill::kNearest, {3, kUnknownValue, 6}),
            (std::vector<float>{3, 4, 6}));
  EXPECT_EQ(completed(model_of_two(), MissingFill::kRefuse, {1, 2, 3}),
            (std::vector<float>{1, 2, 3}));
}

TEST(CompleteInputs, NeedMeansOrDistances) {
  EXPECT_TRUE(check_fills(model_of_two(), MissingFill::kRefuse));
  EXPECT_FALSE(check_fills(model_of_two(), MissingFill::kMean));
  EXPECT_TRUE(check_fills(model_of_two(), MissingFill::kNearest));
  EXPECT_FALSE(check_fills(model_of_two(Similarity::kDotProduct), MissingFill::kNearest));
}

}  // namespace
}  // namespace somato
