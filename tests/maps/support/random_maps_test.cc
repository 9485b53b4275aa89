#include "maps/support/random_maps.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace somato {
namespace {

// Every two values of different properties that occur in one kind of map: two places and values.
std::set<std::array<int, 4>> pairs_in(const std::vector<testing::Variant>& variants) {
  std::set<std::array<int, 4>> pairs;
  for (const testing::Variant& variant : variants) {
    const std::array<int, 4> values{
        static_cast<int>(variant.lattice), static_cast<int>(variant.topology),
        static_cast<int>(variant.similarity), static_cast<int>(variant.neighbourhood)};
    for (int a = 0; a < 4; ++a) {
      for (int b = a + 1; b < 4; ++b) {
        pairs.insert(
            {a, values[static_cast<std::size_t>(a)], b, values[static_cast<std::size_t>(b)]});
      }
    }
  }
  return pairs;
}

TEST(Variants, InPairsHaveEveryPairOfAll) {
  const auto all = testing::all_variants();
  const auto some = testing::variants_in_pairs();
  EXPECT_EQ(pairs_in(some), pairs_in(all));
  EXPECT_LT(2 * some.size(), all.size());
}

}  // namespace
}  // namespace somato
