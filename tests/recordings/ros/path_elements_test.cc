#include "recordings/ros/path_elements.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace somato {
namespace {

using Texts = std::vector<std::string>;

TEST(PathElements, BracketsSelectByNumberOrByName) {
  const PathElements all = parse_path_elements("*").value();
  EXPECT_EQ(all.first, 0U);
  EXPECT_EQ(all.last, kUnbounded);
  EXPECT_EQ(parse_path_elements("3").value().last, 3U);
  EXPECT_EQ(parse_path_elements("2..5").value().first, 2U);
  EXPECT_EQ(parse_path_elements("2..5").value().last, 5U);
  EXPECT_FALSE(parse_path_elements("2..5").value().is_padded);
  EXPECT_EQ(parse_path_elements("*:32").value().last, 31U);
  EXPECT_TRUE(parse_path_elements("*:32").value().is_padded);
  EXPECT_EQ(parse_path_elements("elbow, left wrist").value().names, (Texts{"elbow", "left wrist"}));
  EXPECT_EQ(parse_path_elements("1,2").value().names, (Texts{"1", "2"}));
}

TEST(PathElements, WhatSelectsNothingIsRefused) {
  for (const std::string_view text : {"", " ", "5..2", "2..", "-1", "*:0", "*:", "a,,b", "a,", ",a",
                                      "a,a", "0]", "[a", "1..2..3", "99999999999999999999"}) {
    EXPECT_FALSE(parse_path_elements(text)) << text;
  }
}

TEST(PathElements, SeparatorsInBracketsBelongToNames) {
  std::string_view rest = "a[x.y].b[thumb[0],c].d";
  EXPECT_EQ(take_path_part(rest), "a[x.y]");
  EXPECT_EQ(take_path_part(rest), "b[thumb[0],c]");
  EXPECT_EQ(take_path_part(rest), "d");
  EXPECT_TRUE(rest.empty());
  EXPECT_EQ(split_outside_brackets("a[x+y]+b", '+'), (Texts{"a[x+y]", "b"}));
  EXPECT_EQ(split_outside_brackets("a,b[c,d],e", ','), (Texts{"a", "b[c,d]", "e"}));
  EXPECT_EQ(split_outside_brackets("", ','), Texts{""});
}

}  // namespace
}  // namespace somato
