#include "maps/online/nearest_distances.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/archives/archive.h"
#include "maps/support/growing_problems.h"
#include "somato/core/random.h"

namespace somato {
namespace {

Samples column(std::vector<float> values) {
  const std::size_t count = values.size();
  return Samples(Matrix<float>(count, 1, std::move(values)));
}

double mean_of(const Samples& samples) {
  NearestDistances distances;
  distances.see(samples, Matrix<float>(0, samples.size()));
  return distances.mean();
}

// 0 and 1 are 1 apart, 4 is 3 from 1.
TEST(NearestDistances, IsTheMeanOverTheSamples) {
  EXPECT_EQ(mean_of(column({0, 1, 4})), 5.0 / 3.0);
}

// The nearest that differs: 0 is 1 from 1, twice, 1 is 1 from 0.
TEST(NearestDistances, CopiesHaveNoDistance) {
  EXPECT_EQ(mean_of(column({0, 0, 1})), 1.0);
  EXPECT_EQ(mean_of(column({2, 2, 2})), 0.0);
  EXPECT_EQ(mean_of(column({2})), 0.0);
}

TEST(NearestDistances, IsThatOfPlainLoops) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Samples samples = testing::clustered_samples(40, 3, seed);
    double sum = 0.0;
    for (std::size_t i = 0; i < 40; ++i) {
      double nearest = 1e300;
      for (std::size_t j = 0; j < 40; ++j) {
        if (i == j) continue;
        nearest = std::min(nearest, testing::distance(testing::point_of(samples, i),
                                                      testing::point_of(samples, j)));
      }
      sum += nearest / 40.0;
    }
    EXPECT_NEAR(mean_of(samples), sum, 1e-6 * sum) << seed;
  }
}

// Each set counts with its samples: (1 + 1 + 4 + 4) / 4.
TEST(NearestDistances, IsTheMeanOverAllSetsSoFar) {
  NearestDistances distances;
  const Matrix<float> none(0, 1);
  distances.see(column({0, 1}), none);
  distances.see(column({100, 104}), none);
  EXPECT_EQ(distances.mean(), 2.5);
}

// Single samples are compared with the neurons, until enough distances are known.
TEST(NearestDistances, BeginsWithSingleSamples) {
  NearestDistances distances;
  distances.see(column({3}), Matrix<float>(0, 1));
  EXPECT_EQ(distances.mean(), 0.0);
  for (std::size_t i = 0; i < NearestDistances::kFewDistances; ++i) {
    distances.see(column({5}), Matrix<float>(1, 1, 3.0F));
  }
  EXPECT_EQ(distances.mean(), 2.0);
  distances.see(column({500}), Matrix<float>(1, 1, 3.0F));
  EXPECT_EQ(distances.mean(), 2.0);
}

// Many samples at equal intervals: each is 1 from the next.
TEST(NearestDistances, TakesSomeOfManySamples) {
  std::vector<float> values;
  for (int i = 0; i < 2500; ++i) values.push_back(static_cast<float>(i));
  EXPECT_EQ(mean_of(column(std::move(values))), 1.0);
}

TEST(NearestDistances, IsProportionalToTheSamplesAndIgnoresConstants) {
  Random random(3);
  Matrix<float> rows(12, 2);
  Matrix<float> scaled(12, 3, 5.0F);
  for (std::size_t i = 0; i < 12; ++i) {
    for (std::size_t d = 0; d < 2; ++d) {
      rows(i, d) = static_cast<float>(random.normal());
      scaled(i, d) = 1024.0F * rows(i, d);
    }
  }
  EXPECT_NEAR(mean_of(Samples(scaled)), 1024.0 * mean_of(Samples(rows)), 1e-6);
}

TEST(NearestDistances, IsTheSameAfterItWasSaved) {
  NearestDistances distances;
  distances.see(column({0, 1, 4}), Matrix<float>(0, 1));
  Archive archive("system");
  distances.save(archive, "nearest");
  NearestDistances loaded;
  ASSERT_TRUE(loaded.load(archive, "nearest", "file"));
  EXPECT_EQ(loaded, distances);
}

TEST(NearestDistances, RefusesDamagedNumbers) {
  const auto loads = [](std::vector<double> values) {
    Archive archive("system");
    archive.add("nearest", Array<double>{{values.size()}, values});
    return NearestDistances().load(archive, "nearest", "file").has_value();
  };
  EXPECT_TRUE(loads({0.0, 0.0}));
  EXPECT_TRUE(loads({3.5, 2.0}));
  EXPECT_FALSE(loads({3.5}));
  EXPECT_FALSE(loads({0.0, 2.0}));
  EXPECT_FALSE(loads({3.5, 0.0}));
  EXPECT_FALSE(loads({-1.0, 2.0}));
  EXPECT_FALSE(loads({std::nan(""), 2.0}));
}

}  // namespace
}  // namespace somato
