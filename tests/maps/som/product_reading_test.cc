#include "maps/som/product_reading.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "maps/support/random_maps.h"
#include "maps/support/saved_maps.h"

namespace somato {
namespace {

// Three neurons, their products with an input of squared length 4, and their squared lengths.
constexpr std::array kProducts{1.0, 3.0, 3.0};
constexpr std::array kSquaredLengths{1.0, 5.0, 5.0};

ProductReading by_hand(Similarity similarity, double scale = 1.0) {
  return {similarity, kProducts, kSquaredLengths, 4.0 * scale * scale, scale};
}

TEST(ProductReading, MeasuresDistancesByProducts) {
  const ProductReading reading = by_hand(Similarity::kEuclidean);
  EXPECT_DOUBLE_EQ(distance(reading, 0), std::sqrt(3.0));  // 4 - 2 + 1
  EXPECT_DOUBLE_EQ(distance(reading, 1), std::sqrt(3.0));  // 4 - 6 + 5
  std::vector<float> found(3);
  similarities(reading, found);
  EXPECT_FLOAT_EQ(found[1], 1.0F / (1.0F + std::sqrt(3.0F)));
  similarities(by_hand(Similarity::kDotProduct, 0.5), found);
  EXPECT_EQ(found, (std::vector<float>{0.5F, 1.5F, 1.5F}));
}

TEST(ProductReading, GivesTiesToTheFirstNeuron) {
  const Winners all = winners(by_hand(Similarity::kEuclidean));
  EXPECT_EQ(all.first, 0U);
  EXPECT_EQ(all.second, 1U);
  const Winners by_product = winners(by_hand(Similarity::kDotProduct));
  EXPECT_EQ(by_product.first, 1U);
  EXPECT_EQ(by_product.second, 2U);
  EXPECT_EQ(winner_among(std::array<std::size_t, 2>{2, 1}, by_hand(Similarity::kDotProduct)), 2U);
}

TEST(ProductReading, ScalesTheInput) {
  // |x/2 - w|^2 = 1 - 1 + 1 and 1 - 3 + 5
  const ProductReading half = by_hand(Similarity::kEuclidean, 0.5);
  EXPECT_DOUBLE_EQ(distance(half, 0), 1.0);
  EXPECT_DOUBLE_EQ(distance(half, 1), std::sqrt(3.0));
  EXPECT_EQ(winners(half).first, 0U);
}

TEST(ProductReading, IsNeverBelowADistanceOfZero) {
  const std::array products{1.0};
  const std::array squared_lengths{1.0};
  const ProductReading reading{Similarity::kEuclidean, products, squared_lengths, 1.0 - 1e-15, 1.0};
  EXPECT_EQ(distance(reading, 0), 0.0);
}

TEST(ProductReading, AnswersAsTheMapItself) {
  Random random(61);
  for (const testing::Variant& variant : testing::variants_by_products()) {
    const Som som = testing::trained_som(variant, 5, random);
    const Samples samples = testing::random_samples(20, 5, false, random);
    SomWorkspace workspace;
    std::vector<double> squared_lengths;
    Matrix<float> rows = som.weights().to_matrix();
    for (std::size_t n = 0; n < som.neurons(); ++n) {
      const SignalView row = SignalView::dense(rows.row(n));
      squared_lengths.push_back(inner_product(row, row));
    }
    for (std::size_t i = 0; i < samples.count(); ++i) {
      std::vector<float> x(samples[i].values.begin(), samples[i].values.end());
      if (*som.parameters().normalize_input) normalize_length(x);
      const SignalView input = SignalView::dense(x);
      std::vector<double> products;
      for (std::size_t n = 0; n < som.neurons(); ++n) {
        products.push_back(inner_product(input, SignalView::dense(rows.row(n))));
      }
      const ProductReading reading{som.parameters().similarity, products, squared_lengths,
                                   inner_product(input, input)};
      std::vector<float> expected(som.neurons());
      std::vector<float> found(som.neurons());
      som.activity(samples[i], workspace, expected);
      activity(reading, som.parameters(), found);
      for (std::size_t n = 0; n < som.neurons(); ++n) {
        EXPECT_NEAR(found[n], expected[n], 1e-4);
        EXPECT_NEAR(distance(reading, n), som.distance(samples[i], n, workspace), 1e-5);
      }
      const std::size_t winner = winners(reading).first;
      const std::size_t theirs = som.winner(samples[i], workspace);
      EXPECT_NEAR(score(reading, winner), score(reading, theirs), 1e-6);
      EXPECT_EQ(som.winner(samples[i].values), theirs);
    }
  }
}

}  // namespace
}  // namespace somato
