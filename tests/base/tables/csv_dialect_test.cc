#include "base/tables/csv_dialect.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

using Names = std::vector<std::string>;

// The separator, then the fields of the first record.
Names begun(const std::string& text, DecimalMark decimal = DecimalMark::kPoint,
            std::optional<char> given = {}) {
  CsvRecords records(text, "f");
  std::vector<CsvField> fields;
  const auto separator = begin_csv(records, decimal, given, fields);
  if (!separator) return {to_string(separator.error())};
  Names read{std::string(1, *separator)};
  for (const CsvField& field : fields) read.push_back(field.text);
  return read;
}

TEST(CsvDialect, IsDeclaredByALineOfSpreadsheets) {
  for (const char* text :
       {"sep=;\na,b;c\n", "SEP=;\r\na,b;c\r\n", "Sep=;\ra,b;c", "\"sep=;\"\na,b;c\n",
        "sep=;;\na,b;c\n", "# comment\n\nsep=;\na,b;c\n"}) {
    EXPECT_EQ(begun(text), (Names{";", "a,b", "c"})) << text;
  }
  EXPECT_EQ(begun("sep=,\na;b,c\n"), (Names{",", "a;b", "c"}));
  EXPECT_EQ(begun("sep=\t\na b\tc\n"), (Names{"\t", "a b", "c"}));
  EXPECT_EQ(begun("sep=|\na,b|c\n"), (Names{"|", "a,b", "c"}));
  EXPECT_EQ(begun("sep= \na b\n"), (Names{" ", "a", "b"}));
  EXPECT_EQ(begun("sep=;\n"), Names{";"}) << "nothing follows";
}

TEST(CsvDialect, IsNotDeclaredByOtherLines) {
  EXPECT_EQ(begun("sep=x\n1\n"), (Names{",", "sep=x"}));
  EXPECT_EQ(begun("sep=;a\n1;2\n"), (Names{";", "sep=", "a"}));
  EXPECT_EQ(begun("\"sep=;\n"), Names{"f:1:1: the quotation mark is not closed; close it, or write "
                                      "it twice if it belongs to the text"});
  EXPECT_EQ(begun("separator,b\n"), (Names{",", "separator", "b"}));
  CsvRecords records("a;b\nsep=,\n", "f");
  std::vector<CsvField> fields;
  ASSERT_TRUE(begin_csv(records, DecimalMark::kPoint, {}, fields));
  ASSERT_TRUE(records.next(';', fields));
  EXPECT_EQ(fields.at(0).text, "sep=,") << "it is not the first line";
}

TEST(CsvDialect, OfDecimalCommasHasOtherSeparators) {
  EXPECT_EQ(begun("1,5 2,5\n", DecimalMark::kComma), (Names{" ", "1,5", "2,5"}));
  EXPECT_EQ(begun("1,5\n", DecimalMark::kComma)[0].substr(0, 26), "f:1: commas separate the f");
  EXPECT_EQ(begun("sep=,\na,b\n", DecimalMark::kComma)[0].substr(0, 26),
            "f:2: commas separate the f");
}

TEST(CsvDialect, MayBeGiven) {
  EXPECT_EQ(begun("sep=,\na,b;c\n", DecimalMark::kPoint, ';'), (Names{";", "a,b", "c"}));
}

}  // namespace
}  // namespace somato
