#include "views/skins/skin_picture.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <stdexcept>

#include "maps/pictures/panels.h"
#include "maps/svg/colours.h"
#include "somato/core/check.h"

namespace somato {
namespace {

using test::Element;
using test::elements;
using test::group;
using test::groups;
using test::texts;

// Three taxels of two fingers; the last one did not measure in the second frame.
SkinPicture two_frames() {
  SkinPicture picture;
  picture.title = "ball";
  picture.element_names = {"thumb_tip_1", "thumb_tip_2", "index_tip_1"};
  picture.unit = "N";
  picture.greatest = 4;
  picture.frames = {{"frame 1", {0, 1, 2}, {}}, {"frame 2", {0, 4, 0}, {1, 1, 0}}};
  return picture;
}

Element drawn(const SkinPicture& picture) {
  const auto root = test::read_xml(draw_skin(picture));
  if (!root) throw std::runtime_error("not well formed");
  return *root;
}

TEST(SkinPicture, ElementsHaveTheColoursOfTheirValues) {
  const auto frames = groups(drawn(two_frames()), "skin");
  ASSERT_EQ(frames.size(), 2U);
  const auto first = elements(frames[0], "circle");
  ASSERT_EQ(first.size(), 3U);
  EXPECT_EQ(first[1]["fill"], to_string(sequential_colour(0.25)));
  EXPECT_EQ(first[2]["fill"], to_string(sequential_colour(0.5)));
  EXPECT_EQ(first[1].children.at(0).text, "thumb_tip_2: 1 N");
}

TEST(SkinPicture, MissingValuesAreOutlined) {
  const auto second = elements(groups(drawn(two_frames()), "skin")[1], "circle");
  EXPECT_EQ(second[1]["fill"], to_string(sequential_colour(1.0)));
  EXPECT_EQ(second[2]["fill"], "#ffffff");
  EXPECT_EQ(second[2].children.at(0).text, "index_tip_1: missing");
}

TEST(SkinPicture, HasTitlesFingersAndLimits) {
  EXPECT_EQ(texts(drawn(two_frames())),
            (std::vector<std::string>{"ball", "frame 1", "thumb", "index", "frame 2", "thumb",
                                      "index", "0", "4 N"}));
}

TEST(SkinPicture, WithoutNamesElementsAreSquaresInAGridWithoutGaps) {
  SkinPicture picture;
  picture.shape = {2, 3};
  picture.greatest = 5;
  picture.frames = {{"", {0, 1, 2, 3, 4, 5}, {}}};
  const auto cells = elements(group(drawn(picture), "skin"), "rect");
  ASSERT_EQ(cells.size(), 6U);
  std::set<std::string> places;
  for (const Element& cell : cells) {
    EXPECT_EQ(cell["width"], "30");
    places.insert(cell["x"] + " " + cell["y"]);
  }
  EXPECT_EQ(places, (std::set<std::string>{"0 0", "30 0", "60 0", "0 30", "30 30", "60 30"}));
  EXPECT_EQ(cells[5].children.at(0).text, "element 6: 5");
}

TEST(SkinPicture, FramesDoNotOverlap) {
  SkinPicture picture = two_frames();
  picture.frames.resize(5, picture.frames[0]);
  const auto frames = groups(drawn(picture), "frame");
  std::set<std::string> places;
  for (const Element& frame : frames) places.insert(frame["transform"]);
  EXPECT_EQ(places.size(), 5U);
}

TEST(SkinPicture, RefusesContradictions) {
  const auto expect_refused = [](const auto& change) {
    SkinPicture picture = two_frames();
    change(picture);
    EXPECT_THROW(draw_skin(picture), InvalidArgument);
  };
  expect_refused([](SkinPicture& picture) { picture.frames.clear(); });
  expect_refused([](SkinPicture& picture) { picture.element_names.pop_back(); });
  expect_refused([](SkinPicture& picture) { picture.frames[1].values.pop_back(); });
  expect_refused([](SkinPicture& picture) { picture.frames[1].valid.pop_back(); });
  expect_refused([](SkinPicture& picture) { picture.least = 5; });
  expect_refused([](SkinPicture& picture) {
    picture.frames[0].values[0] = std::numeric_limits<float>::quiet_NaN();
  });
}

}  // namespace
}  // namespace somato
