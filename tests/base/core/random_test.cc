#include "somato/core/random.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "somato/core/check.h"

namespace somato {
namespace {

using Words = std::array<std::uint32_t, 4>;

// The known answers that the authors of Philox publish with their implementation, Random123.
TEST(Philox, GivesThePublishedAnswers) {
  EXPECT_EQ(philox4x32({0, 0, 0, 0}, {0, 0}),
            (Words{0x6627E8D5, 0xE169C58D, 0xBC57AC4C, 0x9B00DBD8}));
  EXPECT_EQ(philox4x32({~0U, ~0U, ~0U, ~0U}, {~0U, ~0U}),
            (Words{0x408F276D, 0x41C83B0E, 0xA20BC7C6, 0x6D5451FD}));
  EXPECT_EQ(philox4x32({0x243F6A88, 0x85A308D3, 0x13198A2E, 0x03707344}, {0xA4093822, 0x299F31D0}),
            (Words{0xD16CFE09, 0x94FDCCEB, 0x5001E420, 0x24126EA1}));
}

struct Moments {
  double mean = 0.0;
  double variance = 0.0;
  double third = 0.0;   // about the mean
  double fourth = 0.0;  // about the mean
};

template <typename Draw>
Moments moments_of(int count, const Draw& draw) {
  std::vector<double> values;
  Moments moments;
  for (int i = 0; i < count; ++i) {
    values.push_back(draw());
    moments.mean += values.back() / count;
  }
  for (const double value : values) {
    const double distance = value - moments.mean;
    moments.variance += distance * distance / count;
    moments.third += distance * distance * distance / count;
    moments.fourth += distance * distance * distance * distance / count;
  }
  return moments;
}

constexpr int kDraws = 200000;

// Bounds are five standard errors of a correct generator.
TEST(Random, HasTheMomentsOfTheUniformDistribution) {
  Random random(21);
  const Moments moments = moments_of(kDraws, [&] { return random.uniform(); });
  EXPECT_NEAR(moments.mean, 0.5, 5 * std::sqrt(1.0 / 12 / kDraws));
  EXPECT_NEAR(moments.variance, 1.0 / 12, 5 * std::sqrt(1.0 / 180 / kDraws));
}

TEST(Random, HasTheMomentsOfTheNormalDistribution) {
  Random random(22);
  const Moments moments = moments_of(kDraws, [&] { return random.normal(); });
  EXPECT_NEAR(moments.mean, 0.0, 5 * std::sqrt(1.0 / kDraws));
  EXPECT_NEAR(moments.variance, 1.0, 5 * std::sqrt(2.0 / kDraws));
  EXPECT_NEAR(moments.third, 0.0, 5 * std::sqrt(15.0 / kDraws));
  EXPECT_NEAR(moments.fourth, 3.0, 5 * std::sqrt(96.0 / kDraws));
}

TEST(Random, DrawsNormalNumbersThatDoNotDependOnTheOneBefore) {
  Random random(23);
  double product = 0.0;
  for (int i = 0; i < kDraws; ++i) product += random.normal() * random.normal() / kDraws;
  EXPECT_NEAR(product, 0.0, 5 * std::sqrt(1.0 / kDraws));
}

TEST(Random, StaysBelowOneAndNotBelowZero) {
  Random random(24);
  for (int i = 0; i < kDraws; ++i) {
    const double uniform = random.uniform();
    ASSERT_GE(uniform, 0.0);
    ASSERT_LT(uniform, 1.0);
    ASSERT_EQ(std::ldexp(uniform, 53), std::floor(std::ldexp(uniform, 53)));
  }
}

// Chi-square with bound-1 degrees of freedom; its mean and variance are bound-1 and 2(bound-1).
double chi_square(Random& random, std::uint64_t bound, std::uint64_t width) {
  std::vector<double> hits(bound);
  for (int i = 0; i < kDraws; ++i) ++hits[random.below(bound * width) / width];
  const double expected = static_cast<double>(kDraws) / static_cast<double>(bound);
  double sum = 0.0;
  for (const double hit : hits) sum += (hit - expected) * (hit - expected) / expected;
  return sum;
}

TEST(Random, DrawsBelowABoundWithoutBias) {
  Random random(25);
  for (const std::uint64_t bound : {2U, 3U, 7U, 30U, 1000U}) {
    const double freedom = static_cast<double>(bound - 1);
    EXPECT_NEAR(chi_square(random, bound, 1), freedom, 6 * std::sqrt(2 * freedom)) << bound;
  }
  // Three quarters of 2^64 in three parts: a plain remainder would hit the first twice as often.
  EXPECT_NEAR(chi_square(random, 3, std::uint64_t{1} << 62), 2, 6 * std::sqrt(4.0));
}

TEST(Random, GivesEachOrderWithTheSameProbability) {
  constexpr int kOrders = 60000;
  Random random(27);
  std::map<std::vector<std::size_t>, int> counts;
  for (int i = 0; i < kOrders; ++i) ++counts[random_order(3, random)];
  ASSERT_EQ(counts.size(), 6U);
  double sum = 0.0;
  for (const auto& [order, count] : counts) {
    EXPECT_EQ(std::set(order.begin(), order.end()), (std::set<std::size_t>{0, 1, 2}));
    sum += (count - kOrders / 6.0) * (count - kOrders / 6.0) / (kOrders / 6.0);
  }
  EXPECT_NEAR(sum, 5, 6 * std::sqrt(2 * 5.0));
  EXPECT_EQ(random_order(0, random), std::vector<std::size_t>{});
}

TEST(Random, DrawsOnlyZeroBelowOneAndRefusesZero) {
  Random random(26);
  EXPECT_EQ(random.below(1), 0U);
  EXPECT_THROW(random.below(0), InvalidArgument);
}

TEST(Random, RepeatsItselfForOneSeedAndStreamOnly) {
  std::set<std::uint32_t> first_words;
  for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{1} << 32}) {
    for (const Stream stream : {Stream::kInitialWeights, Stream::kDraws, Stream::kUser}) {
      Random once(seed, stream);
      Random again(seed, stream);
      first_words.insert(once.next());
      again.next();
      for (int i = 0; i < 100; ++i) ASSERT_EQ(once.next(), again.next());
    }
  }
  EXPECT_EQ(first_words.size(), 9U);
}

