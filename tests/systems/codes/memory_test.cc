#include "somato/codes/memory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

Signal random_sparse(Random& random, std::size_t size) {
  std::vector<std::uint32_t> indices;
  std::vector<float> values;
  for (std::uint32_t i = 0; i < size; ++i) {
    if (random.below(4) != 0) continue;
    indices.push_back(i);
    values.push_back(static_cast<float>(random.normal()));
  }
  return Signal::sparse({size}, std::move(indices), std::move(values));
}

TEST(Memory, AddsUpTheFramesOfAnExploration) {
  Memory memory({2, 2});
  memory.add(Signal::dense({2, 2}, {1.0F, 0.0F, -1.0F, 0.5F}).view());
  EXPECT_EQ(memory.value(), Signal::dense({2, 2}, {1.0F, 0.0F, -1.0F, 0.5F}));
  memory.add(Signal::dense({2, 2}, {1.0F, 2.0F, 4.0F, 0.25F}).view());
  EXPECT_EQ(memory.value(), Signal::dense({2, 2}, {2.0F, 2.0F, 3.0F, 0.75F}));
}

TEST(Memory, OfSparseFramesIsSparseAndInOrder) {
  Memory memory({3, 2});
  memory.add(Signal::sparse({6}, {4, 5}, {1.0F, 2.0F}).view());
  memory.add(Signal::sparse({6}, {0, 4}, {8.0F, 16.0F}).view());
  EXPECT_EQ(memory.value(), Signal::sparse({3, 2}, {0, 4, 5}, {8.0F, 17.0F, 2.0F}));
}

TEST(Memory, IsEmptyAtFirstAndAfterAReset) {
  Memory memory({5});
  EXPECT_EQ(memory.value(), Signal::sparse({5}, {}, {}));
  memory.add(Signal::sparse({5}, {1, 4}, {1.0F, 1.0F}).view());
  memory.reset();
  EXPECT_EQ(memory.value(), Signal::sparse({5}, {}, {}));
  memory.add(Signal::sparse({5}, {4}, {3.0F}).view());
  EXPECT_EQ(memory.value(), Signal::sparse({5}, {4}, {3.0F}));
  memory.add(Signal::dense({1, 1, 1, 1, 1}).view());
  memory.reset();
  memory.add(Signal::sparse({5}, {3}, {2.0F}).view());
  EXPECT_EQ(memory.value(), Signal::sparse({5}, {3}, {2.0F}));
}

TEST(Memory, LeaksItsShareWithEveryFrame) {
  Memory memory({2}, {0.25});
  memory.add(Signal::dense({16.0F, 0.0F}).view());
  memory.add(Signal::dense({0.0F, 4.0F}).view());
  EXPECT_EQ(memory.value(), Signal::dense({12.0F, 4.0F}));
  memory.add(Signal::dense({1.0F, 0.0F}).view());
  EXPECT_EQ(memory.value(), Signal::dense({10.0F, 3.0F}));
}

TEST(Memory, HoldsOnlyTheLastFrameWithFullLeak) {
  Memory memory({2}, {1.0});
  memory.add(Signal::dense({16.0F, 3.0F}).view());
  memory.add(Signal::dense({0.0F, 4.0F}).view());
  EXPECT_EQ(memory.value(), Signal::dense({0.0F, 4.0F}));
}

TEST(Memory, BecomesDenseWithTheFirstDenseFrame) {
  Memory memory({3}, {0.5});
  memory.add(Signal::sparse({3},
                            {
                                2,
                            },
                            {8.0F})
                 .view());
  memory.add(Signal::dense({1.0F, 2.0F, 3.0F}).view());
  memory.add(Signal::sparse({3}, {0}, {10.0F}).view());
  EXPECT_EQ(memory.value(), Signal::dense({10.5F, 1.0F, 3.5F}));
}

TEST(Memory, GivesSparseAndDenseFramesTheSameBits) {
  Random random(1);
  for (const double leak : {0.0, 0.1, 0.37}) {
    for (int problem = 0; problem < 30; ++problem) {
      const std::size_t size = problem % 2 == 0 ? 23 : 1000;
      Memory sparse({size}, {leak});
      Memory dense({size}, {leak});
      sparse.add(random_sparse(random, size).view());  // of an exploration before
      sparse.reset();
      for (int frame = 0; frame < 20; ++frame) {
        const Signal signal = random_sparse(random, size);
        sparse.add(signal.view());
        dense.add(Signal::dense(signal.to_dense()).view());
        EXPECT_EQ(sparse.value().to_dense(), dense.value().to_dense());
      }
      EXPECT_TRUE(sparse.value().is_sparse());
      EXPECT_FALSE(dense.value().is_sparse());
    }
  }
}

// The oracle adds up every frame times what is left of it.
TEST(Memory, HoldsEveryFrameTimesWhatIsLeftOfIt) {
  Random random(2);
  for (const double leak : {0.0, 0.05, 0.5}) {
    Memory memory({7}, {leak});
    std::vector<Signal> frames;
    for (int t = 0; t < 40; ++t) {
      frames.push_back(random_sparse(random, 7));
      memory.add(frames.back().view());
    }
    std::vector<double> expected(7, 0.0);
    for (std::size_t t = 0; t < frames.size(); ++t) {
      const std::vector<float> frame = frames[t].to_dense();
      const double left = std::pow(1.0 - leak, static_cast<double>(frames.size() - 1 - t));
      for (std::size_t i = 0; i < 7; ++i) expected[i] += left * double{frame[i]};
    }
    const std::vector<float> held = memory.value().to_dense();
    for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(held[i], expected[i], 1e-5);
  }
}

// In single precision 2^24 swallows every further 1.
TEST(Memory, AddsInDoublePrecision) {
  Memory memory({1});
  memory.add(Signal::dense(std::vector<float>{16777216.0F}).view());
  for (int i = 0; i < 4; ++i) memory.add(Signal::sparse({1}, {0}, {1.0F}).view());
  EXPECT_EQ(memory.value(), Signal::dense(std::vector<float>{16777220.0F}));
}

// Had it a place for every element, this would take 16 GB or more.
TEST(Memory, TouchesNoZeros) {
  constexpr std::uint32_t kSize = 4294967295;
  Memory memory({kSize}, {0.5});
  for (std::uint32_t t = 0; t < 1000; ++t) {
    memory.add(Signal::sparse({kSize}, {t, kSize - 1}, {1.0F, 1.0F}).view());
  }
  const Signal held = memory.value();
  EXPECT_EQ(held.size(), kSize);
  ASSERT_EQ(held.indices().size(), 1001U);
  EXPECT_EQ(held.indices().back(), kSize - 1);
  EXPECT_EQ(held.values()[999], 1.0F);
  EXPECT_EQ(held.values()[1000], 2.0F);
}

TEST(Memory, RefusesWhatDoesNotFit) {
  Memory memory({3});
  EXPECT_THROW(memory.add(Signal::dense({1.0F, 2.0F}).view()), InvalidArgument);
  EXPECT_THROW(Memory({3}, {-0.1}), InvalidArgument);
  EXPECT_THROW(Memory({3}, {1.1}), InvalidArgument);
  EXPECT_THROW(Memory({65536, 65536}), InvalidArgument);
}

TEST(MemoryParameters, HaveNoLeakByDefault) {
  EXPECT_EQ(MemoryParameters{}.leak, 0.0);
  const Table table{"", {{"leak", "", Value{0.125}}}};
  EXPECT_EQ(read_parameters<MemoryParameters>(table)->leak, 0.125);
}

}  // namespace
}  // namespace somato
