#include "somato/core/samples.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "somato/core/check.h"

namespace somato {
namespace {

std::vector<float> dense_of(const SignalView& signal) {
  std::vector<float> elements(signal.size);
  write_dense(signal, elements);
  return elements;
}

const Signal kDense = Signal::dense(std::vector<float>{1, 2, 3});
const Signal kSparse = Signal::sparse({3}, {1}, {5});
const Signal kZero = Signal::sparse({3}, {}, {});

void expect_samples(const Samples& samples, const std::vector<std::vector<float>>& expected) {
  ASSERT_EQ(samples.count(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(dense_of(samples[i]), expected[i]);
}

TEST(Samples, AreTheRowsOfAMatrix) {
  const Samples samples(Matrix<float>(2, 3, {1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(samples.size(), 3U);
  EXPECT_FALSE(samples.is_sparse());
  expect_samples(samples, {{1, 2, 3}, {4, 5, 6}});
}

TEST(Samples, AreAViewOfRowsOfOthers) {
  const std::vector<float> rows{1, 2, 3, 4, 5, 6};
  const Samples samples = Samples::view_of(rows, 3);
  EXPECT_EQ(samples.size(), 3U);
  EXPECT_FALSE(samples.is_sparse());
  EXPECT_EQ(samples.bytes(), 6 * sizeof(float));
  expect_samples(samples, {{1, 2, 3}, {4, 5, 6}});
  EXPECT_EQ(samples[1].values.data(), rows.data() + 3);
  EXPECT_TRUE(Samples(samples).is_same_as(samples));
  EXPECT_EQ(samples.apart()[1].values.data(), rows.data() + 3);
}

TEST(Samples, OfAViewAreCopiedIntoSubsets) {
  std::vector<float> rows{1, 2, 3, 4};
  const Samples subset = Samples::view_of(rows, 2).subset({1, 0, 1});
  rows.assign(4, 0);
  expect_samples(subset, {{3, 4}, {1, 2}, {3, 4}});
}

TEST(Samples, OfAViewNeedWholeRows) {
  EXPECT_THROW(Samples::view_of(std::vector<float>(5), 2), InvalidArgument);
  EXPECT_THROW(Samples::view_of(std::vector<float>(5), 0), InvalidArgument);
  EXPECT_EQ(Samples::view_of({}, 2).count(), 0U);
}

TEST(Samples, AreDenseAsSoonAsOneOfThemIs) {
  const Samples samples = Samples::from_signals({kSparse, kDense, kZero});
  EXPECT_FALSE(samples.is_sparse());
  expect_samples(samples, {{0, 5, 0}, {1, 2, 3}, {0, 0, 0}});
}

TEST(Samples, StaySparseWhenAllAre) {
  const Samples samples = Samples::from_signals({kSparse, kZero, kSparse});
  EXPECT_TRUE(samples.is_sparse());
  EXPECT_EQ(samples.size(), 3U);
  EXPECT_EQ(samples[1].values.size(), 0U);
  expect_samples(samples, {{0, 5, 0}, {0, 0, 0}, {0, 5, 0}});
}

TEST(Samples, AreSharedByCopies) {
  const Samples samples(Matrix<float>(1, 2, {1, 2}));
  const Samples copy = samples;
  EXPECT_TRUE(copy.is_same_as(samples));
  EXPECT_EQ(copy[0].values.data(), samples[0].values.data());
  EXPECT_FALSE(Samples(Matrix<float>(1, 2, {1, 2})).is_same_as(samples));
  EXPECT_FALSE(samples.subset({0}).is_same_as(samples));
}

TEST(Samples, ComputeOnceForAllCopies) {
  const Samples samples(Matrix<float>(1, 2, {1, 2}));
  const Samples copy = samples;
  int computed = 0;
  const auto compute = [&] { return std::make_shared<const int>(++computed); };
  const auto first = samples.computed_once(0, compute);
  EXPECT_EQ(copy.computed_once(0, compute), first);
  EXPECT_EQ(computed, 1);
  EXPECT_NE(samples.computed_once(1, compute), first);
  EXPECT_NE(samples.apart().computed_once(0, compute), first);
  EXPECT_TRUE(samples.apart().is_same_as(samples));
}

TEST(Samples, MustHaveOneSize) {
  const Signal other = Signal::sparse({4}, {1}, {5});
  EXPECT_THROW(Samples::from_signals({kSparse, other}), InvalidArgument);
  EXPECT_THROW(Samples::from_signals({kDense, other}), InvalidArgument);
}

TEST(Samples, MayBeNone) {
  EXPECT_EQ(Samples().count(), 0U);
  EXPECT_EQ(Samples::from_signals({}).count(), 0U);
}

TEST(Samples, AreChosenInTheRequestedOrder) {
  const Samples dense(Matrix<float>(3, 1, {10, 11, 12}));
  expect_samples(dense.subset({2, 0, 2}), {{12}, {10}, {12}});
  const Samples sparse = Samples::from_signals({kSparse, kZero});
  EXPECT_TRUE(sparse.subset({1, 0}).is_sparse());
  expect_samples(sparse.subset({1, 0, 0}), {{0, 0, 0}, {0, 5, 0}, {0, 5, 0}});
  EXPECT_EQ(sparse.subset({}).count(), 0U);
  EXPECT_EQ(sparse.subset({}).size(), 3U);
}

}  // namespace
}  // namespace somato
