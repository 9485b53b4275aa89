#include "somato/core/value.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "somato/core/random.h"

namespace somato {
namespace {

TEST(Value, IsWrittenAsTomlWritesIt) {
  EXPECT_EQ(to_toml({true}), "true");
  EXPECT_EQ(to_toml({std::int64_t{-15}}), "-15");
  EXPECT_EQ(to_toml({std::string("plane")}), "\"plane\"");
  EXPECT_EQ(to_toml({Value::List{{std::int64_t{1}}, {0.5}, {Value::List{}}}}), "[1, 0.5, []]");
}

TEST(Value, KeepsNumbersAndIntegersApart) {
  EXPECT_EQ(to_toml({2.0}), "2.0");
  EXPECT_EQ(to_toml({std::int64_t{2}}), "2");
  EXPECT_EQ(to_toml({-0.0}), "-0.0");
  EXPECT_EQ(to_toml({1e300}), "1e+300");
}

TEST(Value, WritesWhatIsNotFiniteAsTomlDoes) {
  EXPECT_EQ(to_toml({std::numeric_limits<double>::infinity()}), "inf");
  EXPECT_EQ(to_toml({-std::numeric_limits<double>::infinity()}), "-inf");
  EXPECT_EQ(to_toml({std::nan("")}), "nan");
}

TEST(Value, EscapesText) {
  EXPECT_EQ(to_toml({std::string("a\"b\\c\n\x7F")}), R"("a\"b\\c\u000A\u007F")");
  EXPECT_EQ(to_toml({std::string("größe")}), "\"größe\"");
}

TEST(Value, GivesTheSameBitsWhenANumberIsReadBack) {
  Random random(5);
  for (int trial = 0; trial < 10000; ++trial) {
    const int exponent = static_cast<int>(random.below(1800)) - 900;
    const double number = std::ldexp(random.normal(), exponent);
    EXPECT_EQ(std::strtod(to_toml({number}).c_str(), nullptr), number);
  }
}

TEST(Table, FindsItsEntries) {
  const Table table{"a.toml:1", {{"rows", "a.toml:2", Value{std::int64_t{15}}}}};
  ASSERT_NE(table.find("rows"), nullptr);
  EXPECT_EQ(table.find("rows")->where, "a.toml:2");
  EXPECT_EQ(table.find("row"), nullptr);
}

TEST(NearestName, IsTheOneWithTheFewestEdits) {
  const std::vector<std::string> known{"rows", "columns", "learning_rate"};
  EXPECT_EQ(nearest_name("row", known), "rows");
  EXPECT_EQ(nearest_name("colums", known), "columns");
  EXPECT_EQ(nearest_name("learn_rate", known), "learning_rate");
  EXPECT_EQ(nearest_name("rows", {"cows", "rows"}), "rows");
  EXPECT_EQ(nearest_name("bows", {"cows", "rows"}), "cows");  // the first of equals
}

TEST(NearestName, IsNothingWhenNoneIsMeant) {
  EXPECT_EQ(nearest_name("topology", {"rows", "columns"}), "");
  EXPECT_EQ(nearest_name("map", {"som"}), "");
  EXPECT_EQ(nearest_name("rows", {}), "");
}

TEST(NameAdvice, NamesTheNearestOrAll) {
  EXPECT_EQ(name_advice("row", {"rows", "columns"}), "did you mean 'rows'?");
  EXPECT_EQ(name_advice("topology", {"rows", "columns"}), "known are: rows, columns");
}

}  // namespace
}  // namespace somato
