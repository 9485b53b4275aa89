#include "somato/files/csv.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "base/support/temporary_folder.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using Names = std::vector<std::string>;

Matrix<float> matrix(std::size_t rows, std::vector<float> values) {
  const std::size_t columns = values.size() / rows;
  return Matrix<float>(rows, columns, std::move(values));
}

CsvOptions label(const std::string& column) {
  CsvOptions options;
  options.label_column = column;
  return options;
}

CsvOptions decimal_comma() {
  CsvOptions options;
  options.decimal = DecimalMark::kComma;
  return options;
}

const NumberTable kPlain{{}, matrix(2, {1, 2, 3, 4}), {}};

TEST(Csv, FindsOutTheSeparator) {
  for (const char* text : {"1,2\n3,4\n", "1;2\n3;4\n", "1\t2\n3\t4\n", "1 2\n3 4\n",
                           "  1   2  \n3 \t 4\n", "1, 2\n3 ,4\n", "1 ;2\n3; 4\n"}) {
    EXPECT_EQ(parse_csv(text, "f"), kPlain) << text;
  }
  EXPECT_EQ(parse_csv("1\n2\n", "f")->values, matrix(2, {1, 2}));
}

TEST(Csv, TakesAGivenSeparator) {
  CsvOptions options;
  options.separator = ';';
  EXPECT_EQ(parse_csv("a,b;c\n1;2\n", "f", options)->names, (Names{"a,b", "c"}));
  options.separator = 'x';
  EXPECT_THROW((void)parse_csv("1x2", "f", options), InvalidArgument);
}

TEST(Csv, TakesADeclaredSeparator) {
  EXPECT_EQ(parse_csv("sep=;\r\n1;2\r\n3;4\r\n", "f"), kPlain);
  EXPECT_EQ(parse_csv("\xEF\xBB\xBFsep=;\n1;2\n3;4\n", "f"), kPlain);
  EXPECT_EQ(parse_csv("sep=;\n1,5;2\n3;4\n", "f", decimal_comma())->values,
            matrix(2, {1.5f, 2, 3, 4}));
  EXPECT_EQ(to_string(parse_csv("sep=;\n1;2\n3;x\n", "f").error()).substr(0, 6), "f:3:3:");
}

// The index that pandas writes, and what others write like it.
TEST(Csv, RefusesFeaturesWithoutNames) {
  const auto refusal = [](const char* text, const CsvOptions& options = {}) {
    const auto table = parse_csv(text, "f", options);
    return table ? std::string("none") : to_string(table.error());
  };
  for (const char* text :
       {",A,B\n0,1,2\n", " ,A,B\n0,1,2\n", "\"  \",A,B\n0,1,2\n", "Unnamed: 0,A,B\n0,1,2\n",
        "\"\",\"A\",\"B\"\n\"1\",1,2\n", ",0,1\n0,1.5,2\n"}) {
    EXPECT_EQ(refusal(text).substr(0, 23), "f: column 1 has no name") << text;
  }
  EXPECT_NE(refusal(",A,B\n0,1,2\n").find("index=False"), std::string::npos);
  EXPECT_NE(refusal("a,b,\n1,2,\n").find("a separator ends the line of names"), std::string::npos);
  EXPECT_NE(refusal(",a,,b\n0,1,2,3\n").find("or skip 1,3"), std::string::npos);
  EXPECT_NE(refusal("a,b\nr1,1,2\n").find("row.names=FALSE"), std::string::npos);
  EXPECT_NE(refusal("1,2,\n3,4,\n").find("skip the last column"), std::string::npos)
      << "without names";
  EXPECT_EQ(refusal("a,b,a\n1,2,3\n"),
            "f: columns 1 and 3 are both named 'a'; rename one of them, or skip 3");
}

TEST(Csv, SelectsColumnsWithoutNamesByNumber) {
  CsvOptions options;
  options.columns.skip = {"1"};
  EXPECT_EQ(parse_csv(",A,B\n0,1,2\n1,3,4\n", "f", options),
            (NumberTable{{"A", "B"}, matrix(2, {1, 2, 3, 4}), {}}));
  options.columns = {{"1", "B"}, {}, {}};
  EXPECT_EQ(parse_csv(",A,B\n1,0,2\n3,1,4\n", "f", options),
            (NumberTable{{"(column 1)", "B"}, matrix(2, {1, 2, 3, 4}), {}}));
  options.columns = {{}, {"3"}, {}};
  EXPECT_EQ(parse_csv("a,b,\n1,2,\n3,4,\n", "f", options)->values, matrix(2, {1, 2, 3, 4}));
  options.columns = {};
  options.label_column = "1";
  EXPECT_EQ(parse_csv(",a\nx,1\ny,2\n", "f", options),
            (NumberTable{{"a"}, matrix(2, {1, 2}), {"x", "y"}}));
}

