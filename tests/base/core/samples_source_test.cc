#include "somato/core/samples.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "maps/support/random_maps.h"
#include "somato/core/check.h"

namespace somato {
namespace {

// Every value of every part, in order, and how many samples came at a time.
struct Collected {
  std::vector<float> values;
  std::vector<std::size_t> counts;
};

Collected collect(SampleSource& source) {
  Collected collected;
  const auto visited = for_each_part(source, [&](const Samples& part) -> Result<void> {
    collected.counts.push_back(part.count());
    std::vector<float> row(part.size());
    for (std::size_t i = 0; i < part.count(); ++i) {
      write_dense(part[i], row);
      collected.values.insert(collected.values.end(), row.begin(), row.end());
    }
    return {};
  });
  EXPECT_TRUE(visited);
  return collected;
}

TEST(SamplesInMemory, AreTheSameHoweverTheyAreParted) {
  Random random(1);
  for (const bool sparse : {false, true}) {
    const Samples samples = testing::random_samples(10, 3, sparse, random);
    SamplesInMemory whole(samples);
    const Collected expected = collect(whole);
    EXPECT_EQ(expected.counts, std::vector<std::size_t>{10});
    SamplesInMemory parts(samples, 4);
    EXPECT_EQ(parts.size(), 3u);
    for (int pass = 0; pass < 2; ++pass) {
      const Collected collected = collect(parts);
      EXPECT_EQ(collected.values, expected.values);
      EXPECT_EQ(collected.counts, (std::vector<std::size_t>{4, 4, 2}));
    }
  }
}

TEST(SamplesInMemory, AreNotCopiedAsAWhole) {
  const Samples samples(Matrix<float>(2, 2));
  SamplesInMemory source(samples);
  EXPECT_EQ(source.next()->get(), &samples);
  EXPECT_EQ(source.next()->get(), nullptr);
}

TEST(SamplesInMemory, MayBeNone) {
  const Samples none;
  SamplesInMemory source(none);
  EXPECT_TRUE(collect(source).counts.empty());
  EXPECT_THROW(SamplesInMemory(none, 0), InvalidArgument);
}

TEST(ForEachPart, EndsAtTheFirstFailure) {
  const Samples samples(Matrix<float>(5, 1));
  SamplesInMemory source(samples, 2);
  int visits = 0;
  const auto visited = for_each_part(source, [&](const Samples&) -> Result<void> {
    if (++visits == 2) return fail(ErrorKind::kData, "enough");
    return {};
  });
  EXPECT_EQ(visited.error().what, "enough");
  EXPECT_EQ(visits, 2);
}

TEST(ChangedSamples, AreChangedPartByPart) {
  const Samples samples(Matrix<float>(3, 1, {1, 2, 3}));
  SamplesInMemory source(samples, 2);
  ChangedSamples doubled(source, [](const Samples& part) {
    Matrix<float> rows(part.count(), 1);
    for (std::size_t i = 0; i < part.count(); ++i) rows(i, 0) = 2 * part[i].values[0];
    return Samples(std::move(rows));
  });
  const Collected collected = collect(doubled);
  EXPECT_EQ(collected.values, (std::vector<float>{2, 4, 6}));
  EXPECT_EQ(collected.counts, (std::vector<std::size_t>{2, 1}));
}

}  // namespace
}  // namespace somato
