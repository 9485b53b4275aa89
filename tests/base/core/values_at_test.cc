#include "base/core/values_at.h"

#include <gtest/gtest.h>

#include <string>

namespace somato {
namespace {

TEST(ValuesAt, AreInTheOrderOfThePlaces) {
  const std::vector<std::string> values{"a", "b", "c"};
  EXPECT_EQ(values_at(values, {2, 0, 2}), (std::vector<std::string>{"c", "a", "c"}));
  EXPECT_EQ(values_at(values, {}), std::vector<std::string>{});
}

}  // namespace
}  // namespace somato
