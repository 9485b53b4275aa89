#include "base/files/toml_file.h"

#include <gtest/gtest.h>

#include <vector>

#include "base/support/temporary_folder.h"
#include "base/text/utf8.h"

namespace somato {
namespace {

Table table_of(const std::string& text) {
  Result<Table> table = parse_toml(text, "f");
  if (!table) ADD_FAILURE() << to_string(table.error());
  return table ? *table : Table{};
}

const Value& value_of(const Table& table, const std::string& name) {
  return std::get<Value>(table.find(name)->content);
}

void expect_toml_refused(const std::string& text, const std::string& where,
                         const std::string& because) {
  const Result<Table> table = parse_toml(text, "f");
  ASSERT_FALSE(table) << text.substr(0, 100);
  EXPECT_EQ(table.error().kind, ErrorKind::kUsage);
  EXPECT_EQ(table.error().where, where) << table.error().what;
  EXPECT_NE(table.error().what.find(because), std::string::npos) << table.error().what;
  EXPECT_FALSE(table.error().advice.empty());
}

TEST(TomlFile, ReadsEveryKindOfValue) {
  const Table table = table_of(
      "switch = true\nwhole = -15\nnumber = 0.5\ntext = 'a'\n"
      "list = [1, 2.5]\nnested = [[1], []]\nempty = []\n");
  EXPECT_EQ(value_of(table, "switch"), Value{true});
  EXPECT_EQ(value_of(table, "whole"), Value{std::int64_t{-15}});
  EXPECT_EQ(value_of(table, "number"), Value{0.5});
  EXPECT_EQ(value_of(table, "text"), Value{std::string("a")});
  EXPECT_EQ(value_of(table, "list"), (Value{Value::List{{std::int64_t{1}}, {2.5}}}));
  EXPECT_EQ(value_of(table, "nested"),
            (Value{Value::List{{Value::List{{std::int64_t{1}}}}, {Value::List{}}}}));
  EXPECT_EQ(value_of(table, "empty"), Value{Value::List{}});
}

TEST(TomlFile, KeepsOrderAndPlaces) {
  const Table table = table_of(
      "name = 'x'\n\n[zebra]\nb = 1\na = 2\n\n[[module]]\nkind = 'som'\n\n[[module]]\n"
      "kind = 'sum'\n\n[apple]\nx.y = 3\n");
  ASSERT_EQ(table.entries.size(), 4u);
  EXPECT_EQ(table.where, "f:1");
  EXPECT_EQ(table.entries[0].name, "name");
  EXPECT_EQ(table.entries[0].where, "f:1");
  EXPECT_EQ(table.entries[1].name, "zebra");
  EXPECT_EQ(table.entries[2].name, "module");
  EXPECT_EQ(table.entries[3].name, "apple");

  const Table& zebra = std::get<Table>(table.entries[1].content);
  EXPECT_EQ(zebra.where, "f:3");
  EXPECT_EQ(zebra.entries[0].name, "b");
  EXPECT_EQ(zebra.entries[1].where, "f:5");

  const auto& modules = std::get<std::vector<Table>>(table.entries[2].content);
  ASSERT_EQ(modules.size(), 2u);
  EXPECT_EQ(modules[1].where, "f:10");
  EXPECT_EQ(modules[1].entries[0].where, "f:11");

  const Table& x = std::get<Table>(std::get<Table>(table.entries[3].content).entries[0].content);
  EXPECT_EQ(x.entries[0].name, "y");
  EXPECT_EQ(x.entries[0].where, "f:14");
}

TEST(TomlFile, SaysWhereTheSyntaxIsWrong) {
  expect_toml_refused("a = 1\nb = \n", "f:2:5", "");
  expect_toml_refused("a = 'x\n", "f:1:7", "");
  const Error twice = parse_toml("a = 1\na = 2\n", "f").error();
  EXPECT_TRUE(twice.where.starts_with("f:2:")) << twice.where;
  EXPECT_NE(twice.what.find("redefine existing integer 'a'"), std::string::npos) << twice.what;
}

TEST(TomlFile, KnowsLettersOutsideAsciiFromBlanks) {
  expect_toml_refused("gr\xC3\xB6\xC3\x9F = 1\n", "f:1:3", "saw '\xC3\xB6'");
  expect_toml_refused("b = 1\na = 1 \xC3\xA4\n", "f:2:7", "saw '\xC3\xA4'");
  EXPECT_FALSE(parse_toml("a = 1\xD2\x99\n", "f"));
  EXPECT_EQ(value_of(table_of("a = \"\"\"x\\\n  \xC3\xA4\"\"\"\n'\xC3\xA4' = 1\n"), "a"),
            Value{std::string("x\xC3\xA4")});
  EXPECT_EQ(table_of("['\xC3\xA4']\n").entries[0].name, "\xC3\xA4");
}

// The characters of the Basic Multilingual Plane at which ranges that toml++ tests begin or end,
// and every 61st other one.
std::vector<char32_t> sampled_characters() {
  std::vector<char32_t> sampled = {0x499,  0x49A,  0x1680, 0x2000, 0x200B, 0x2028,
                                   0x2C5D, 0x2C5E, 0x3000, 0x3001, 0x3057, 0x3058,
                                   0xFB25, 0xFB26, 0xFEFE, 0xFEFF, 0xFF00, 0xFFFF};
  for (char32_t code = 0x80; code < 0xD800; code += 61) sampled.push_back(code);
  return sampled;
}

// The behaviour of toml++ is undefined for some of them (toml_letters.h).
TEST(TomlFile, RefusesEveryLetterWhereNoneIsAllowed) {
  for (const char32_t code : sampled_characters()) {
    std::string letter;
    append_character(letter, code);
    for (const std::string before : {"x",
                                     "x.",
                                     "x = ",
                                     "x = 1",
                                     "x = 1e",
                                     "x = 1.\"",
                                     "x = 0x",
                                     "x = t",
                                     "x = inf",
                                     "x = 1 ",
                                     "x = [1",
                                     "x = {a = 1",
                                     "x = 2020-01-01",
                                     "x = 2020-01-01T00:00",
                                     "x = \"\\",
                                     "x = \"\"\"\\",
                                     "x = \"\"\"\\ ",
                                     "[",
                                     "[x",
                                     "[x] "}) {
      EXPECT_FALSE(parse_toml(before + letter + "\n", "f")) << before << letter;
    }
  }
}

TEST(TomlFile, ReadsEveryLetterInQuotationMarks) {
  for (const char32_t code : sampled_characters()) {
    if (code < 0xA0) continue;  // Control characters.
    std::string letter;
    append_character(letter, code);
    const Table table = table_of("# " + letter + "\n\"" + letter + "\" = '" + letter + "'\n");
    EXPECT_EQ(value_of(table, letter), Value{letter}) << letter;
  }
}

// toml++ asserts that a table's name begins with a letter or a quotation mark.
TEST(TomlFile, RefusesTablesWithoutAName) {
  for (const char* text : {"[=]", "[.]", "[!]", "[\xC3\xA4]", "[,"}) {
    expect_toml_refused(text, "f:1:2", "expected bare key starting character");
  }
  expect_toml_refused("[ =]", "f:1:3", "expected bare key starting character");
  expect_toml_refused("[[=]]", "f:1:3", "expected bare key starting character");
}

TEST(TomlFile, RefusesCharactersThatUnicodeDoesNotAssign) {
  expect_toml_refused("a = 1\nb\xC3\xA4 = '\xF3\x80\x80\x80'\n", "f:2:7", "U+C0000");
  expect_toml_refused("a = \"\\U000C00E4\"\n", "f:1:6", "U+C0000");
}

TEST(TomlFile, RefusesWhatDescriptionsDoNotUse) {
  expect_toml_refused("a = 2020-01-01\n", "f:1:5", "dates and times");
  expect_toml_refused("a = [07:30:00]\n", "f:1:6", "dates and times");
  expect_toml_refused("a = [1, 'x']\n", "f:1:9", "mixes types");
  expect_toml_refused("a = [1, true]\n", "f:1:9", "mixes types");
  expect_toml_refused("a = [{b = 1}, 2]\n", "f:1:6", "array of values contains a table");
  expect_toml_refused("a = [[{b = 1}]]\n", "f:1:7", "array of values contains a table");
}

std::string repeated(const std::string& piece, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += piece;
  return text;
}

TEST(TomlFile, RefusesWhatIsTooDeepOrTooLarge) {
  EXPECT_TRUE(parse_toml("a = " + repeated("[", 15) + repeated("]", 15), "f"));
  expect_toml_refused("a = " + repeated("[", 17) + repeated("]", 17), "f:1:21", "16 levels");
  expect_toml_refused("a = " + repeated("{a=", 17) + "1" + repeated("}", 17), "f:1:53",
                      "16 levels");
  EXPECT_FALSE(parse_toml("a = " + repeated("[", 1000000), "f"));
  EXPECT_FALSE(parse_toml("a = " + repeated("{a=", 1000000), "f"));
  expect_toml_refused("\n" + repeated("a.", 1000000) + "a = 1", "f:2", "parts");
  expect_toml_refused("#" + std::string(16 << 20, ' '), "f", "larger than");
}

// The content of a table without its locations.
std::string content_of(const Table& table) {
  std::string text = "{";
  for (const Table::Entry& entry : table.entries) {
    text += entry.name + ":";
    if (const auto* value = std::get_if<Value>(&entry.content)) text += to_toml(*value);
    if (const auto* inner = std::get_if<Table>(&entry.content)) text += content_of(*inner);
    if (const auto* list = std::get_if<std::vector<Table>>(&entry.content)) {
      for (const Table& one : *list) text += "-" + content_of(one);
    }
    text += ";";
  }
  return text + "}";
}

TEST(TomlFile, IsWrittenAsItIsRead) {
  const std::string text =
      "a = 1\nb = [0.1, 2.0]\n\"odd key\" = \"line\\nend\"\n[c]\nx = true\n[c.\"d.e\"]\ny = 1e300\n"
      "[[f]]\nz = -1\n[f.g]\nw = \"\"\n[[f]]\n[[f.h]]\nv = 2\n[empty]\n";
  const Table table = parse_toml(text, "a.toml").value();
  const auto again = parse_toml(to_toml(table), "b.toml");
  ASSERT_TRUE(again) << to_string(again.error()) << to_toml(table);
  EXPECT_EQ(content_of(*again), content_of(table));
  EXPECT_EQ(to_toml(*again), to_toml(table));
}

// A value after a table would be one of the table.
TEST(TomlFile, ValuesAreWrittenBeforeTables) {
  const Table table{
      "", {{"t", "", Table{"", {{"x", "", Value{std::int64_t{1}}}}}}, {"a", "", Value{true}}}};
  EXPECT_EQ(to_toml(table), "a = true\n\n[t]\nx = 1\n");
}

TEST(TomlFile, IsReadFromAFile) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_toml(folder.with("a.toml", "a = 1\n"))->entries[0].where,
            folder.file("a.toml") + ":1");
  EXPECT_EQ(read_toml(folder.file("missing")).error().kind, ErrorKind::kSystem);
}

}  // namespace
}  // namespace somato