TEST(Csv, TakesAnyEndsOfLines) {
  for (const char* text : {"1,2\r\n3,4\r\n", "1,2\r3,4\r", "1,2\n3,4",
                           "\xEF\xBB\xBF"
                           "1,2\n3,4\n",
                           "\n1,2\n\n  \n3,4\n\n"}) {
    EXPECT_EQ(parse_csv(text, "f"), kPlain) << text;
  }
}

TEST(Csv, PassesOverComments) {
  EXPECT_EQ(parse_csv("# a;b\n1,2\n#\n3,4\n# end", "f"), kPlain);
}

TEST(Csv, FindsOutTheHeader) {
  EXPECT_EQ(parse_csv("a,b\n1,2\n", "f")->names, (Names{"a", "b"}));
  EXPECT_EQ(parse_csv("\"1\",\"2\"\n1,2\n", "f")->names, (Names{"1", "2"}));
  EXPECT_EQ(parse_csv("1,2\n3,4\n", "f")->names, Names{});
  CsvOptions options;
  options.header = true;
  EXPECT_EQ(parse_csv("1,2\n3,4\n", "f", options)->names, (Names{"1", "2"}));
}

// Otherwise a first row with a hole would silently be lost as a header.
TEST(Csv, TakesAMissingNumberForNoHeader) {
  for (const char* text : {"1,nan\n3,4\n", "NA,2\n3,4\n", "1,\n3,4\n", "-inf,2\n3,4\n"}) {
    EXPECT_FALSE(parse_csv(text, "f")) << text;
  }
}

TEST(Csv, TakesLabelsByNameOrNumber) {
  const NumberTable expected{{"a", "c"}, matrix(2, {1, 2, 3, 4}), {"cup", "soft ball"}};
  const char* const text = "a,kind,c\n1,cup,2\n3,soft ball,4\n";
  EXPECT_EQ(parse_csv(text, "f", label("kind")), expected);
  EXPECT_EQ(parse_csv(text, "f", label("2")), expected);
  EXPECT_EQ(parse_csv("1,cup\n2,ball\n", "f", label("2")),
            (NumberTable{{}, matrix(2, {1, 2}), {"cup", "ball"}}));
  EXPECT_EQ(parse_csv("1,cup\n2,ball\n", "f", label("2"))->names, Names{});
}

TEST(Csv, RefusesALabelColumnThatIsNotThere) {
  const char* const text = "a,kind\n1,cup\n";
  const Result<NumberTable> misspelt = parse_csv(text, "f", label("knd"));
  EXPECT_EQ(to_string(misspelt.error()), "f: there is no column 'knd'; did you mean 'kind'?");
  EXPECT_EQ(misspelt.error().kind, ErrorKind::kUsage);
  EXPECT_EQ(parse_csv(text, "f", label("3")).error().advice, "there are 2 columns");
  EXPECT_FALSE(parse_csv(text, "f", label("0")));
  EXPECT_FALSE(parse_csv("kind\ncup\n", "f", label("kind"))) << "no numbers are left";
}

TEST(Csv, RefusesALabelColumnThatCouldBeEither) {
  const char* const text = "kind,a,kind\ncup,1,red\nball,2,blue\n";
  const Error error = parse_csv(text, "f", label("kind")).error();
  EXPECT_EQ(error.kind, ErrorKind::kUsage);
  EXPECT_EQ(error.what, "two columns are named 'kind'");
  CsvOptions options = label("3");
  options.columns.use = {"a"};
  EXPECT_EQ(parse_csv(text, "f", options)->labels, (Names{"red", "blue"}));
}

