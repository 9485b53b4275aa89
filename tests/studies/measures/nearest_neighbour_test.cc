#include "studies/measures/nearest_neighbour.h"

#include <gtest/gtest.h>

#include <cmath>

#include "maps/support/random_maps.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

// On a line, so that distances can be seen: samples at 0, 4, 5, 9.
const Samples kLine(Matrix<float>(4, 1, {0, 4, 5, 9}));

TEST(NearestNeighbour, IsTheNearest) {
  EXPECT_EQ(nearest_neighbour(kLine, {0, 2, 3}, 1), 2U);
  EXPECT_EQ(nearest_neighbour(kLine, {0, 1, 2}, 3), 2U);
}

TEST(NearestNeighbour, LooksAtTrainingSamplesOnly) {
  EXPECT_EQ(nearest_neighbour(kLine, {0, 3}, 1), 0U);
  EXPECT_EQ(nearest_neighbour(kLine, {0, 1, 2, 3}, 1), 1U);
}

TEST(NearestNeighbour, IsTheFirstOfEquals) {
  const Samples samples(Matrix<float>(3, 1, {2, 0, 1}));
  EXPECT_EQ(nearest_neighbour(samples, {0, 1}, 2), 0U);
  EXPECT_EQ(nearest_neighbour(samples, {1, 0}, 2), 1U);
}

TEST(NearestNeighbour, NeedsTrainingSamples) {
  EXPECT_THROW((void)nearest_neighbour(kLine, {}, 1), InvalidArgument);
}

// (2, 2) is nearer to the origin by the Euclidean distance, and (3, 0) by the Manhattan distance.
TEST(NearestNeighbour, DependsOnTheDistance) {
  const Samples samples(Matrix<float>(3, 2, {0, 0, 2, 2, 3, 0}));
  EXPECT_EQ(nearest_neighbours(samples, {1, 2}, {0}), (Numbers{1}));
  EXPECT_EQ(nearest_neighbours(samples, {1, 2}, {0}, Similarity::kManhattan), (Numbers{2}));
  EXPECT_THROW((void)nearest_neighbours(samples, {1, 2}, {0}, Similarity::kCosine),
               InvalidArgument);
}

// All distances written out, the least one looked for.
std::size_t oracle(const Samples& samples, const Numbers& training, std::size_t test,
                   Similarity similarity = Similarity::kEuclidean) {
  std::vector<std::vector<double>> rows;
  for (std::size_t i = 0; i < samples.count(); ++i) {
    std::vector<float> row(samples.size());
    write_dense(samples[i], row);
    rows.emplace_back(row.begin(), row.end());
  }
  std::vector<double> distances;
  for (const std::size_t candidate : training) {
    double sum = 0.0;
    for (std::size_t d = 0; d < samples.size(); ++d) {
      const double apart = rows[candidate][d] - rows[test][d];
      sum += similarity == Similarity::kManhattan ? std::abs(apart) : apart * apart;
    }
    distances.push_back(sum);
  }
  const auto least = std::min_element(distances.begin(), distances.end());
  return training[static_cast<std::size_t>(least - distances.begin())];
}

void compare_with_oracle(bool sparse) {
  Random random(sparse ? 1 : 2);
  for (int problem = 0; problem < 200; ++problem) {
    const std::size_t count = 2 + random.below(10);
    const Samples samples = testing::random_samples(count, 1 + random.below(12), sparse, random);
    Numbers numbers(count);
    for (std::size_t i = 0; i < count; ++i) numbers[i] = i;
    for (std::size_t test = 0; test < count; ++test) {
      Numbers training = numbers;
      training.erase(training.begin() + static_cast<std::ptrdiff_t>(test));
      ASSERT_EQ(nearest_neighbour(samples, training, test), oracle(samples, training, test));
      ASSERT_EQ(nearest_neighbours(samples, training, {test}, Similarity::kManhattan).front(),
                oracle(samples, training, test, Similarity::kManhattan));
    }
  }
}

TEST(NearestNeighbour, AgreesWithAllDistancesWrittenOut) {
  compare_with_oracle(false);
}

// So many that a map of the training samples is searched; every third sample is a copy of another.
TEST(NearestNeighbour, OfManyTestsIsThatOfEachTest) {
  Random random(3);
  for (const float scale : {1.0F, 1e20F}) {  // beyond single precision, there is no search
    Matrix<float> rows(150, 6);
    for (float& value : rows.values()) value = scale * static_cast<float>(random.normal());
    for (std::size_t i = 3; i < rows.rows(); i += 3) {
      std::copy_n(rows.row(i - 3).begin(), rows.columns(), rows.row(i).begin());
    }
    const Samples samples(std::move(rows));
    Numbers training;
    Numbers tests;
    for (std::size_t i = 0; i < samples.count(); ++i) (i % 2 == 0 ? training : tests).push_back(i);
    for (const Similarity similarity : {Similarity::kEuclidean, Similarity::kManhattan}) {
      const Numbers nearest = nearest_neighbours(samples, training, tests, similarity);
      for (std::size_t i = 0; i < tests.size(); ++i) {
        EXPECT_EQ(nearest[i], oracle(samples, training, tests[i], similarity)) << i;
      }
    }
  }
}

TEST(NearestNeighbour, AgreesOnSparseSamples) {
  compare_with_oracle(true);
}

}  // namespace
}  // namespace somato
