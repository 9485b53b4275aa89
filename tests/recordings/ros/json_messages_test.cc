#include "recordings/ros/json_messages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "recordings/ros/channel_reader.h"

namespace somato {
namespace {

using Values = std::vector<double>;

constexpr const char* kHand = R"({"type": "object", "properties": {
  "name": {"type": "array", "items": {"type": "string"}},
  "position": {"type": "array", "items": {"type": "number"}},
  "is_held": {"type": "boolean"},
  "stamp": {"$ref": "#/definitions/time"},
  "force": {"oneOf": [{"type": "null"}, {"type": "number"}]},
  "count": {"type": ["null", "integer"]},
  "skin": {"type": "array", "items": {"type": "array", "items": {"type": "number"}}},
  "any": {}, "more": {"type": "array"}},
  "definitions": {"time": {"type": "object", "properties": {"sec": {"type": "integer"}}}}})";

std::shared_ptr<const RosType> compiled_schema(const std::string& schema) {
  auto type = compile_json_schema("a.Hand", schema);
  EXPECT_TRUE(type) << (type ? "" : to_string(type.error()));
  return std::make_shared<const RosType>(std::move(type).value());
}

Values values_at(const std::string& path, const std::string& message) {
  const auto type = compiled_schema(kHand);
  const ChannelReader reader = ChannelReader::compile(type, {path}).value();
  Values values;
  EXPECT_TRUE(reader.read(cdr_of_json(*type, message).value(), values));
  return values;
}

TEST(JsonMessages, PathsReadThemAsThoseOfRos) {
  const std::string message =
      R"({"position": [0.5, 2], "is_held": true, "stamp": {"sec": 7}, "force": 1.5, "count": 3,
          "skin": [[1, 2], [3]], "any": {}, "unknown": 4})";
  EXPECT_EQ(values_at("position", message), (Values{0.5, 2}));
  EXPECT_EQ(values_at("is_held", message), Values{1});
  EXPECT_EQ(values_at("stamp.sec", message), Values{7});
  EXPECT_EQ(values_at("force", message), Values{1.5});
  EXPECT_EQ(values_at("count", message), Values{3});
  EXPECT_EQ(values_at("skin[*].items", message), (Values{1, 2, 3}));
  EXPECT_EQ(values_at("skin[1].items[0]", message), Values{3});
}

TEST(JsonMessages, NamesPlaceValues) {
  const auto type = compiled_schema(kHand);
  const ChannelReader reader = ChannelReader::compile(type, {"position[b,a]"}).value();
  ElementOrder order = reader.order();
  Values values;
  const auto message = cdr_of_json(*type, R"({"name": ["a", "b"], "position": [1, 2]})").value();
  EXPECT_TRUE(reader.read(message, order, values).value());
  EXPECT_EQ(values, (Values{2, 1}));
}

TEST(JsonMessages, WhatIsMissingIsNoNumber) {
  for (const std::string message :
       {"{}", R"({"force": null})", R"({"force": "1.5"})", R"({"force": [1.5]})"}) {
    EXPECT_TRUE(std::isnan(values_at("force", message).at(0))) << message;
  }
  const Values values = values_at("position", R"({"position": [1, null, "x"]})");
  ASSERT_EQ(values.size(), 3U);
  EXPECT_TRUE(std::isnan(values[1]) && std::isnan(values[2]));
  EXPECT_TRUE(values_at("position", R"({"position": 3})").empty());
}

TEST(JsonMessages, OtherTextsAreRefused) {
  const auto type = compiled_schema(kHand);
  for (const std::string message : {"", "[]", "3", "{", "{\"position\": [1,]}"}) {
    EXPECT_FALSE(cdr_of_json(*type, message)) << message;
  }
  for (const std::string schema :
       {"", "3", "{}", R"({"type": "array"})", R"({"type": "number"})",
        R"({"type": "object", "properties": {"a": {"$ref": "#/b"}}})",
        R"({"type": "object", "properties": {"a": {"$ref": "#"}}})",
        R"({"type": "object", "properties": {"a": {"$ref": "#/properties/a"}}})"}) {
    EXPECT_FALSE(compile_json_schema("a", schema)) << schema;
  }
  EXPECT_TRUE(compile_json_schema("a", R"({"type": "object"})"));
}

}  // namespace
}  // namespace somato
