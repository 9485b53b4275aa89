#include "base/tables/csv_text.h"

#include <gtest/gtest.h>

#include "somato/core/random.h"
#include "somato/files/csv.h"

namespace somato {
namespace {

TEST(GuardedText, PrecedesFormulasByAnApostrophe) {
  for (const char* text : {"=1+1", "+1-2", "-wet", "@sum", "\tx", "\r=x", "-", "=", "-inf", "'=1",
                           "''-a", "+-5", "-1,5"}) {
    EXPECT_EQ(guarded_text(text), "'" + std::string(text));
  }
  for (const char* text :
       {"", "cup", "-40", "+2.5", "-1e3", "'", "'cup'", "'-40", "a=1", " =1", "1-2"}) {
    EXPECT_EQ(guarded_text(text), text);
  }
}

TEST(GuardedText, IsReadAsTheSameText) {
  constexpr std::string_view kCharacters = "'=+-@\t\r1a.";
  Random random(7);
  for (int round = 0; round < 20000; ++round) {
    std::string text;
    for (std::size_t length = random.below(6); text.size() < length;) {
      text += kCharacters[random.below(kCharacters.size())];
    }
    ASSERT_EQ(unguarded_text(guarded_text(text)), text);
  }
}

TEST(GuardedText, OfOtherProgramsStaysUnlessItGuardsAFormula) {
  EXPECT_EQ(unguarded_text("=1+1"), "=1+1");
  EXPECT_EQ(unguarded_text("'=1+1"), "=1+1");
  EXPECT_EQ(unguarded_text("'70s"), "'70s");
  EXPECT_EQ(unguarded_text("'-40"), "'-40");
}

TEST(GuardedText, IsThatOfNamesAndLabels) {
  const NumberTable table{{"=a", "-b"}, Matrix<float>(2, 2, {1, -2, 3, 4}), {"@home", "'=x"}};
  const std::string text = format_csv(table);
  EXPECT_EQ(text, "\"'=a\",\"'-b\",label\n1,-2,\"'@home\"\n3,4,\"''=x\"\n");
  CsvOptions options;
  options.label_column = "label";
  EXPECT_EQ(parse_csv(text, "f", options), table);
}

}  // namespace
}  // namespace somato