TEST(Csv, ReadsQuotedFields) {
  const NumberTable table =
      parse_csv("a,\"b, \"\"c\"\"\",d\n1,2,\"two\r\nlines\"\n\"3\" , 4,\" x \"\n", "f", label("d"))
          .value();
  EXPECT_EQ(table.names, (Names{"a", "b, \"c\""}));
  EXPECT_EQ(table.labels, (Names{"two\r\nlines", " x "}));
  EXPECT_EQ(table.values, matrix(2, {1, 2, 3, 4}));
  EXPECT_EQ(parse_csv("\"a b\" c\n1 2\n", "f")->names, (Names{"a b", "c"}));
}

TEST(Csv, ReadsNumbersAsTheyAreWritten) {
  const NumberTable table = parse_csv("+1,-2.5,1e3,.5,2.,1E-2,-0,1e-60,-1e-310\n", "f").value();
  EXPECT_EQ(table.values, matrix(1, {1, -2.5f, 1000, 0.5f, 2, 0.01f, 0, 0, 0}));
  EXPECT_TRUE(std::signbit(table.values(0, 6)));
}

void expect_refused(const std::string& text, const std::string& where, const std::string& because) {
  const Result<NumberTable> table = parse_csv(text, "f");
  ASSERT_FALSE(table) << text;
  EXPECT_EQ(table.error().kind, ErrorKind::kData);
  EXPECT_EQ(table.error().where, where) << text;
  EXPECT_NE(table.error().what.find(because), std::string::npos) << table.error().what;
  EXPECT_FALSE(table.error().advice.empty());
}

TEST(Csv, SaysWhereAndWhatIsWrong) {
  expect_refused("a,b\n1,2\n\n3\n", "f:4", "expected 2 fields, found 1");
  expect_refused("1,2\n3,4,5\n", "f:2", "expected 2 fields, found 3");
  expect_refused("1,2\n3, x\n", "f:2:4", "'x' is not a number");
  expect_refused("1,2\n3,0x10\n", "f:2:3", "'0x10' is not a number");
  expect_refused("1,2\n3,1e\n", "f:2:3", "'1e' is not a number");
  expect_refused("1,2\n3,+-4\n", "f:2:3", "'+-4' is not a number");
  expect_refused("1,2\n3,\n", "f:2:3", "the field is empty");
  for (const char* word : {"nan", "NaN", "-nan", "inf", "-Infinity", "NA", "N/A", "null", "?"}) {
    expect_refused(std::string("1,2\r\n") + word + ",4\r\n", "f:2:1", "is not a finite number");
  }
  expect_refused("1,2\n3,1e39\n", "f:2:3", "exceeds the range of 32-bit numbers");
  expect_refused("1,2\n3,-1e999\n", "f:2:3", "exceeds the range of 32-bit numbers");
  expect_refused("1,2\n\"3,4\n", "f:2:1", "not closed");
  expect_refused("1,2\n\"3\"x,4\n", "f:2:1", "follows the closing quotation mark");
  expect_refused("\"a\nb\",c\n1,x\n", "f:3:3", "'x' is not a number");
}

TEST(Csv, NeverGuessesWhatACommaInANumberMarks) {
  for (const char* text :
       {"1;2\n1,5;2\n", "1,5;2\n3;4\n", "a;b\n1,5;2\n", "a,b\n\"1,000\",2\n", "1;2\n-1,5e3;2\n"}) {
    const Result<NumberTable> table = parse_csv(text, "f");
    ASSERT_FALSE(table) << text;
    EXPECT_NE(table.error().what.find("is not a number"), std::string::npos) << text;
    EXPECT_NE(table.error().advice.find("read decimal commas"), std::string::npos) << text;
  }
  for (const char* text : {"a;b\n1,5,2;2\n", "a;b\n1.000,5;2\n", "a;b\n1,;x\n", "a;b\nx,1;2\n"}) {
    const Result<NumberTable> table = parse_csv(text, "f");
    ASSERT_FALSE(table) << text;
    EXPECT_EQ(table.error().advice.find("read decimal commas") != std::string::npos,
              std::string(text) == "a;b\n1,;x\n")
        << text << table.error().advice;
  }
}

