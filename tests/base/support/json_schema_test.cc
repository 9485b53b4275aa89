#include "base/support/json_schema.h"

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace somato {
namespace {

using testing::fits_schema;
using testing::JsonSchemas;
using testing::text_fits_schema;
using Problems = std::vector<std::string>;

// One file, a.json.
JsonSchemas schemas_of(const std::string& schema) {
  std::map<std::string, nlohmann::json> files;
  files["a.json"] = nlohmann::json::parse(schema);
  return JsonSchemas(std::move(files));
}

Problems problems_of(const std::string& schema, const std::string& value) {
  return schemas_of(schema).problems(nlohmann::json::parse(value), "a.json");
}

// A value that is valid, one that is not, and what is said of it.
struct Sample {
  const char* name;
  const char* schema;
  const char* valid;
  const char* invalid;
  const char* problem;
};

class JsonSchemaKeyword : public ::testing::TestWithParam<Sample> {};

TEST_P(JsonSchemaKeyword, SeparatesValidFromInvalid) {
  const Sample& sample = GetParam();
  EXPECT_EQ(problems_of(sample.schema, sample.valid), Problems{});
  EXPECT_EQ(problems_of(sample.schema, sample.invalid), Problems{sample.problem});
}

constexpr const char* kThing = R"({"type": "object", "required": ["size"],
    "additionalProperties": false,
    "properties": {"size": {"type": "number"}, "name": {"type": "string"}}})";

INSTANTIATE_TEST_SUITE_P(
    Each, JsonSchemaKeyword,
    ::testing::Values(
        Sample{"text", R"({"type": "string"})", R"("1")", "1", "the whole is number, not string"},
        Sample{"number", R"({"type": "number"})", "1.5", "null", "the whole is null, not number"},
        Sample{"integer", R"({"type": "integer"})", "-3", "1.5",
               "the whole is number, not integer"},
        Sample{"boolean", R"({"type": "boolean"})", "false", "0",
               "the whole is number, not boolean"},
        Sample{"or_null", R"({"type": ["integer", "null"]})", "null", "\"\"",
               "the whole is string, not integer or null"},
        Sample{"constant", R"({"const": 1})", "1", "2", "the whole is not 1"},
        Sample{"choices", R"({"enum": ["a", 0]})", "0", R"("0")",
               R"(the whole is "0", not one of ["a",0])"},
        Sample{"least", R"({"minimum": 0})", "0", "-1", "the whole is -1, below 0"},
        Sample{"most", R"({"maximum": 1})", "1", "1.5", "the whole is 1.5, above 1"},
        Sample{"items", R"({"type": "array", "items": {"type": "number"}})", "[1, 2]", "[1, [2]]",
               "/1 is array, not number"},
        Sample{"few_items", R"({"minItems": 2})", "[1, 2]", "[1]", "the whole has only 1 items"},
        Sample{"many_items", R"({"maxItems": 2})", "[1, 2]", "[1, 2, 3]", "the whole has 3 items"},
        Sample{"added", kThing, R"({"size": 1, "name": ""})", R"({"size": 1, "colour": 2})",
               "/colour is unknown"},
        Sample{"removed", kThing, R"({"size": 1})", R"({"name": ""})", R"(the whole lacks "size")"},
        Sample{"changed", kThing, R"({"size": 1})", R"({"size": 1, "name": 2})",
               "/name is number, not string"},
        Sample{"values", R"({"additionalProperties": {"type": "number"}})", R"({"a": 1})",
               R"({"a": 1, "b": "2"})", "/b is string, not number"},
        Sample{"referred", R"({"$ref": "#/$defs/A", "$defs": {"A": {"type": "null"}}})", "null",
               "1", "the whole is number, not null"}),
    [](const auto& test) { return test.param.name; });

TEST(JsonSchema, AnAlternativeIsEnough) {
  const std::string either = R"({"anyOf": [{"type": "null"}, {"items": {"type": "number"},
                                                              "type": "array"}]})";
  EXPECT_EQ(problems_of(either, "null"), Problems{});
  EXPECT_EQ(problems_of(either, "[1]"), Problems{});
  EXPECT_EQ(problems_of(either, R"(["1"])"),
            (Problems{"the whole is array, not null", "/0 is string, not number"}));
}

