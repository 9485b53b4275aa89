#include "base/kernels/batch_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "base/support/instruction_sets.h"
#include "somato/core/matrix.h"
#include "somato/core/random.h"

namespace somato::kernels {
namespace {

using testing::for_each_instruction_set;

constexpr float kInfinite = std::numeric_limits<float>::infinity();

std::vector<float> noise(Random& random, std::size_t count) {
  std::vector<float> values(count);
  for (float& value : values) value = static_cast<float>(2.0 * random.uniform() - 1.0);
  return values;
}

// Integers for neurons (in ScreenedNeurons' order) and one tile of samples, with all their scores.
struct Problem {
  Problem(std::size_t block_count, std::size_t pair_count, std::uint64_t seed)
      : blocks(block_count),
        pairs(pair_count),
        values(blocks * pairs * 2 * kBlockNeurons),
        offsets(blocks * kBlockNeurons),
        rows(kTileSamples * 2 * pairs),
        factors(kTileSamples) {
    Random random(seed);
    const auto limit =
        static_cast<std::uint64_t>(32766.0 / std::sqrt(2.0 * static_cast<double>(pairs)));
    const auto integer = [&] {
      return static_cast<std::int16_t>(static_cast<std::int64_t>(random.below(2 * limit + 1)) -
                                       static_cast<std::int64_t>(limit));
    };
    std::generate(values.begin(), values.end(), integer);
    std::generate(rows.begin(), rows.end(), integer);
    for (float& offset : offsets) offset = static_cast<float>(random.uniform());
    for (float& factor : factors) factor = static_cast<float>(random.uniform() * 1e-9);
  }

  ScreenedNeurons neurons() const { return {values.data(), offsets.data(), pairs}; }

  float score(std::size_t place, std::size_t s) const {
    std::int64_t product = 0;
    for (std::size_t column = 0; column < 2 * pairs; ++column) {
      const std::size_t block = place / kBlockNeurons;
      const std::size_t at =
          (block * pairs + column / 2) * 2 * kBlockNeurons + place % kBlockNeurons * 2 + column % 2;
      product += std::int64_t{values[at]} * rows[s * 2 * pairs + column];
    }
    const auto scaled = static_cast<float>(product) * factors[s];
    return offsets[place] - scaled;
  }

