#include "somato/codes/concatenation.h"

#include <gtest/gtest.h>

#include <vector>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

Signal concatenation_of(const std::vector<Signal>& inputs) {
  return concatenation(inputs);
}

Signal random_signal(Random& random, bool sparse) {
  const std::size_t size = random.below(6);
  std::vector<std::uint32_t> indices;
  std::vector<float> values;
  for (std::uint32_t i = 0; i < size; ++i) {
    if (sparse && random.below(2) == 0) continue;
    indices.push_back(i);
    values.push_back(static_cast<float>(random.normal()));
  }
  return sparse ? Signal::sparse({size}, indices, values) : Signal::dense(values);
}

TEST(Concatenation, PutsDenseSignalsOneAfterTheOther) {
  EXPECT_EQ(concatenation_of({Signal::dense({2, 2}, {1.0F, 2.0F, 3.0F, 4.0F}), Signal::dense({}),
                              Signal::dense({5.0F})}),
            Signal::dense({1.0F, 2.0F, 3.0F, 4.0F, 5.0F}));
}

TEST(Concatenation, StaysSparseWhenAllAre) {
  EXPECT_EQ(concatenation_of({Signal::sparse({10}, {4}, {1.0F}), Signal::sparse({10}, {7}, {1.0F}),
                              Signal::sparse({2, 10}, {0, 19}, {1.0F, 0.0F})}),
            Signal::sparse({40}, {4, 17, 20, 39}, {1.0F, 1.0F, 1.0F, 0.0F}));
}

TEST(Concatenation, IsDenseWhenAnyIs) {
  EXPECT_EQ(concatenation_of({Signal::sparse({3}, {1}, {1.0F}), Signal::dense({0.5F})}),
            Signal::dense({0.0F, 1.0F, 0.0F, 0.5F}));
}

TEST(Concatenation, HoldsTheSameElementsHoweverTheyAreStored) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    std::vector<Signal> inputs(1 + random.below(4));
    std::vector<float> elements;
    const std::uint64_t sparse_in_two = random.below(3);
    for (Signal& input : inputs) {
      input = random_signal(random, random.below(2) < sparse_in_two);
      for (const float element : input.to_dense()) elements.push_back(element);
    }
    EXPECT_EQ(concatenation_of(inputs).to_dense(), elements);
  }
}

TEST(Concatenation, RefusesNothingAndTooMuch) {
  EXPECT_THROW(concatenation_of({}), InvalidArgument);
  const Signal huge = Signal::sparse({4294967295U}, {4294967294U}, {1.0F});
  EXPECT_EQ(concatenation_of({huge}), huge);
  EXPECT_THROW(concatenation_of({huge, Signal::sparse({1}, {}, {})}), InvalidArgument);
}

}  // namespace
}  // namespace somato