TEST(JsonSchema, ARenamedFieldIsMissingAndUnknown) {
  EXPECT_EQ(problems_of(kThing, R"({"length": 1})"),
            (Problems{R"(the whole lacks "size")", "/length is unknown"}));
}

TEST(JsonSchema, RefersToOtherFilesAndBack) {
  std::map<std::string, nlohmann::json> files;
  files["a.json"] = nlohmann::json::parse(R"({"$defs": {"Own": {"$ref": "b.json#/$defs/Other"}}})");
  files["b.json"] =
      nlohmann::json::parse(R"({"$defs": {"Other": {"items": {"$ref": "#/$defs/Item"}},
                                              "Item": {"type": "string"}}})");
  const JsonSchemas schemas(std::move(files));
  EXPECT_EQ(schemas.problems(nlohmann::json::parse("[\"a\"]"), "a.json#/$defs/Own"), Problems{});
  EXPECT_EQ(schemas.problems(nlohmann::json::parse("[1]"), "a.json#/$defs/Own"),
            Problems{"/0 is number, not string"});
  EXPECT_THROW(schemas.problems(nullptr, "a.json#/$defs/Item"), std::invalid_argument);
  EXPECT_THROW(schemas.problems(nullptr, "c.json"), std::invalid_argument);
}

std::string refusal(const std::string& schema) {
  try {
    static_cast<void>(schemas_of(schema));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(JsonSchema, RefusesKeywordsThatItDoesNotKnowWhereverTheyAre) {
  EXPECT_EQ(refusal(R"({"pattern": "a"})"), "a.json#/pattern: is an unknown keyword");
  EXPECT_EQ(refusal(R"({"$defs": {"A": {"items": {"format": "date"}}}})"),
            "a.json#/$defs/A/items/format: is an unknown keyword");
  EXPECT_EQ(refusal(R"({"anyOf": [{"type": "null"}, {"not": {}}]})"),
            "a.json#/anyOf/1/not: is an unknown keyword");
  EXPECT_EQ(refusal(R"({"additionalProperties": {"uniqueItems": true}})"),
            "a.json#/additionalProperties/uniqueItems: is an unknown keyword");
}

TEST(JsonSchema, RefusesWhatAKeywordDoesNotTake) {
  EXPECT_EQ(refusal(R"({"type": "text"})"), "a.json#/type: 'text' is no type");
  EXPECT_EQ(refusal(R"({"minimum": "0"})"), "a.json#/minimum: is string");
  EXPECT_EQ(refusal(R"({"items": [{"type": "null"}]})"), "a.json#/items: a schema is an object");
  EXPECT_EQ(refusal(R"({"additionalProperties": true})"),
            "a.json#/additionalProperties: a schema is an object");
  EXPECT_EQ(refusal(R"({"items": {"$ref": "#/$defs/A"}})"),
            "a.json: '#/$defs/A' refers to nothing");
}

// Fields that were added would pass unseen.
TEST(JsonSchema, RefusesAnObjectThatAdmitsAnything) {
  const std::string problem = "an object states its additionalProperties";
  EXPECT_EQ(refusal(R"({"type": "object"})"), "a.json#: " + problem);
  EXPECT_EQ(refusal(R"({"items": {"properties": {}}})"), "a.json#/items: " + problem);
}

TEST(JsonSchema, OfThePagesIsThatOfTheirFolder) {
  const nlohmann::json grid{
      {"rows", 2}, {"columns", 3}, {"lattice", "hexagonal"}, {"topology", "torus"}};
  EXPECT_TRUE(fits_schema(grid, "parts.json#/$defs/GridData"));
  EXPECT_FALSE(fits_schema(grid, "parts.json#/$defs/Labels"));
  EXPECT_TRUE(text_fits_schema(grid.dump(), "parts.json#/$defs/GridData"));
  EXPECT_FALSE(text_fits_schema(grid.dump() + "}", "parts.json#/$defs/GridData"));
}

}  // namespace
}  // namespace somato
