#include "views/curves/curve_point.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

TEST(CurvePoint, ReadsNumbersInTomlNotationOnly) {
  EXPECT_EQ(detail::number_in("0.25"), 0.25);
  EXPECT_EQ(detail::number_in("15"), 15.0);
  for (const char* text : {"", "\"15\"", "[1]", "nan", "inf", "1.5 mm", "true"}) {
    EXPECT_EQ(detail::number_in(text), std::nullopt) << text;
  }
}

TEST(CurvePoint, HasTheMeanAndTheValues) {
  const auto json = detail::point_json(2.0, {"accuracy", {0.5, 1.0}});
  EXPECT_EQ(json["x"], 2.0);
  EXPECT_EQ(json["mean"], 0.75);
  EXPECT_NEAR(json["sd"].get<double>(), 0.353553, 1e-6);
  EXPECT_EQ(json["values"].size(), 2U);
}

}  // namespace
}  // namespace somato
