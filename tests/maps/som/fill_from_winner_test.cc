#include "maps/som/fill_from_winner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();

Som map_of(const Matrix<float>& weights, SomParameters parameters = {}) {
  parameters.rows = 1;
  parameters.columns = weights.rows();
  return Som(resolve(parameters, 10, weights.columns()).value(), weights);
}

std::vector<float> row_of(const Samples& samples, std::size_t i) {
  return {samples[i].values.begin(), samples[i].values.end()};
}

// By hand: (2, ?) is 1 from the second neuron and 2 from the first; (?, 9) is nearest to the first.
TEST(FillFromWinner, TakesTheWeightsOfTheWinnerOverWhatIsKnown) {
  const Som som = map_of(Matrix<float>(3, 2, {0, 10, 3, 20, 9, 30}));
  const Samples filled =
      filled_from_winners(som, Samples(Matrix<float>(3, 2, {2, kMissing, kMissing, 9, 7, 7})));
  EXPECT_EQ(row_of(filled, 0), (std::vector<float>{2, 20}));
  EXPECT_EQ(row_of(filled, 1), (std::vector<float>{0, 9}));
  EXPECT_EQ(row_of(filled, 2), (std::vector<float>{7, 7}));
  EXPECT_THROW((void)filled_from_winners(som, Samples(Matrix<float>(1, 3))), InvalidArgument);
}

TEST(FillFromWinner, TakesTheFirstNeuronInATie) {
  const Som som = map_of(Matrix<float>(3, 2, {5, 1, 1, 2, 1, 3}));
  const Samples filled = filled_from_winners(som, Samples(Matrix<float>(1, 2, {1, kMissing})));
  EXPECT_EQ(row_of(filled, 0), (std::vector<float>{1, 2}));
}

// The winner of the filled sample is the neuron that is nearest by the known elements, at the
// distance that these have.
TEST(FillFromWinner, KeepsWinnerAndDistance) {
  Random random(2);
  constexpr Similarity kByElements[] = {Similarity::kEuclidean, Similarity::kManhattan,
                                        Similarity::kChebyshev};
  for (int repeat = 0; repeat < 300; ++repeat) {
    SomParameters parameters;
    parameters.similarity = kByElements[repeat % 3];
    Matrix<float> weights(6, 5);
    for (float& weight : weights.values()) weight = static_cast<float>(random.normal());
    const Som som = map_of(weights, parameters);
    std::vector<float> sample(5);
    for (float& value : sample) {
      value = random.below(2) ? kMissing : static_cast<float>(random.normal());
    }
    sample[random.below(5)] = 0.5F;
    double least = std::numeric_limits<double>::infinity();
    std::size_t winner = 0;
    for (std::size_t n = 0; n < 6; ++n) {
      double sum = 0.0;
      for (std::size_t d = 0; d < 5; ++d) {
        if (std::isnan(sample[d])) continue;
        const double apart = std::fabs(double{sample[d]} - double{weights(n, d)});
        sum = repeat % 3 == 0 ? sum + apart * apart
                              : (repeat % 3 == 1 ? sum + apart : std::max(sum, apart));
      }
      if (sum < least) winner = n;
      least = std::min(least, sum);
    }
    const Samples filled = filled_from_winners(som, Samples(Matrix<float>(1, 5, sample)));
    SomWorkspace workspace;
    ASSERT_EQ(som.winner(filled[0], workspace), winner);
    ASSERT_NEAR(som.distance(filled[0], winner, workspace),
                repeat % 3 == 0 ? std::sqrt(least) : least, 1e-12);
  }
}

TEST(FillFromWinner, IsForDistancesOverElementsOfInputsAsTheyAre) {
  const Matrix<float> weights(2, 2, {1, 0, 0, 1});
  EXPECT_TRUE(check_takes_incomplete(map_of(weights)));
  SomParameters parameters;
  parameters.normalize_input = true;
  EXPECT_EQ(check_takes_incomplete(map_of(weights, parameters)).error().kind, ErrorKind::kUsage);
  parameters = {};
  for (const Similarity similarity : {Similarity::kDotProduct, Similarity::kCosine}) {
    parameters.similarity = similarity;
    EXPECT_EQ(check_takes_incomplete(map_of(weights, parameters)).error().kind, ErrorKind::kUsage);
  }
}

}  // namespace
}  // namespace somato
