#include "somato/core/signal.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <vector>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

std::vector<float> random_elements(Random& random, std::size_t size) {
  std::vector<float> elements(size, 0.0F);
  for (float& element : elements) {
    if (random.below(3) == 0) element = static_cast<float>(random.normal());
  }
  return elements;
}

Signal sparse_of(const std::vector<float>& elements) {
  std::vector<std::uint32_t> indices;
  std::vector<float> values;
  for (std::uint32_t i = 0; i < elements.size(); ++i) {
    if (elements[i] == 0.0F) continue;
    indices.push_back(i);
    values.push_back(elements[i]);
  }
  return Signal::sparse({elements.size()}, indices, values);
}

TEST(Signal, KnowsItsShape) {
  const Signal dense = Signal::dense({2, 3}, {1, 2, 3, 4, 5, 6});
  EXPECT_EQ(dense.shape(), (std::vector<std::size_t>{2, 3}));
  EXPECT_EQ(dense.size(), 6U);
  EXPECT_FALSE(dense.is_sparse());
  EXPECT_EQ(Signal::dense(std::vector<float>{1, 2}).shape(), (std::vector<std::size_t>{2}));
}

TEST(Signal, WritesTheZerosOfASparseSignal) {
  const Signal sparse = Signal::sparse({2, 3}, {1, 5}, {7.0F, 8.0F});
  EXPECT_TRUE(sparse.is_sparse());
  EXPECT_EQ(sparse.size(), 6U);
  EXPECT_EQ(sparse.to_dense(), (std::vector<float>{0, 7, 0, 0, 0, 8}));
}

TEST(Signal, OverwritesWhatStoodInTheDenseVectorBefore) {
  std::vector<float> out{9, 9, 9};
  write_dense(Signal::sparse({3}, {1}, {5.0F}).view(), out);
  EXPECT_EQ(out, (std::vector<float>{0, 5, 0}));
  std::vector<float> too_short(2);
  EXPECT_THROW(write_dense(Signal::sparse({3}, {1}, {5.0F}).view(), too_short), InvalidArgument);
}

TEST(Signal, RefusesValuesThatDoNotFillTheShape) {
  EXPECT_THROW(Signal::dense({2, 3}, {1, 2, 3, 4, 5}), InvalidArgument);
  EXPECT_THROW(Signal::sparse({4}, {1, 2}, {1.0F}), InvalidArgument);
}

TEST(Signal, RefusesIndicesThatDoNotAscendInside) {
  EXPECT_THROW(Signal::sparse({4}, {2, 1}, {1, 1}), InvalidArgument);
  EXPECT_THROW(Signal::sparse({4}, {1, 1}, {1, 1}), InvalidArgument);
  EXPECT_THROW(Signal::sparse({4}, {4}, {1}), InvalidArgument);
  EXPECT_NO_THROW(Signal::sparse({4}, {0, 3}, {1, 1}));
}

TEST(Signal, RefusesShapesThatCannotBeCounted) {
  const std::size_t most = std::numeric_limits<std::size_t>::max();
  EXPECT_THROW(Signal::sparse({most, 2}, {}, {}), InvalidArgument);
  EXPECT_EQ(Signal::sparse({most, 0}, {}, {}).size(), 0U);
}

TEST(InnerProduct, IsWorkedOutByHand) {
  const Signal a = Signal::dense(std::vector<float>{1, 2, 0, -3});
  const Signal b = Signal::sparse({4}, {1, 3}, {5, 0.5F});
  EXPECT_EQ(inner_product(a.view(), b.view()), 8.5);
  EXPECT_EQ(inner_product(b.view(), b.view()), 25.25);
}

TEST(InnerProduct, HasTheSameBitsDenseAndSparse) {
  Random random(11);
  for (int trial = 0; trial < 1000; ++trial) {
    const std::size_t size = random.below(40);
    const std::vector<float> left = random_elements(random, size);
    const std::vector<float> right = random_elements(random, size);
    double expected = 0.0;
    for (std::size_t i = 0; i < size; ++i) expected += double{left[i]} * double{right[i]};
    const Signal a = Signal::dense(left);
    const Signal b = Signal::dense(right);
    const double product = inner_product(a.view(), b.view());
    EXPECT_NEAR(product, expected, 1e-12);
    EXPECT_EQ(inner_product(sparse_of(left).view(), b.view()), product);
    EXPECT_EQ(inner_product(a.view(), sparse_of(right).view()), product);
    EXPECT_EQ(inner_product(sparse_of(left).view(), sparse_of(right).view()), product);
  }
}

TEST(InnerProduct, RefusesDifferentSizes) {
  const Signal two = Signal::dense(std::vector<float>{1, 2});
  const Signal three = Signal::sparse({3}, {0}, {1});
  EXPECT_THROW(inner_product(two.view(), three.view()), InvalidArgument);
}

}  // namespace
}  // namespace somato
