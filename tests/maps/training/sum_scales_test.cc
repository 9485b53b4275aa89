#include "maps/training/sum_scales.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "somato/core/random.h"

namespace somato {
namespace {

TEST(SumScales, KeepValuesOfFewSamplesExactly) {
  const SumScales scales(3, std::vector<float>{-0.75F, 0.0F, 1e-30F},
                         std::vector<float>{0.5F, 0.0F, 2e-30F});
  for (const float value : {-0.75F, 0.5F, 0x1.fffffep-20F, 0.0F}) {
    EXPECT_EQ(scales.number(0, scales.integer(0, value)), double{value});
  }
  EXPECT_EQ(scales.integer(0, 0.5F), std::int64_t{1} << 50);  // 0.75 is below 2^51
  EXPECT_EQ(scales.integer(1, 0.0F), 0);
  EXPECT_EQ(scales.number(2, scales.integer(2, 1.5e-30F)), double{1.5e-30F});
  EXPECT_EQ(scales.number(3, 17), 17.0);  // the place of counts
}

TEST(SumScales, RoundByHalfOfTheirLastPlaceAndStayBelow2To62) {
  const float greatest = std::nextafter(4.0F, 0.0F);
  for (const std::size_t samples : {1UL, 1000UL, 1UL << 20, (1UL << 40) - 1}) {
    const SumScales scales(samples, std::vector<float>{-greatest}, std::vector<float>{1.0F});
    const double most = static_cast<double>(scales.integer(0, -greatest));
    EXPECT_LT(-most * static_cast<double>(samples), 0x1p62);
    const int bits =
        std::min(51, 62 - static_cast<int>(std::ceil(std::log2(static_cast<double>(samples) + 1))));
    Random random(4);
    for (int i = 0; i < 100; ++i) {
      const float value = static_cast<float>(8.0 * random.uniform() - 4.0);
      EXPECT_LE(std::fabs(scales.number(0, scales.integer(0, value)) - double{value}),
                std::ldexp(4.0, -bits) / 2.0);
    }
  }
}

TEST(SumScales, TakeTheWholeRangeOfSinglePrecision) {
  const float least = std::numeric_limits<float>::denorm_min();
  const float most = std::numeric_limits<float>::max();
  const SumScales scales(2, std::vector<float>{0.0F, -most}, std::vector<float>{least, most});
  EXPECT_EQ(scales.number(0, scales.integer(0, least)), double{least});
  EXPECT_EQ(scales.number(1, 2 * scales.integer(1, most)), 2.0 * double{most});
}

}  // namespace
}  // namespace somato
