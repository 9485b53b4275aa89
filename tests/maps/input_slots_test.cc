#include "maps/input_slots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "somato/core/random.h"

namespace somato {
namespace {

TEST(InputSlots, GiveInputsInBothOrders) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const std::size_t columns = 1 + random.below(100);
    const std::size_t count = 1 + random.below(4);
    const std::size_t first = random.below(kernels::kPending - count + 1);
    std::vector<std::vector<float>> values(count, std::vector<float>(columns));
    for (auto& input : values) {
      for (float& value : input) value = static_cast<float>(random.normal());
    }
    InputSlots slots(columns);
    slots.write(first, {values.begin(), values.end()});
    slots.write_lanes(first, count);
    for (std::size_t j = 0; j < count; ++j) {
      double greatest = 0.0;
      for (std::size_t d = 0; d < columns; ++d) {
        EXPECT_EQ(slots.input(first + j)[d], values[j][d]);
        EXPECT_EQ(slots.lanes(d)[first + j], values[j][d]);
        greatest = std::max(greatest, std::fabs(double{values[j][d]}));
      }
      EXPECT_EQ(slots.greatest(first + j), greatest);
    }
  }
}

}  // namespace
}  // namespace somato
