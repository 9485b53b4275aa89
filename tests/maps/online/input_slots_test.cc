#include "maps/online/input_slots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "somato/core/random.h"

namespace somato {
namespace {

double product(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0.0;
  for (std::size_t d = 0; d < a.size(); ++d) sum += double{a[d]} * double{b[d]};
  return sum;
}

// Written, and some of them overwritten.
TEST(InputSlots, GiveInputsAndTheirProducts) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const std::size_t columns = 1 + random.below(i % 4 == 0 ? 900 : 100);
    const std::size_t count = 2 + random.below(kernels::kPending - 1);
    std::vector<std::vector<float>> values(count, std::vector<float>(columns));
    InputSlots slots(columns);
    for (const std::size_t first : {std::size_t{0}, random.below(count)}) {
      for (std::size_t j = first; j < count; ++j) {
        for (float& value : values[j]) value = static_cast<float>(random.normal());
      }
      slots.write(first, {values.begin() + static_cast<std::ptrdiff_t>(first), values.end()});
    }
    for (std::size_t j = 0; j < count; ++j) {
      double greatest = 0.0;
      for (std::size_t d = 0; d < columns; ++d) {
        EXPECT_EQ(slots.input(j)[d], values[j][d]);
        EXPECT_EQ(slots.rows(j, d).first[0], values[j][d]);
        EXPECT_EQ(slots.rows(0, d).first[j * slots.rows(0, d).stride], values[j][d]);
        greatest = std::max(greatest, std::fabs(double{values[j][d]}));
      }
      slots.measure(j);
      EXPECT_EQ(slots.greatest(j), greatest);
      std::vector<float> products(j + 1);
      slots.multiply(j, j + 1, 1 + random.below(columns), products.data());
      for (std::size_t k = 0; k <= j; ++k) {
        const double most =
            std::sqrt(product(values[j], values[j]) * product(values[k], values[k]));
        EXPECT_NEAR(double{products[k]}, product(values[j], values[k]), 1e-5 * most);
      }
    }
  }
}

}  // namespace
}  // namespace somato
