#include "somato/graph/module.h"

#include <gtest/gtest.h>

#include <limits>

namespace somato {
namespace {

TEST(Port, SaysWhatGoesThroughIt) {
  EXPECT_EQ(to_string(PortType{Rate::kFrame, {9, 10}, true, "joints"}),
            "9 x 10, sparse, every frame");
  EXPECT_EQ(to_string(PortType{Rate::kExploration, {7}, false, ""}), "7, every exploration");
}

TEST(Port, CountsElementsUpToWhatCanBeCounted) {
  EXPECT_EQ((PortType{Rate::kFrame, {2, 3, 4}, false, ""}).size(), 24U);
  EXPECT_EQ((PortType{Rate::kFrame, {}, false, ""}).size(), 1U);
  const std::size_t big = std::size_t{1} << 32;
  EXPECT_EQ((PortType{Rate::kFrame, {big, big}, false, ""}).size(),
            std::numeric_limits<std::size_t>::max());
}

TEST(Port, RatesHaveTheirNames) {
  EXPECT_EQ(choice_name(Rate::kFrame), "frames");
  EXPECT_EQ(choice_name(Rate::kExploration), "explorations");
}

}  // namespace
}  // namespace somato
