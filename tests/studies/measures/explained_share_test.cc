#include "studies/measures/explained_share.h"

#include <gtest/gtest.h>

#include <vector>

#include "somato/core/random.h"

namespace somato {
namespace {

Samples rows(std::size_t count, std::size_t size, std::vector<float> values) {
  return Samples(Matrix<float>(count, size, std::move(values)));
}

TEST(ExplainedShare, IsOneWhereClassesDifferAndZeroWhereTheirMeansAreEqual) {
  const Classes classes = Classes::from_names({"a", "a", "b", "b"});
  const Samples samples = rows(4, 3, {1, 1, 7, 1, 3, 7, 5, 1, 7, 5, 3, 7});
  EXPECT_EQ(explained_shares(samples, classes), (std::vector<double>{1.0, 0.0, 0.0}));
}

// By hand: values 0, 2 and 4, 10 have the class means 1 and 7 around 4: 2 * (9 + 9) = 36 of
// 16 + 4 + 0 + 36 = 56.
TEST(ExplainedShare, IsTheShareOfTheSumOfSquaresBetweenTheClasses) {
  const Classes classes = Classes::from_names({"a", "a", "b", "b"});
  EXPECT_DOUBLE_EQ(explained_shares(rows(4, 1, {0, 2, 4, 10}), classes)[0], 36.0 / 56.0);
}

// The ratio of the F statistic of an analysis of variance: F (k-1) / (F (k-1) + n - k).
TEST(ExplainedShare, DoesNotDependOnOffsetAndScale) {
  Random random(7, Stream::kDraws);
  std::vector<float> values;
  std::vector<float> changed;
  std::vector<std::string> names;
  for (int i = 0; i < 60; ++i) {
    const auto kind = static_cast<std::size_t>(random.below(3));
    const auto value = static_cast<float>(random.below(64) + 20 * kind);
    values.push_back(value);
    changed.push_back(1024.0F - 8.0F * value);
    names.push_back(std::to_string(kind));
  }
  const Classes classes = Classes::from_names(names);
  const double share = explained_shares(rows(60, 1, values), classes)[0];
  EXPECT_GT(share, 0.1);
  EXPECT_LT(share, 0.9);
  EXPECT_NEAR(explained_shares(rows(60, 1, changed), classes)[0], share, 1e-12);
}

}  // namespace
}  // namespace somato
