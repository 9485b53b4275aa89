#include "hardware/protocols/ssc32_tokens.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <string_view>

namespace somato::wire {
namespace {

std::string read_back(std::string_view line) {
  const std::optional<Ssc32Tokens> tokens = Ssc32Tokens::of(line);
  if (!tokens) return "refused";
  std::string text;
  for (const Ssc32Token& token : tokens->all()) {
    text += "[" + std::string(token.name());
    if (token.number) text += " " + std::to_string(*token.number);
    text += "]";
  }
  return text;
}

TEST(Ssc32Tokens, SeparatesNamesAndNumbersWithAndWithoutSpaces) {
  EXPECT_EQ(read_back("#5 P1600 S750 T1000"), "[# 5][P 1600][S 750][T 1000]");
  EXPECT_EQ(read_back("  #5P1600#6 P 900t20 "), "[# 5][P 1600][# 6][P 900][T 20]");
  EXPECT_EQ(read_back("#3 po-25"), "[# 3][PO -25]");
  EXPECT_EQ(read_back("#0:255"), "[# 0][: 255]");
  EXPECT_EQ(read_back("R4=+1"), "[R 4][= 1]");
  EXPECT_EQ(read_back(""), "");
}

TEST(Ssc32Tokens, RunsNamesOnOverLettersAndHash) {
  EXPECT_EQ(read_back("VA VB"), "[VA][VB]");
  EXPECT_EQ(read_back("VAVB"), "[VAVB]");
  EXPECT_EQ(read_back("#5L#6L"), "[# 5][L# 6][L]");
}

TEST(Ssc32Tokens, DoesNotShortenALongNameToACommand) {
  EXPECT_EQ(read_back("GOBOOTXYZ"), "[GOBOOTX~]");
  EXPECT_EQ(read_back("ABCDEFGH"), "[ABCDEFGH]");
}

TEST(Ssc32Tokens, RefusesWhatIsNoToken) {
  for (const std::string_view line : {"5", "#1 2", "#-", "P1.5", "#1\x01", "P1000001", "\x80"}) {
    EXPECT_EQ(read_back(line), "refused") << line;
  }
  EXPECT_EQ(read_back(std::string(129, '=')), "refused");
}

}  // namespace
}  // namespace somato::wire
