#include "base/text/json_table.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

namespace somato {
namespace {

using OrderedJson = nlohmann::ordered_json;

Table::Entry with(const char* name, Value value) {
  return {name, "", std::move(value)};
}

OrderedJson written(const Table& table) {
  const std::string text = to_json(table);
  EXPECT_TRUE(text.ends_with("}\n"));
  return OrderedJson::parse(text);
}

TEST(JsonTable, KeepsOrderTypesAndBits) {
  const double tenth = 0.1;
  const Table row{"", {with("text", {std::string("a \"b\"\n")}), with("whole", {std::int64_t{3}})}};
  const Table table{"",
                    {with("z", {true}),
                     with("a", {tenth}),
                     with("list", {Value::List{{1.5}, {std::string("x")}}}),
                     {"rows", "", std::vector<Table>{row, Table{}}},
                     {"table", "", row}}};
  const OrderedJson json = written(table);
  EXPECT_EQ(json.begin().key(), "z");
  EXPECT_EQ(json["z"], true);
  EXPECT_EQ(json["a"].get<double>(), tenth);
  EXPECT_EQ(json["list"], OrderedJson::array({1.5, "x"}));
  EXPECT_EQ(json["rows"][0]["text"], "a \"b\"\n");
  EXPECT_TRUE(json["rows"][0]["whole"].is_number_integer());
  EXPECT_EQ(json["rows"][1], OrderedJson::object());
  EXPECT_EQ(json["table"]["whole"], 3);
}

TEST(JsonTable, HasNullForWhatJsonLacksAndStaysUtf8) {
  const OrderedJson json = written({"",
                                    {with("none", {std::numeric_limits<double>::infinity()}),
                                     with("bytes", {std::string("a\xFF")})}});
  EXPECT_TRUE(json["none"].is_null());
  EXPECT_EQ(json["bytes"], "a\xEF\xBF\xBD");
}

}  // namespace
}  // namespace somato
