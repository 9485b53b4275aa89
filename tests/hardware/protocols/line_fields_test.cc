#include "hardware/protocols/line_fields.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "base/support/no_malloc.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato::wire {
namespace {

const std::vector<LineName> kNames{{"a", 0}, {"b", 1}, {"c", 2}};

// The numbers in the order of the places, or the fault; a missing number is "-".
std::string fields_read(std::string_view line, const std::vector<LineName>& names = kNames) {
  LineFields fields(3, names);
  std::array<float, 3> values{};
  if (const auto fault = fields.read(line, values)) return fields.to_string(*fault);
  std::string text;
  for (const float value : values) {
    text +=
        (text.empty() ? "" : " ") + (std::isnan(value) ? "-" : std::to_string(std::lround(value)));
  }
  return text;
}

TEST(LineFields, AreSeparatedInEveryUsualWay) {
  for (const char* const line :
       {"1,-2,300", "1, -2, 300", " 1\t,-2 ,300 ", "1;-2;300", "1 ; -2; 300", "1 -2 300",
        "  1   -2  300 ", "1\t-2\t300", "1 \t-2\t 300\t", "1,-2,300,", "1;-2;300;", "1,-2,300 , ",
        "+1,-2.0,3e2"}) {
    EXPECT_EQ(fields_read(line), "1 -2 300") << line;
  }
}

TEST(LineFields, GoToTheirNames) {
  for (const char* const line :
       {"a:1,b:2,c:3", "c:3,a:1,b:2", "A:1,B:2,C:3", "a=1;b=2;c=3", "a: 1, b: 2, c: 3",
        "a:1 b:2 c:3", "c: 3 a: 1 b: 2", "a : 1\tb : 2\tc : 3", "a=1,b=2,c=3,", "x:9,c:3,b:2,a:1",
        "b:2,a:1,c:3,max:1023"}) {
    EXPECT_EQ(fields_read(line), "1 2 3") << line;
  }
  EXPECT_EQ(fields_read("left finger: 5 tip: 6", {{"left finger", 2}, {"tip", 0}}), "6 - 5");
}

// The exact name comes first; a name in another case only counts if one place remains.
TEST(LineFields, DistinguishNamesThatDifferInCaseOnly) {
  const std::vector<LineName> names{{"x", 0}, {"X", 1}, {"y", 2}};
  EXPECT_EQ(fields_read("X:2,Y:3,x:1", names), "1 2 3");
  const std::vector<LineName> twice{{"x", 0}, {"x", 1}, {"y", 2}};
  EXPECT_EQ(fields_read("x:1,y:3", twice),
            "the name of field 1 stands for elements of several sensors");
  const std::vector<LineName> shared{{"x", 0}, {"x", 0}, {"z", 0}, {"y", 1}};
  EXPECT_EQ(fields_read("x:1,y:3", shared), "1 3 -");
}

TEST(LineFields, TellWhereABoardHasNoNumber) {
  EXPECT_EQ(fields_read("1,nan,3"), "1 - 3");
  EXPECT_EQ(fields_read("NaN -inf OVF"), "- - -");
  EXPECT_EQ(fields_read("b:nan,a:1,c:3"), "1 - 3");
}

TEST(LineFields, SayWhyTheyAreNoValues) {
  const std::vector<std::pair<std::string, std::string>> lines{
      {"5,205,300,7", "4 fields instead of 3"},
      {"5,205", "2 fields instead of 3"},
      {"5", "1 field instead of 3"},
      {"5,205,,", "field 3 is empty"},
      {"1,,3", "field 2 is empty"},
      {",1,2", "field 1 is empty"},
      {"1,2,3,,", "4 fields instead of 3"},
      {"1,2,x", "field 3 is no number"},
      {"1,2,3x", "field 3 is no number"},
      {"1 2,3,4", "field 1 is no number"},
      {"1,2 uT,3", "field 2 is no number"},
      {"1e40,2,3", "field 1 is no number"},
      {"0x1,2,3", "field 1 is no number"},
      {"+-1,2,3", "field 1 is no number"},
      {"--1,2,3", "field 1 is no number"},
      {"1,5;2,5;3,5", "both commas and semicolons"},
      {"touch: 1,2,3", "field 2 has no name, but another has"},
      {"a:1,b:2", "the element 'c' is missing"},
      {"a:1,b:2,d:3", "the element 'c' is missing"},
      {"a:1,b:2,a:3", "the name of field 3 occurs twice"},
      {"a:1,b:,c:3", "field 2 is no number"},
      {"12:30:05 1 2", "field 1 is no number"},
  };
  for (const auto& [line, fault] : lines) EXPECT_EQ(fields_read(line), fault) << line;
  EXPECT_EQ(fields_read("a:1,b:2,c:3", {}),
            "it names its values, but no sensor has elements in these frames");
}

// The values of names in any order, of some of them and of others, are never another's.
TEST(LineFields, NeverGoToAnothersName) {
  Random random(1);
  std::vector<LineName> names;
  for (std::size_t i = 0; i < 5; ++i) names.push_back({"element_" + std::to_string(i), i});
  LineFields fields(5, names);
  std::vector<float> values(5);
  std::size_t accepted = 0;
  for (int trial = 0; trial < 20'000; ++trial) {
    std::string line;
    const std::size_t count = 4 + random.below(4);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t place = random.below(6);
      line += "element_" + std::to_string(place) + (random.below(2) == 0 ? ":" : "=") +
              std::to_string(100 + place) + (i + 1 < count ? "," : "");
    }
    if (fields.read(line, values)) continue;
    ++accepted;
    for (std::size_t i = 0; i < 5; ++i)
      ASSERT_EQ(values[i], 100.0F + static_cast<float>(i)) << line;
  }
  EXPECT_GT(accepted, 100U);
}

TEST(LineFields, AllocateNothing) {
  if (!testing::counts_allocations()) GTEST_SKIP() << "this build does not count allocations";
  LineFields fields(3, kNames);
  std::array<float, 3> values{};
  const testing::AllocationCounter allocations;
  for (const char* const line : {"1,2,3", "c:1 b:2 a:3", "1,2", "x", "a:1", "1;2,3"}) {
    static_cast<void>(fields.read(line, values));
  }
  EXPECT_EQ(allocations.count(), 0U);
}

TEST(LineFields, RefuseImpossibleArguments) {
  EXPECT_THROW(LineFields(0, {}), InvalidArgument);
  EXPECT_THROW(LineFields(2, {{"c", 2}}), InvalidArgument);
  std::array<float, 2> values{};
  EXPECT_THROW(static_cast<void>(LineFields(3, {}).read("1,2", values)), InvalidArgument);
}

}  // namespace
}  // namespace somato::wire
