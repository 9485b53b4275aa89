#include "views/session/json_writer.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace somato::live {
namespace {

TEST(JsonWriter, SeparatesWhatStandsBesideEachOther) {
  JsonWriter text;
  text.open('{');
  text.key("a").open('[').close(']');
  text.key("b \"and\" \xff").open('{').key("c").add("{}", 1).close('}');
  EXPECT_EQ(std::move(text.close('}')).take(),
            "{\"a\":[],\"b \\\"and\\\" \xEF\xBF\xBD\":{\"c\":1}}");
}

TEST(JsonWriter, WritesNumbersShortOrExactlyAndNullForNone) {
  const std::array<float, 4> values{0.0F, 1234567.0F, 0.1F,
                                    std::numeric_limits<float>::quiet_NaN()};
  JsonWriter text;
  text.open('[').separate().numbers(values).separate().exact_numbers(values).close(']');
  EXPECT_EQ(std::move(text).take(), "[[0,1.2346e+06,0.1,null],[0,1234567,0.1,null]]");
}

}  // namespace
}  // namespace somato::live
