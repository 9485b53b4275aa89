#include "hardware/boards/ssc32_line.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <string_view>

namespace somato::emulation {
namespace {

using Type = Ssc32Line::Type;

std::string items_of(std::string_view text) {
  const std::optional<Ssc32Line> line = understood_by_ssc32(text);
  if (!line) return "dropped";
  std::string items;
  for (const Ssc32Line::Item& item : line->items) {
    items += std::to_string(item.channel) + ":" + std::to_string(item.value);
    if (item.speed > 0) items += "/" + std::to_string(item.speed);
    items += " ";
  }
  return items + "in " + std::to_string(line->milliseconds);
}

Type type_of(std::string_view text) {
  return understood_by_ssc32(text).value().type;
}

TEST(Ssc32Line, ReadsGroups) {
  EXPECT_EQ(items_of("#5 P1600 S750 #10 P750 T2500"), "5:1600/750 10:750 in 2500");
  EXPECT_EQ(items_of("#5P1600T20#6P700S1"), "5:1600 6:700/1 in 20");
  EXPECT_EQ(items_of("#5p1600t20"), "5:1600 in 20");
}

TEST(Ssc32Line, ClipsPulses) {
  EXPECT_EQ(items_of("#0P499#1P2501#2P0#3P1#4P30000#5L"), "0:500 1:2500 2:0 3:500 4:2500 5:0 in 0");
}

TEST(Ssc32Line, LetsTheLastTypeWin) {
  EXPECT_EQ(type_of("#5P1600 Q"), Type::kMoving);
  EXPECT_EQ(items_of("STOP3 #5P1600"), "5:1600 in 0");
  EXPECT_EQ(items_of("#1PO20 #2P1500T9 #3PO-7"), "3:-7 in 0");
  EXPECT_EQ(items_of("QP1 QP2"), "1:0 2:0 in 0");
}

TEST(Ssc32Line, ReadsTheOtherCommands) {
  EXPECT_EQ(type_of(""), Type::kNothing);
  EXPECT_EQ(type_of("VER"), Type::kVersion);
  EXPECT_EQ(type_of("GOBOOT"), Type::kBoot);
  EXPECT_EQ(type_of("R4=1"), Type::kWrite);
  EXPECT_EQ(type_of("R4"), Type::kNothing);
  EXPECT_EQ(type_of("VA VB"), Type::kAnalog);
  EXPECT_EQ(items_of("D A"), "3:0 0:0 in 0");
  EXPECT_EQ(type_of("#2:255"), Type::kOutput);
  EXPECT_EQ(type_of("STOP31"), Type::kStop);
}

TEST(Ssc32Line, DropsLinesItDoesNotUnderstand) {
  for (const std::string_view line :
       {"VAVB", "#5L#6L",        "P1500", "#5P",  "#32P1500", "S5",  "T5",
        "#5T5", "#5P1500T70000", "XYZ",   "STOP", "STOP32",   "QP",  "Q1",
        "VER2", "#1PO101",       "#1PO",  "#4:1", "#1:256",   "R=1", "=1",
        "#5L3", "#5P1600 HELLO", "\x80"}) {
    EXPECT_EQ(items_of(line), "dropped") << line;
  }
}

}  // namespace
}  // namespace somato::emulation