TEST(Csv, ReadsDecimalCommas) {
  const auto read = [](const char* text) { return parse_csv(text, "f", decimal_comma()); };
  const Matrix<float> expected = matrix(2, {1.5f, -2, 0.25f, 3000});
  for (const char* text : {"1,5;-2\n,25;3e3\n", "1,5\t-2,0\n+0,25\t3,0e3\n", "1,5 -2\n0,25 3000\n",
                           "1,5;-2,\n\"0,25\";3000\n", "1,50000000;-2\n0,250000000;3000\n"}) {
    ASSERT_TRUE(read(text)) << text << to_string(read(text).error());
    EXPECT_EQ(read(text)->values, expected) << text;
    EXPECT_TRUE(read(text)->names.empty()) << "the first row was taken for names: " << text;
  }
  EXPECT_EQ(read("x\n1,5\n2\n")->values, matrix(2, {1.5f, 2})) << "a single column";
  EXPECT_EQ(read("a;b\n1,5;2\n")->names, (Names{"a", "b"}));
}

TEST(Csv, RefusesWhatADecimalCommaMakesUnclear) {
  for (const char* text : {"a,b\n1,2\n", "1,5\n2,5\n", "\"1,5\",2\n"}) {
    const Result<NumberTable> table = parse_csv(text, "f", decimal_comma());
    ASSERT_FALSE(table) << text;
    EXPECT_EQ(table.error().kind, ErrorKind::kUsage);
    EXPECT_NE(table.error().what.find("commas separate the fields"), std::string::npos);
  }
  for (const char* text : {"a;b\n1.5;2\n", "a;b\n1.000,5;2\n", "a;b\n1,000,5;2\n"}) {
    const Result<NumberTable> table = parse_csv(text, "f", decimal_comma());
    ASSERT_FALSE(table) << text;
    EXPECT_EQ(table.error().where, "f:2:1");
    EXPECT_NE(table.error().what.find("is not a number"), std::string::npos);
  }
}

TEST(Csv, ReadsTheColumnsThatAreChosen) {
  CsvOptions options = label("kind");
  options.columns.skip = {"note", "n*2"};
  const NumberTable table =
      parse_csv("n1,note,kind,n2,n3\n1,red,cup,inf,2\n3,,ball,?,4\n", "f", options).value();
  EXPECT_EQ(table, (NumberTable{{"n1", "n3"}, matrix(2, {1, 2, 3, 4}), {"cup", "ball"}}));
  options = {};
  options.columns.features = {"c", "a"};
  EXPECT_EQ(parse_csv("a,b,c\n1,x,2\n3,y,4\n", "f", options)->values, matrix(2, {2, 1, 4, 3}))
      << "in the order that is wanted";
  options = {};
  options.columns.skip = {"2"};
  EXPECT_EQ(parse_csv("1,red,2\n3,green,4\n", "f", options)->values, matrix(2, {1, 2, 3, 4}))
      << "text that is left out makes no header";
  EXPECT_EQ(parse_csv("a,b\n1,2\n", "f", options).error().advice,
            "its columns have names: select them by name");
}

TEST(Csv, NamesAllColumnsOfTextInTheFirstRow) {
  const std::string advice = parse_csv("a,b,c,d\n1,x,2,y\n", "f").error().advice;
  EXPECT_NE(advice.find("as label column"), std::string::npos) << advice;
  EXPECT_NE(advice.find("skip others: b,d"), std::string::npos) << advice;
  EXPECT_EQ(parse_csv("a,b\n1,2\n1,x\n", "f").error().advice.find("contain text"),
            std::string::npos)
      << "later it is a mistake";
}

TEST(Csv, KeepsMissingNumbersAsNaN) {
  CsvOptions options;
  options.keeps_missing = true;
  const NumberTable table = parse_csv("a,b\n1,\nNA,2\n nan ,-\n", "f", options).value();
  const std::vector<bool> missing{false, true, true, false, true, true};
  for (std::size_t i = 0; i < missing.size(); ++i) {
    EXPECT_EQ(std::isnan(table.values.values()[i]), missing[i]) << i;
  }
  EXPECT_EQ(table.values(1, 1), 2.0f);
  for (const char* text : {"1,inf\n", "a,b\n1,x\n", "1,1e39\n"}) {
    EXPECT_FALSE(parse_csv(text, "f", options)) << text;
  }
}

TEST(Csv, RefusesWhatHasNoRows) {
  for (const char* text : {"", "\n\n", "# nothing\n", "a,b\n", "\xEF\xBB\xBF"}) {
    expect_refused(text, "f", "no rows");
  }
}

TEST(Csv, RefusesBinaryContent) {
  expect_refused(std::string("1,2\n3,\0\n", 8), "f:2", "not UTF-8 text");
  expect_refused(
      "gr\xF6\xDF"
      "e\n1\n",
      "f:1", "not UTF-8 text");
}

