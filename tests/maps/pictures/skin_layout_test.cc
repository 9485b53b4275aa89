#include "maps/pictures/skin_layout.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace somato
