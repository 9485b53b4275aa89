#include "maps/products/sample_columns.h"

#include <gtest/gtest.h>

#include "maps/support/random_maps.h"

namespace somato {
namespace {

TEST(SampleColumns, HoldEveryValueOnceInOrder) {
  Random random(42);
  for (int i = 0; i < 30; ++i) {
    const Samples samples =
        testing::random_samples(1 + random.below(6), 1 + random.below(90), true, random);
    const SampleColumns columns(samples);
    std::vector<Signal> again;
    for (std::size_t s = 0; s < samples.count(); ++s) {
      std::vector<std::uint32_t> indices;
      std::vector<float> values;
      for (std::size_t c = 0; c < columns.elements().size(); ++c) {
        EXPECT_LT(columns.starts()[c], columns.starts()[c + 1]);
        for (std::uint32_t k = columns.starts()[c]; k < columns.starts()[c + 1]; ++k) {
          EXPECT_TRUE(k == columns.starts()[c] || columns.samples()[k - 1] < columns.samples()[k]);
          if (columns.samples()[k] != s) continue;
          indices.push_back(columns.elements()[c]);
          values.push_back(columns.values()[k]);
        }
      }
      EXPECT_TRUE(std::equal(indices.begin(), indices.end(), samples[s].indices.begin(),
                             samples[s].indices.end()));
      EXPECT_TRUE(std::equal(values.begin(), values.end(), samples[s].values.begin(),
                             samples[s].values.end()));
    }
  }
}

}  // namespace
}  // namespace somato
