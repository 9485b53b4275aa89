#include "systems/signals/missing_values.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "somato/core/check.h"
#include "somato/core/matrix.h"
#include "somato/core/random.h"

namespace somato {
namespace {

constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();

Samples samples(std::size_t rows, std::vector<float> values) {
  const std::size_t columns = values.size() / rows;
  return Samples(Matrix<float>(rows, columns, std::move(values)));
}

std::vector<float> values_of(const Samples& samples) {
  std::vector<float> values;
  for (std::size_t i = 0; i < samples.count(); ++i) {
    values.insert(values.end(), samples[i].values.begin(), samples[i].values.end());
  }
  return values;
}

TEST(FilledWith, ReplacesMissingValuesOnly) {
  EXPECT_EQ(
      values_of(filled_with(std::vector<double>{0.1, 7}, samples(2, {kMissing, 2, 3, kMissing}))),
      (std::vector<float>{0.1F, 2, 3, 7}));
  EXPECT_THROW((void)filled_with(std::vector<double>{1}, samples(1, {1, 2})), InvalidArgument);
}

TEST(FilledFromNearest, TakesTheNearestCompleteRowOverWhatIsKnown) {
  const Samples rows = samples(5, {
                                      0, 0, 10,         //
                                      5, 5, 20,         //
                                      4, kMissing, 11,  // is nearer, but incomplete
                                      4, 4, kMissing,   // 2 from the second, 32 from the first
                                      kMissing, 2.5F, kMissing  // as far from both: the first
                                  });
  EXPECT_EQ(values_of(filled_from_nearest(rows, {}).value()),
            (std::vector<float>{0, 0, 10, 5, 5, 20, 4, 0, 11, 4, 4, 20, 0, 2.5F, 10}));
}

// 30 grams are less than 2 millimetres where grams deviate by 100 and millimetres by 1.
TEST(FilledFromNearest, DividesDifferencesByTheScale) {
  const Samples rows = samples(3, {0, 0, 1, 50, 2, 2, 30, 1.9F, kMissing});
  const Samples nearer = samples(3, {0, 0, 1, 31, 2, 2, 20, 0.1F, kMissing});
  EXPECT_EQ(values_of(filled_from_nearest(nearer, {}).value()).back(), 2);
  EXPECT_EQ(values_of(filled_from_nearest(nearer, std::vector<double>{100, 1, 1}).value()).back(),
            1);
  EXPECT_EQ(values_of(filled_from_nearest(nearer, std::vector<double>{1, 0, 1}).value()).back(), 2)
      << "a column that never varies does not count";
  EXPECT_EQ(values_of(filled_from_nearest(rows, {}).value()).back(), 2);
}

TEST(FilledFromNearest, NeedsACompleteRow) {
  EXPECT_EQ(filled_from_nearest(samples(2, {1, kMissing, kMissing, 1}), {}).error().kind,
            ErrorKind::kData);
  const Progress stop = [](std::uint64_t, std::uint64_t) { return false; };
  EXPECT_EQ(filled_from_nearest(samples(2, {1, kMissing, 1, 1}), {}, stop).error().kind,
            ErrorKind::kInterrupted);
}

// Against every distance written out.
TEST(FilledFromNearest, IsWhatAFullSearchFinds) {
  Random random(5);
  for (int repeat = 0; repeat < 200; ++repeat) {
    const std::size_t count = 2 + random.below(12);
    Matrix<float> matrix(count, 4);
    for (float& value : matrix.values()) value = static_cast<float>(random.below(4));
    std::vector<bool> complete(count, true);
    for (std::size_t i = 1; i < count; ++i) {
      for (std::size_t d = 0; d < 3; ++d) {
        if (random.below(5) > 0) continue;
        matrix(i, d) = kMissing;
        complete[i] = false;
      }
    }
    const std::vector<float> filled = values_of(filled_from_nearest(Samples(matrix), {}).value());
    for (std::size_t i = 0; i < count; ++i) {
      std::size_t nearest = 0;
      double least = 1e9;
      for (std::size_t j = 0; j < count; ++j) {
        double sum = 0.0;
        for (std::size_t d = 0; d < 4; ++d) {
          if (!std::isnan(matrix(i, d))) sum += std::pow(matrix(i, d) - matrix(j, d), 2);
        }
        if (!complete[j] || sum >= least) continue;
        least = sum;
        nearest = j;
      }
      for (std::size_t d = 0; d < 4; ++d) {
        EXPECT_EQ(filled[i * 4 + d], std::isnan(matrix(i, d)) ? matrix(nearest, d) : matrix(i, d));
      }
    }
  }
}

// By hand: of 1 and 3 it is 1, of 2, 4 and 6 the root of 8/3.
TEST(KnownDeviations, AreThoseOfTheKnownValues) {
  const auto deviations =
      known_deviations(samples(3, {1, 2, kMissing, 4, 3, 6}), std::vector<double>{2, 4});
  EXPECT_DOUBLE_EQ(deviations[0], 1.0);
  EXPECT_DOUBLE_EQ(deviations[1], std::sqrt(8.0 / 3.0));
}

}  // namespace
}  // namespace somato
