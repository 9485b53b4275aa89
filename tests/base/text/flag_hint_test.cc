#include "base/text/flag_hint.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

TEST(FlagHint, IsEmptyUnlessTheCommandHasTheFlag) {
  EXPECT_EQ(flag_hint("skip", "1"), "");
  name_flags_in_messages({"skip", "definitions"});
  const std::string unknown = flag_hint("missing", "mean");
  const std::string with_value = flag_hint("skip", "1,3");
  const std::string without = flag_hint("definitions");
  name_flags_in_messages({});
  EXPECT_EQ(unknown, "");
  EXPECT_EQ(with_value, " (--skip 1,3)");
  EXPECT_EQ(without, " (--definitions)");
}

}  // namespace
}  // namespace somato