TEST(Random, StartsWithTheWordsOfPhiloxInOrder) {
  Random random(0x0123456789ABCDEF, Stream::kNoise);
  for (std::uint32_t block = 0; block < 3; ++block) {
    for (const std::uint32_t word : philox4x32({block, 0, 3, 0}, {0x89ABCDEF, 0x01234567})) {
      EXPECT_EQ(random.next(), word);
    }
  }
}

TEST(Random, TakesTwoWordsForANumberTheLowerFirst) {
  Random words(5, Stream::kDraws);
  Random random(5, Stream::kDraws);
  for (int i = 0; i < 20; ++i) {
    const std::uint64_t low = words.next();
    const std::uint64_t high = words.next();
    EXPECT_EQ(random.uniform(), static_cast<double>((low + high * 0x100000000) >> 11) * 0x1p-53);
  }
}

TEST(UniformAt, IsUniformAndDifferentAtEveryPlace) {
  std::set<float> seen;
  double sum = 0.0;
  for (std::uint32_t row = 0; row < 100; ++row) {
    for (std::uint32_t column = 0; column < 100; ++column) {
      const float value = uniform_at(5, Stream::kInitialWeights, row, column);
      ASSERT_GE(value, 0.0F);
      ASSERT_LT(value, 1.0F);
      ASSERT_EQ(value, uniform_at(5, Stream::kInitialWeights, row, column));
      seen.insert(value);
      sum += double{value};
    }
  }
  EXPECT_NEAR(sum / 10000, 0.5, 5 * std::sqrt(1.0 / 12 / 10000));
  EXPECT_GT(seen.size(), 9980U);  // 3 of 10000 numbers of 24 bits meet by chance
}

TEST(UniformAt, DependsOnSeedAndStream) {
  const float value = uniform_at(5, Stream::kInitialWeights, 3, 4);
  EXPECT_NE(value, uniform_at(6, Stream::kInitialWeights, 3, 4));
  EXPECT_NE(value, uniform_at(5 + (std::uint64_t{1} << 32), Stream::kInitialWeights, 3, 4));
  EXPECT_NE(value, uniform_at(5, Stream::kNoise, 3, 4));
  EXPECT_NE(value, uniform_at(5, Stream::kInitialWeights, 4, 3));
}

TEST(UniformRow, HoldsTheNumbersOfUniformAt) {
  for (const std::size_t size : {1U, 3U, 4U, 9U, 64U}) {
    std::vector<float> row(size);
    uniform_row(5, Stream::kInitialWeights, 7, row);
    for (std::uint32_t column = 0; column < size; ++column) {
      EXPECT_EQ(row[column], uniform_at(5, Stream::kInitialWeights, 7, column)) << size;
    }
  }
}

TEST(UniformRow, HoldsTheNumbersOfTheRequestedColumns) {
  const std::vector<std::uint32_t> columns{0, 2, 3, 4, 9, 13, 400, 401, 4'000'000'003U};
  std::vector<float> row(columns.size());
  uniform_row(5, Stream::kInitialWeights, 7, columns, row);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    EXPECT_EQ(row[i], uniform_at(5, Stream::kInitialWeights, 7, columns[i])) << columns[i];
  }
  EXPECT_THROW(uniform_row(5, Stream::kUser, 7, columns, std::span(row).first(3)), InvalidArgument);
}

}  // namespace
}  // namespace somato
