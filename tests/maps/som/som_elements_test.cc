#include "somato/maps/som.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "maps/support/random_maps.h"
#include "somato/core/check.h"

namespace somato {
namespace {

using testing::random_samples;

Samples two_samples() {
  return Samples::from_signals(
      {Signal::sparse({9}, {1, 4}, {2.0F, 3.0F}), Signal::sparse({9}, {4, 7}, {5.0F, 0.0F})});
}

TEST(StoredElements, AreAllOfAnInputUnlessTheyAreListed) {
  const StoredElements all(5);
  EXPECT_TRUE(all.all());
  EXPECT_EQ(all.size(), 5U);
  EXPECT_EQ(all.count(), 5U);
  EXPECT_EQ(all.place_of(3), 3U);
  const StoredElements some(5, {1, 4});
  EXPECT_FALSE(some.all());
  EXPECT_EQ(some.size(), 5U);
  EXPECT_EQ(some.count(), 2U);
  EXPECT_EQ(some.place_of(4), 1U);
  EXPECT_EQ(some.place_of(2), std::nullopt);
  EXPECT_THROW((void)some.place_of(5), InvalidArgument);
}

TEST(StoredElements, RefuseImpossibleLists) {
  EXPECT_THROW(StoredElements(5, {}), InvalidArgument);
  EXPECT_THROW(StoredElements(5, {1, 1}), InvalidArgument);
  EXPECT_THROW(StoredElements(5, {2, 1}), InvalidArgument);
  EXPECT_THROW(StoredElements(5, {1, 5}), InvalidArgument);
  EXPECT_NO_THROW(StoredElements(5, {0, 1, 2, 3, 4}));
}

TEST(StoredElements, AreTheOnesThatSparseSamplesUse) {
  EXPECT_EQ(StoredElements::used_by(two_samples()), StoredElements(9, {1, 4, 7}));
  EXPECT_EQ(StoredElements::used_by(Samples(Matrix<float>(2, 9))), StoredElements(9));
  EXPECT_EQ(StoredElements::used_by(Samples::from_signals({Signal::sparse({9}, {}, {})})),
            StoredElements(9, {0}));
}

TEST(StoredElements, AreAllWhereSamplesUseHalfOfThem) {
  const auto with = [](std::vector<std::uint32_t> indices) {
    std::vector<float> ones(indices.size(), 1.0F);
    const Signal other = Signal::sparse({8}, {7}, {1.0F});
    return Samples::from_signals({Signal::sparse({8}, std::move(indices), std::move(ones)), other});
  };
  EXPECT_EQ(StoredElements::used_by(with({0, 2})), StoredElements(8, {0, 2, 7}));
  EXPECT_EQ(StoredElements::used_by(with({0, 2, 4})), StoredElements(8));
  EXPECT_EQ(StoredElements::used_by(with({0, 2, 4, 5})), StoredElements(8));
}

TEST(StoredElements, SplitAnInputInWhatIsStoredAndTheRest) {
  Random random(7);
  for (int i = 0; i < 500; ++i) {
    const std::size_t size = 2 + random.below(30);
    std::vector<std::uint32_t> listed;
    for (std::uint32_t d = 0; d < size; ++d) {
      if (random.below(3) == 0) listed.push_back(d);
    }
    if (listed.empty()) listed.push_back(0);
    const bool sparse = random.below(2) == 0;
    const Samples samples = random_samples(1, size, sparse, random);
    const double factor = random.below(2) == 0 ? 1.0 : random.uniform();
    std::vector<float> dense(size);
    write_dense(samples[0], dense);
    std::vector<float> expected;
    double rest = 0.0;
    for (std::uint32_t d = 0; d < size; ++d) {
      const auto value = static_cast<float>(dense[d] * factor);
      if (std::find(listed.begin(), listed.end(), d) != listed.end()) {
        expected.push_back(value);
      } else {
        rest += double{value} * double{value};
      }
    }
    std::vector<float> stored(listed.size(), 9.0F);
    const StoredElements elements(size, listed);
    EXPECT_NEAR(elements.gather(samples[0], stored, factor), rest, 1e-12 * (1.0 + rest));
    EXPECT_EQ(stored, expected);
    std::vector<float> all(size);
    EXPECT_EQ(StoredElements(size).gather(samples[0], all), 0.0);
    EXPECT_EQ(all, dense);
  }
}

TEST(StoredElements, MakeSamplesOfThemselves) {
  const Samples samples = two_samples();
  const Samples stored = StoredElements(9, {1, 4, 7}).gather(samples);
  EXPECT_FALSE(stored.is_sparse());
  ASSERT_EQ(stored.size(), 3U);
  std::vector<float> values(3);
  write_dense(stored[0], values);
  EXPECT_EQ(values, (std::vector<float>{2, 3, 0}));
  write_dense(stored[1], values);
  EXPECT_EQ(values, (std::vector<float>{0, 5, 0}));
  EXPECT_THROW((void)StoredElements(8, {1, 4, 7}).gather(samples), InvalidArgument);
}

TEST(StoredElements, MakeTheSameSamplesSparseOrDense) {
  Random random(8);
  for (const std::size_t per_sample : {1U, 30U}) {  // of 40
    std::vector<Signal> signals;
    for (std::uint32_t i = 0; i < 40; ++i) {
      std::vector<std::uint32_t> indices(per_sample);
      for (std::uint32_t k = 0; k < per_sample; ++k) indices[k] = 3 * ((i + k) % 40);
      std::sort(indices.begin(), indices.end());
      const std::vector<float> values(per_sample, static_cast<float>(random.normal()));
      signals.push_back(Signal::sparse({200}, indices, values));
    }
    const Samples samples = Samples::from_signals(signals);
    const StoredElements elements = StoredElements::used_by(samples);
    ASSERT_EQ(elements.count(), 40U);
    const Samples stored = elements.gather(samples);
    EXPECT_EQ(stored.is_sparse(), per_sample == 1);
    std::vector<float> whole(200);
    std::vector<float> part(40);
    for (std::size_t i = 0; i < samples.count(); ++i) {
      write_dense(samples[i], whole);
      write_dense(stored[i], part);
      for (std::size_t k = 0; k < 40; ++k) EXPECT_EQ(part[k], whole[3 * k]);
    }
  }
}

TEST(StoredElements, LeaveOutOfSamplesWhatIsNotStored) {
  const Samples stored = StoredElements(9, {1, 7}).gather(two_samples());
  std::vector<float> values(2);
  write_dense(stored[0], values);
  EXPECT_EQ(values, (std::vector<float>{2, 0}));
}

}  // namespace
}  // namespace somato
