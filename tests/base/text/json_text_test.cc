#include "base/text/json_text.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace somato {
namespace {

using OrderedJson = nlohmann::ordered_json;

std::string times_over(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

std::string json_error(const std::string& text) {
  const auto json = parse_json<OrderedJson>(text, "a.json", "repair it");
  if (json) return "";
  EXPECT_EQ(json.error().kind, ErrorKind::kData);
  EXPECT_EQ(json.error().advice, "repair it");
  return json.error().where + ": " + json.error().what;
}

TEST(JsonText, IsReadInTheOrderOfItsText) {
  const auto json = parse_json<OrderedJson>(R"({"b": 1, "a": [true, null, "x"]})", "a.json", "");
  ASSERT_TRUE(json);
  EXPECT_EQ(json->begin().key(), "b");
  EXPECT_EQ(json->at("a"), OrderedJson::array({true, nullptr, "x"}));
}

TEST(JsonText, ErrorsSayWhere) {
  EXPECT_EQ(json_error(""), "a.json:1:1: not valid JSON: it ends too early");
  EXPECT_EQ(json_error("{\n  \"a\": 1"), "a.json:2:9: not valid JSON: it ends too early");
  EXPECT_EQ(json_error("{\n  \"a\": ]"), "a.json:2:8: not valid JSON");
  EXPECT_EQ(json_error("[1e999]"), "a.json: a number is out of range");
}

// Copies of nested values call themselves once a level: 100,000 levels ended in a crash.
TEST(JsonText, IsNestedAsDeeplyAsAllowedAndNoDeeper) {
  EXPECT_EQ(json_error(times_over("[", 16) + times_over("]", 16)), "");
  EXPECT_EQ(json_error(times_over("[", 17) + times_over("]", 17)),
            "a.json:1:17: the JSON has more than 16 levels of nesting");
  EXPECT_EQ(json_error(R"({"x":)" + times_over("[", 100000) + times_over("]", 100000) +
                       R"(,"a":1,"b":2})"),
            "a.json:1:21: the JSON has more than 16 levels of nesting");
  EXPECT_EQ(json_error(times_over("{\"a\":", 1000000)),
            "a.json:1:81: the JSON has more than 16 levels of nesting");
}

TEST(JsonText, BracketsInTextsDoNotNest) {
  const std::string brackets = times_over("[", 50);
  EXPECT_EQ(json_error("[\"" + brackets + "\", \"\\\"" + brackets + "\"]"), "");
}

TEST(JsonText, ListsSideBySideDoNotNest) {
  EXPECT_EQ(json_error("[" + times_over("[],", 1000) + "[]]"), "");
}

}  // namespace
}  // namespace somato
