#include "views/skins/skin_layout.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace somato {
namespace {

void expect_at(const SkinLayout& layout, std::size_t element, double x, double y) {
  EXPECT_DOUBLE_EQ(layout.elements.at(element).x, x) << element;
  EXPECT_DOUBLE_EQ(layout.elements.at(element).y, y) << element;
}

TEST(SkinLayout, AFingerHasItsTipAboveItsProximalSegment) {
  const SkinLayout layout =
      skin_layout({"finger1_tip_1", "finger1_proximal_2", "finger1_proximal_1"}, 3, {});
  ASSERT_FALSE(layout.is_grid);
  EXPECT_EQ(layout.fingers[0].name, "finger1");
  // One column of 1 and 0.28 at both sides; heights 2.56 and 1.56 with 0.2 between them.
  EXPECT_DOUBLE_EQ(layout.width, 1.56);
  EXPECT_DOUBLE_EQ(layout.height, 4.32);
  expect_at(layout, 2, 0.78, 4.32 - 0.28 - 0.5);
  expect_at(layout, 1, 0.78, 4.32 - 0.28 - 1.5);
  expect_at(layout, 0, 0.78, 4.32 - 2.56 - 0.2 - 0.28 - 0.5);
  ASSERT_EQ(layout.segments.size(), 2U);
  EXPECT_DOUBLE_EQ(layout.segments[1].corner.y, 0.0);
}

TEST(SkinLayout, TheThumbComesFirst) {
  const SkinLayout layout = skin_layout({"index_distal", "thumb_distal"}, 2, {});
  ASSERT_EQ(layout.fingers.size(), 2U);
  EXPECT_EQ(layout.fingers[0].name, "thumb");
  EXPECT_LT(layout.elements[1].x, layout.elements[0].x);
  EXPECT_DOUBLE_EQ(layout.width, 2 * 1.56 + 0.75);
}

TEST(SkinLayout, NumberedElementsOfAFingerAreAtItsTip) {
  const SkinLayout layout = skin_layout({"ring_1", "ring_2", "thumb_1"}, 3, {});
  ASSERT_EQ(layout.fingers.size(), 2U);
  EXPECT_EQ(layout.fingers[0].name, "thumb");
  EXPECT_EQ(layout.segments.size(), 2U);
  EXPECT_TRUE(skin_layout({"thumb", "ring"}, 2, {}).is_grid);
  EXPECT_TRUE(skin_layout({"motor_1", "motor_2"}, 2, {}).is_grid);
}

TEST(SkinLayout, SevenElementsOfASegmentAreTwoThreeTwo) {
  std::vector<std::string> names;
  for (int i = 1; i <= 7; ++i) names.push_back("taxel_finger2_middle_" + std::to_string(i));
  const SkinLayout layout = skin_layout(names, 7, {});
  EXPECT_EQ(layout.fingers.at(0).name, "finger2");
  EXPECT_DOUBLE_EQ(layout.width, 3.56);
  EXPECT_DOUBLE_EQ(layout.elements[0].y, layout.elements[1].y);
  EXPECT_DOUBLE_EQ(layout.elements[2].y, layout.elements[4].y);
  EXPECT_DOUBLE_EQ(layout.elements[0].y - layout.elements[2].y, 1.0);
  EXPECT_DOUBLE_EQ(layout.elements[0].x, 1.28);
  EXPECT_DOUBLE_EQ(layout.elements[2].x, 0.78);
}

TEST(SkinLayout, OtherNamesAreAGridByTheShape) {
  const SkinLayout layout = skin_layout({}, 6, {2, 1, 3, 1});
  EXPECT_TRUE(layout.is_grid);
  EXPECT_DOUBLE_EQ(layout.width, 3);
  EXPECT_DOUBLE_EQ(layout.height, 2);
  expect_at(layout, 5, 2.5, 1.5);
  EXPECT_TRUE(skin_layout({"finger1_tip", "wrist"}, 2, {}).is_grid);
  EXPECT_TRUE(skin_layout({"_tip", "tip"}, 2, {}).is_grid);
}

TEST(SkinLayout, AFlatFrameIsAboutTwiceAsWideAsHigh) {
  const SkinLayout layout = skin_layout({}, 8, {8});
  EXPECT_DOUBLE_EQ(layout.width, 4);
  EXPECT_DOUBLE_EQ(layout.height, 2);
  EXPECT_DOUBLE_EQ(skin_layout({}, 1, {}).width, 1);
}

TEST(SkinLayout, AGridHasNoHole) {
  const auto size_of = [](std::size_t count) {
    const SkinLayout layout = skin_layout({}, count, {count});
    return std::pair(layout.width, layout.height);
  };
  EXPECT_EQ(size_of(16), std::pair(4.0, 4.0));
  EXPECT_EQ(size_of(12), std::pair(4.0, 3.0));
  EXPECT_EQ(size_of(17), std::pair(17.0, 1.0));
  EXPECT_EQ(size_of(997), std::pair(45.0, 23.0));  // 997 in a row are too small to see
}

// The name of each cell of a grid with the indices in between.
std::vector<std::string> indexed(int rows, int columns, const std::string& before,
                                 const std::string& between) {
  std::vector<std::string> names;
  for (int i = 0; i < rows * columns; ++i) {
    names.push_back(before + std::to_string(i / columns) + between + std::to_string(i % columns));
  }
  return names;
}

TEST(SkinLayout, TwoIndicesOfNamesAreRowAndColumn) {
  for (const auto& [before, between] : {std::pair("t", ""), std::pair("taxel_", "_"),
                                        std::pair("r", "c"), std::pair("skin1_t", "")}) {
    SCOPED_TRACE(before);
    std::vector<std::string> names = indexed(2, 3, before, between);
    std::swap(names[0], names[4]);
    const SkinLayout layout = skin_layout(names, 6, {6});
    EXPECT_DOUBLE_EQ(layout.width, 3);
    expect_at(layout, 0, 1.5, 1.5);
    expect_at(layout, 4, 0.5, 0.5);
  }
  const SkinLayout large = skin_layout(indexed(4, 16, "taxel_", "_"), 64, {});
  EXPECT_DOUBLE_EQ(large.width, 16);
  expect_at(large, 2 * 16 + 11, 11.5, 2.5);
}

TEST(SkinLayout, NamesWithAHoleOrTwiceAreInNoGrid) {
  std::vector<std::string> names = indexed(2, 8, "t", "_");
  EXPECT_DOUBLE_EQ(skin_layout(names, 16, {}).width, 8);
  names[3] = "t0_2";
  EXPECT_DOUBLE_EQ(skin_layout(names, 16, {}).width, 4);
  names[3] = "s0_3";
  EXPECT_DOUBLE_EQ(skin_layout(names, 16, {}).width, 4);
  names[3] = "t0_99999999999999999999999";
  EXPECT_DOUBLE_EQ(skin_layout(names, 16, {}).width, 4);
  names[3] = "t0_9223372036854775815";  // twice this number is 14 modulo 2^64
  EXPECT_DOUBLE_EQ(skin_layout(names, 16, {}).width, 4);
}

TEST(SkinLayout, GivenPlacesAreInDistancesBetweenNeighbours) {
  const SkinPlaces skin{
      {{10, 4}, {12, 4}, {10, 8}}, {{"top", {0, 1}}}, SkinBackground{"data:", {8, 4}, 4, 8}};
  const SkinLayout layout = skin_layout(skin);
  EXPECT_FALSE(layout.is_grid);
  expect_at(layout, 0, 1.75, 0.75);  // 1 from the corner of the picture, and 0.75 around all
  expect_at(layout, 1, 2.75, 0.75);
  expect_at(layout, 2, 1.75, 2.75);
  EXPECT_DOUBLE_EQ(layout.width, 2 + 1.5);
  EXPECT_DOUBLE_EQ(layout.height, 4 + 1.5);
  ASSERT_EQ(layout.segments.size(), 1U);
  EXPECT_DOUBLE_EQ(layout.segments[0].width, 1 + 1.5);
  EXPECT_EQ(layout.fingers.at(0).name, "top");
  EXPECT_DOUBLE_EQ(layout.fingers[0].foot.y, 1.5);
  EXPECT_DOUBLE_EQ(layout.background.value().box.height, 4);
}

}  // namespace
}  // namespace somato
