#include "maps/grid/element_set.h"

#include <gtest/gtest.h>

#include <set>

#include "maps/support/random_maps.h"

namespace somato {
namespace {

Samples in_space_of(std::size_t size, const std::vector<std::vector<std::uint32_t>>& indices) {
  std::vector<Signal> signals;
  for (const auto& places : indices) {
    signals.push_back(Signal::sparse({size}, places, std::vector<float>(places.size(), 1.0F)));
  }
  return Samples::from_signals(signals);
}

void expect_listed(const Samples& samples) {
  std::set<std::uint32_t> expected;
  for (std::size_t i = 0; i < samples.count(); ++i) {
    const auto indices = samples[i].indices;
    expected.insert(indices.begin(), indices.end());
  }
  const ElementSet elements(samples);
  EXPECT_EQ(elements.listed(), std::vector<std::uint32_t>(expected.begin(), expected.end()));
  for (std::size_t place = 0; place < elements.listed().size(); ++place) {
    EXPECT_EQ(elements.place_of(elements.listed()[place]), place);
  }
}

TEST(ElementSet, HoldsEveryElementOnce) {
  Random random(41);
  for (int i = 0; i < 50; ++i) {
    expect_listed(
        testing::random_samples(1 + random.below(4), 1 + random.below(300), true, random));
  }
}

// Too many elements for a bit each.
TEST(ElementSet, HoldsAFewOfVeryMany) {
  expect_listed(in_space_of(4000000000U, {{3, 3999999999U}, {}, {0, 3, 64, 2000000000U}}));
}

TEST(ElementSet, OfNoValuesIsEmpty) {
  EXPECT_TRUE(ElementSet(in_space_of(70, {{}, {}})).listed().empty());
  EXPECT_TRUE(ElementSet(in_space_of(4000000000U, {{}})).listed().empty());
}

}  // namespace
}  // namespace somato