  std::size_t blocks;
  std::size_t pairs;
  AlignedVector<std::int16_t> values;
  AlignedVector<float> offsets;
  AlignedVector<std::int16_t> rows;
  std::vector<float> factors;
};

std::vector<Candidates> fresh(float margin) {
  std::vector<Candidates> candidates(kTileSamples);
  for (Candidates& one : candidates) {
    one = {kInfinite, margin, kInfinite, kInfinite, 0, false, {}};
  }
  return candidates;
}

TEST(BatchKernels, ScoresAreThoseOfIntegersMultipliedOneByOne) {
  const Problem problem(7, 19, 1);
  for_each_instruction_set([&](InstructionSet /*set*/) {
    AlignedVector<float> scores(kTileSamples * problem.blocks * kBlockNeurons);
    batch_table().score(problem.neurons(), problem.blocks,
                        {problem.rows.data(), problem.factors.data(), nullptr, false},
                        scores.data());
    for (std::size_t s = 0; s < kTileSamples; ++s) {
      for (std::size_t place = 0; place < problem.blocks * kBlockNeurons; ++place) {
        EXPECT_EQ(scores[s * problem.blocks * kBlockNeurons + place], problem.score(place, s));
      }
    }
  });
}

TEST(BatchKernels, ScreeningKeepsAllWithinTheMarginOfTheLeast) {
  for (const bool two : {false, true}) {
    const Problem problem(9, 11, two ? 2 : 3);
    std::vector<std::uint32_t> blocks(problem.blocks);
    std::iota(blocks.rbegin(), blocks.rend(), 0U);
    for_each_instruction_set([&](InstructionSet /*set*/) {
      constexpr float kMargin = 0.1F;
      auto candidates = fresh(kMargin);
      batch_table().screen(problem.neurons(), blocks.data(), blocks.size(),
                           {problem.rows.data(), problem.factors.data(), candidates.data(), two});
      for (std::size_t s = 0; s < kTileSamples; ++s) {
        std::vector<float> scores;
        for (std::size_t place = 0; place < problem.blocks * kBlockNeurons; ++place) {
          scores.push_back(problem.score(place, s));
        }
        std::vector<float> sorted = scores;
        std::sort(sorted.begin(), sorted.end());
        const float limit = sorted[two ? 1 : 0] + kMargin;
        EXPECT_EQ(candidates[s].threshold, limit);
        std::vector<std::uint32_t> kept;
        for (std::uint32_t k = 0; k < candidates[s].count; ++k) {
          const CandidateNeuron one = candidates[s].kept[k];
          EXPECT_EQ(one.score, scores[one.place]);
          if (one.score < limit) kept.push_back(one.place);
        }
        EXPECT_EQ(kept.size(), std::count_if(scores.begin(), scores.end(),
                                             [&](float score) { return score < limit; }));
        EXPECT_FALSE(candidates[s].overflown);
      }
    });
  }
}

TEST(BatchKernels, ScreeningReportsTooManyCandidates) {
  Problem problem(9, 2, 4);
  std::fill(problem.values.begin(), problem.values.end(), std::int16_t{1});
  std::fill(problem.offsets.begin(), problem.offsets.end(), 0.5F);
  std::vector<std::uint32_t> blocks(problem.blocks);
  std::iota(blocks.begin(), blocks.end(), 0U);
  for_each_instruction_set([&](InstructionSet /*set*/) {
    auto candidates = fresh(0.1F);
    batch_table().screen(problem.neurons(), blocks.data(), blocks.size(),
                         {problem.rows.data(), problem.factors.data(), candidates.data(), false});
    for (const Candidates& one : candidates) EXPECT_TRUE(one.overflown);
  });
}

TEST(BatchKernels, RoundsToTheNearestIntegersAndReturnsTheRoundingErrors) {
  Random random(5);
  for (const std::size_t count : {1U, 16U, 37U}) {
    const auto x = noise(random, count);
    const auto centre = noise(random, count);
    for_each_instruction_set([&](InstructionSet /*set*/) {
      std::vector<std::int16_t> integers(count + 1, std::int16_t{77});
      const float rounded_off =
          batch_table().to_integers(x.data(), centre.data(), 1000.0F, count, integers.data());
      double squares = 0.0;
      for (std::size_t i = 0; i < count; ++i) {
        const double exact = double{(x[i] - centre[i]) * 1000.0F};
        EXPECT_LE(std::fabs(exact - integers[i]), 0.5);
        squares += (exact - integers[i]) * (exact - integers[i]);
      }
      EXPECT_NEAR(rounded_off, squares, 1e-5 * squares);
      EXPECT_EQ(integers.back(), 77);
    });
  }
}

TEST(BatchKernels, SumsInDoublePrecisionAreTheSameBitsEverywhere) {
  Random random(6);
  for (const std::size_t count : {1U, 15U, 16U, 100U, 1000U}) {
    const auto a = noise(random, count);
    const auto b = noise(random, count);
    double distance = 0.0;
    double product = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      distance += (double{a[i]} - double{b[i]}) * (double{a[i]} - double{b[i]});
      product += double{a[i]} * double{b[i]};
    }
    std::vector<double> found;
    for_each_instruction_set([&](InstructionSet /*set*/) {
      found.push_back(batch_table().squared_distance(a.data(), b.data(), count));
      found.push_back(batch_table().inner_product(a.data(), b.data(), count));
      EXPECT_NEAR(found[found.size() - 2], distance, 1e-12 * distance);
      EXPECT_NEAR(found.back(), product, 1e-13 * static_cast<double>(count));
      EXPECT_NEAR(batch_table().squared_length(a.data(), b.data(), count), distance,
                  (static_cast<double>(count) / 16 + 20) * 0x1p-24 * distance);
    });
    for (std::size_t i = 2; i < found.size(); ++i) EXPECT_EQ(found[i], found[i - 2]);
  }
}

TEST(BatchKernels, FindsTheLeastAndAllUpToALimit) {
  Random random(7);
  const std::vector<float> values = noise(random, 5 * kBlockNeurons);
  const AlignedVector<float> aligned(values.begin(), values.end());
  for_each_instruction_set([&](InstructionSet /*set*/) {
    EXPECT_EQ(batch_table().least(aligned.data(), 5),
              *std::min_element(values.begin(), values.end()));
    std::vector<std::uint32_t> places(values.size());
    places.resize(batch_table().places_up_to(aligned.data(), 5, values[3], places.data()));
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < values.size(); ++i) {
      if (values[i] <= values[3]) expected.push_back(i);
    }
    EXPECT_EQ(places, expected);
  });
}

