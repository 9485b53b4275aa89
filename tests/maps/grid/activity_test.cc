#include "maps/grid/activity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/core/elementary.h"
#include "base/support/instruction_sets.h"
#include "somato/core/random.h"

namespace somato {
namespace {

double obvious_power(double base, double exponent) {
  const bool whole = exponent >= 1.0 && exponent <= 64.0 && exponent == std::floor(exponent);
  if (!whole) return power(base, exponent);
  double result = 1.0;
  for (auto left = static_cast<unsigned>(exponent); left > 0; left /= 2) {
    if (left % 2 == 1) result *= base;
    base *= base;
  }
  return result;
}

// The definition, value by value and in the order of the neurons.
std::vector<float> obvious_activity(const SomParameters& p, std::vector<float> similarities) {
  for (float& value : similarities) value = std::max(value, 0.0F);
  const double largest = *std::max_element(similarities.begin(), similarities.end());
  const bool is_power = p.softmax == Softmax::kPower;
  if (is_power && largest == 0.0) return similarities;
  std::vector<float> activity;
  double sum = 0.0;
  for (const float value : similarities) {
    const double term = is_power ? obvious_power(double{value} / largest, p.softmax_exponent)
                                 : exponential(p.softmax_exponent * (double{value} - largest));
    activity.push_back(static_cast<float>(term));
    sum += term;
  }
  if (p.activity_norm == ActivityNorm::kMaximum) return activity;
  for (float& value : activity) value = static_cast<float>(double{value} / sum);
  return activity;
}

template <typename Work>
void for_each_softmax(const Work& work) {
  SomParameters p;
  for (const Softmax softmax : {Softmax::kPower, Softmax::kExponential}) {
    for (const ActivityNorm norm : {ActivityNorm::kMaximum, ActivityNorm::kSum}) {
      for (const double exponent : {1.0, 2.5, 10.0, 63.0, 64.0, 65.0}) {
        p.softmax = softmax;
        p.activity_norm = norm;
        p.softmax_exponent = exponent;
        work(p);
      }
    }
  }
}

// More neurons than are summed at once, and fewer than a cache line.
TEST(Activity, IsThatOfTheDefinitionBitByBit) {
  testing::for_each_instruction_set([](InstructionSet) {
    Random random(2);
    for_each_softmax([&](const SomParameters& p) {
      for (const std::size_t neurons : {1U, 15U, 16U, 17U, 256U, 700U}) {
        std::vector<float> values(neurons);
        for (float& value : values) value = static_cast<float>(random.normal());
        const std::vector<float> expected = obvious_activity(p, values);
        activity_of_similarities(p, values);
        EXPECT_EQ(values, expected) << neurons << " neurons, exponent " << p.softmax_exponent;
      }
    });
  });
}

TEST(Activity, OfNoSimilarityIsZero) {
  SomParameters p;
  std::vector<float> values{-1.0F, 0.0F, -0.5F};
  activity_of_similarities(p, values);
  EXPECT_EQ(values, std::vector<float>(3, 0.0F));
}

TEST(Activity, SimilaritiesOfSquaresAreThoseOfEachSquare) {
  AlignedVector<float> values(32);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = 0.37F * static_cast<float>(i * i);
  const AlignedVector<float> squares = values;
  similarities_of_squares(values, 0.25);
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(values[i], similarity_at(double{squares[i]} + 0.25));
  }
}

}  // namespace
}  // namespace somato