TEST(Csv, RefusesAnEmptyLabel) {
  const Result<NumberTable> table = parse_csv("1,a\n2,\n", "f", label("2"));
  EXPECT_EQ(to_string(table.error()), "f:2:3: the label is empty; give every row a label");
}

TEST(Csv, IsWrittenAsExpected) {
  const NumberTable table{{"a", "b c"}, matrix(2, {1, -0.0f, 0.1f, 1e30f}), {"cup", "say \"x\""}};
  EXPECT_EQ(format_csv(table), "a,\"b c\",label\n1,-0,cup\n0.1,1e+30,\"say \"\"x\"\"\"\n");
}

std::string awkward_text(Random& random) {
  const char* const pieces[] = {"a",  "1", ",",  ";", "\t", " ",  "\"", "#",        "\n",
                                "\r", ".", "na", "+", "-",  "e5", "\\", "\xC3\xA4", "\xEF\xBB\xBF"};
  std::string text;
  for (std::size_t i = 1 + random.below(6); i > 0; --i) text += pieces[random.below(18)];
  return text;
}

// A blank name would be none.
std::string awkward_name(Random& random) {
  std::string name;
  while (name.find_first_not_of(" \t\r\n") == std::string::npos) name = awkward_text(random);
  return name;
}

TEST(CsvField, IsQuotedUnlessItIsAPlainWord) {
  EXPECT_EQ(csv_field("ball_1"), "ball_1");
  EXPECT_EQ(csv_field("red ball"), "\"red ball\"");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("a\nb"), "\"a\nb\"");
  EXPECT_EQ(csv_field("\"x\""), "\"\"\"x\"\"\"");
  EXPECT_EQ(csv_field("12"), "\"12\"");
  EXPECT_EQ(csv_field("nan"), "\"nan\"");
}

TEST(Csv, ReadsBackWhatItWrote) {
  Random random(1);
  for (int i = 0; i < 3000; ++i) {
    const std::size_t rows = 1 + random.below(3);
    const std::size_t columns = 1 + random.below(3);
    NumberTable table;
    table.values = Matrix<float>(rows, columns);
    for (float& value : table.values.values()) {
      value = std::bit_cast<float>(random.next() & 0xBFFFFFFF);  // Any finite number below 2.
    }
    if (random.below(2)) {
      for (std::size_t c = 0; c < columns; ++c) table.names.push_back(awkward_name(random));
    }
    CsvOptions options;
    options.columns.features = table.names;  // They may be the same.
    if (random.below(2)) {
      for (std::size_t r = 0; r < rows; ++r) table.labels.push_back(awkward_text(random));
      options.label_column = std::to_string(columns + 1);
    }
    const std::string text = format_csv(table);
    const Result<NumberTable> read = parse_csv(text, "f", options);
    ASSERT_TRUE(read) << to_string(read.error()) << "\n" << text;
    ASSERT_EQ(*read, table) << text;
    ASSERT_EQ(format_csv(*read), text) << "a zero lost its sign";
  }
}

TEST(Csv, RefusesToWriteWhatCannotBeRead) {
  EXPECT_THROW((void)format_csv({}), InvalidArgument);
  EXPECT_THROW((void)format_csv({{"a"}, matrix(1, {1, 2}), {}}), InvalidArgument);
  EXPECT_THROW((void)format_csv({{}, matrix(1, {1, 2}), {"a", "b"}}), InvalidArgument);
  EXPECT_THROW((void)format_csv({{}, matrix(1, {1.0f / 0.0f}), {}}), InvalidArgument);
  EXPECT_THROW((void)format_csv({{}, matrix(1, {1}), {""}}), InvalidArgument);
  EXPECT_THROW((void)format_csv({{"\xFF"}, matrix(1, {1}), {}}), InvalidArgument);
}

TEST(Csv, IsReadAndWrittenInFiles) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_csv(folder.file("a.csv"), kPlain));
  EXPECT_EQ(bytes_of(folder.file("a.csv")), "1,2\n3,4\n");
  EXPECT_EQ(read_csv(folder.file("a.csv")), kPlain);
  EXPECT_EQ(read_csv(folder.file("b.csv")).error().kind, ErrorKind::kSystem);
}

}  // namespace
}  // namespace somato