TEST(BatchKernels, MarksTheBlocksWithinReachAndLeavesOtherMarks) {
  Random random(11);
  constexpr std::size_t kCount = 5 * kBlockNeurons + 3;
  const std::vector<float> scores = noise(random, kCount);
  const std::vector<float> radii = noise(random, kCount);
  for_each_instruction_set([&](InstructionSet /*set*/) {
    std::vector<std::int32_t> marks(kCount);
    std::vector<std::int32_t> expected(kCount);
    marks[7] = 1;
    batch_table().mark_near(scores.data(), radii.data(), kCount, 0.5F, 0.25F, marks.data());
    for (std::size_t i = 0; i < kCount; ++i) {
      const float distance = 0.5F + radii[i];
      expected[i] = i == 7 || 2.0F * scores[i] + 0.25F <= distance * distance ? 1 : 0;
    }
    EXPECT_EQ(marks, expected);
    EXPECT_GT(std::count(marks.begin(), marks.end(), 1), 8);
    EXPECT_GT(std::count(marks.begin(), marks.end(), 0), 8);
  });
}

TEST(BatchKernels, MixesPlacesByFactorsAndAddsByWinner) {
  constexpr std::size_t kLanes = 8;
  Random random(8);
  const std::size_t places = 13;
  const std::size_t outputs = 11;
  std::vector<double> factors(outputs * places);
  AlignedVector<double> in(places * kLanes);
  for (double& factor : factors) factor = random.uniform();
  for (double& value : in) value = random.uniform();
  auto x = noise(random, 40);
  x[0] = 0.5F;  // a tie
  x[1] = -1.5F;
  const AlignedVector<double> scales{1.0, 1.0, 0x1p51, 0x1p50, 0x1p8, 0x1p-3, 0x1p20, 0x1p30};
  const std::vector<std::size_t> winners{3, 0, 3, 7};
  for_each_instruction_set([&](InstructionSet /*set*/) {
    AlignedVector<double> out(outputs * kLanes, 1.0);
    batch_table().mix(factors.data(), in.data(), places, out.data(), outputs);
    for (std::size_t u = 0; u < outputs; ++u) {
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        double sum = 1.0;
        for (std::size_t v = 0; v < places; ++v) {
          sum += factors[u * places + v] * in[v * kLanes + lane];
        }
        EXPECT_NEAR(out[u * kLanes + lane], sum, 1e-13 * sum);
      }
    }
    AlignedVector<std::int64_t> sums(8 * kLanes, 5);
    batch_table().add_by_winner(x.data(), 10, scales.data(), winners.data(), winners.size(),
                                sums.data());
    const auto integer = [&](std::size_t lane, float value) {
      return std::llrint(double{value} * scales[lane]);  // to the nearest, ties to even
    };
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      EXPECT_EQ(sums[3 * kLanes + lane], 5 + integer(lane, x[lane]) + integer(lane, x[20 + lane]));
      EXPECT_EQ(sums[lane], 5 + integer(lane, x[10 + lane]));
      EXPECT_EQ(sums[7 * kLanes + lane], 5 + integer(lane, x[30 + lane]));
      EXPECT_EQ(sums[kLanes + lane], 5);
    }
  });
}

}  // namespace
}  // namespace somato::kernels
