#include "views/skins/layout_file.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/support/temporary_folder.h"

namespace somato {
namespace {

using Names = std::vector<std::string>;

class LayoutFile : public ::testing::Test {
 protected:
  Result<std::vector<ChannelPlaces>> layout(const std::string& text) const {
    return read_layout(folder_.with("pad.toml", text));
  }

  // The error of a layout for the elements a, b and c, in one line.
  std::string error_of(const std::string& text) const {
    const auto read = layout(text);
    if (!read) return to_string(read.error());
    const auto skin = places_for(read->front(), {"a", "b", "c"});
    return skin ? "none" : to_string(skin.error());
  }

  void expect_error(const std::string& text, const std::string& line, const Names& parts) const {
    const std::string error = error_of(text);
    EXPECT_NE(error.find("pad.toml" + (line.empty() ? "" : ":" + line)), std::string::npos)
        << text << "\n"
        << error;
    for (const std::string& part : parts) {
      EXPECT_NE(error.find(part), std::string::npos) << text << "\n" << error;
    }
  }

  // The table of one channel with three places.
  static std::string with(const std::string& more) {
    return "[layout.touch]\nplaces = [[0, 0], [4, 0], [0, 3.5]]\n" + more;
  }

  TemporaryFolder folder_;
};

void expect_at(const Point& point, double x, double y) {
  EXPECT_DOUBLE_EQ(point.x, x);
  EXPECT_DOUBLE_EQ(point.y, y);
}

TEST_F(LayoutFile, HasAPlaceForEachElement) {
  const auto read = layout(with("")).value();
  ASSERT_EQ(read.size(), 1U);
  EXPECT_EQ(read[0].channel, "touch");
  const SkinPlaces skin = places_for(read[0], {"a", "b", "c"}).value();
  ASSERT_EQ(skin.places.size(), 3U);
  expect_at(skin.places[1], 4, 0);
  expect_at(skin.places[2], 0, 3.5);
  EXPECT_DOUBLE_EQ(spacing_of(skin.places), 3.5);  // of 3.5, 4 and 3.5
}

TEST_F(LayoutFile, ElementsMayBeInAnotherOrder) {
  const auto read = layout(with("elements = [\"c\", \"a\", \"b\"]")).value();
  const SkinPlaces skin = places_for(read[0], {"a", "b", "c"}).value();
  expect_at(skin.places[0], 4, 0);
  expect_at(skin.places[1], 0, 3.5);
  expect_at(skin.places[2], 0, 0);
}

TEST_F(LayoutFile, GroupsAreOfNamesNumbersAndRanges) {
  const std::string groups = "[layout.touch.groups]\ntip = [\"a..b\"]\n\"the rest\" = \"c\"\n";
  const auto named = places_for(layout(with(groups)).value()[0], {"a", "b", "c"}).value();
  EXPECT_EQ(named.groups, (std::vector<SkinGroup>{{"tip", {0, 1}}, {"the rest", {2}}}));
  const auto read = layout(with("groups.tip = [3, 1]")).value();
  const auto numbered = places_for(read[0], {"1", "2", "3"}).value();
  EXPECT_EQ(numbered.groups, (std::vector<SkinGroup>{{"tip", {2, 0}}}));
}

TEST_F(LayoutFile, APictureIsInItsFolder) {
  folder_.with("pad.PNG", "\x89PNG\r\n\x1a\n IEND");
  const std::string picture = "picture = \"pad.PNG\"\npicture_corners = [[-1, -2], [9, 8]]\n";
  const auto background = layout(with(picture)).value()[0].background;
  ASSERT_TRUE(background);
  EXPECT_EQ(background->image, "data:image/png;base64,iVBORw0KGgogSUVORA==");
  expect_at(background->corner, -1, -2);
  EXPECT_DOUBLE_EQ(background->width, 10);
  EXPECT_DOUBLE_EQ(background->height, 10);
}

TEST_F(LayoutFile, RefusesOtherTablesAndKeys) {
  expect_error("", "", {"no table [layout.CHANNEL]"});
  expect_error("layout = 3", "", {"no table [layout.CHANNEL]"});
  expect_error("[layouts.touch]", "1", {"layouts", "layout"});
  expect_error("[layout]\nplaces = [[0, 0]]", "2", {"'places'", "[layout.CHANNEL]"});
  expect_error(with("place = [[0, 0]]"), "3", {"place", "did you mean 'places'"});
  expect_error(with("groups = [\"a\"]"), "3", {"groups", "table"});
  expect_error("[layout.touch", "1", {});
}

TEST_F(LayoutFile, RefusesPlacesThatAreNoPoints) {
  expect_error("[layout.touch]", "1", {"0 places"});
  expect_error("[layout.touch]\nplaces = [[0, 0, 1], [1, 1, 1], [2, 2, 2]]", "1",
               {"place 1 has 3 numbers", "without z"});
  expect_error("[layout.touch]\nplaces = [1, 2, 3]", "1", {"place 1 has 1 numbers"});
  expect_error("[layout.touch]\nplaces = [[0, 0], [nan, 0], [1, 1]]", "2", {"places", "nan"});
  expect_error("[layout.touch]\nplaces = [[0, 0], [inf, 0], [1, 1]]", "2", {"places", "inf"});
  expect_error("[layout.touch]\nplaces = [[0, 0], [1e7, 0], [1, 1]]", "2", {"places"});
  expect_error("[layout.touch]\nplaces = \"pad\"", "2", {"places"});
  expect_error("[layout.touch]\nplaces = [[0, 0], [4, 0], [0, 0]]", "1", {"place 3 is also"});
  expect_error("[layout.touch]\nplaces = [[0, 0], [0.001, 0], [0, 900]]", "1",
               {"extend over 900 mm", "0.001 mm"});
  std::string many = "[layout.touch]\nplaces = [[0, 0]";
  for (int i = 1; i < 4097; ++i) many += ", [" + std::to_string(i) + ", 0]";
  expect_error(many + "]", "1", {"4097 places", "1 to 4096"});
}

TEST_F(LayoutFile, RefusesWhatDoesNotFitTheElements) {
  expect_error("[layout.touch]\nplaces = [[0, 0], [1, 1]]", "1", {"2 places", "3 elements"});
  expect_error(with("elements = [\"a\", \"b\"]"), "1", {"2 elements and 3 places"});
  expect_error(with("elements = [\"a\", \"b\", \"b\"]"), "1", {"'b' occurs twice"});
  expect_error(with("elements = [\"a\", \"b\", \"d\"]"), "1", {"'c' has no place"});
  expect_error(with("groups.tip = [\"a\", \"d\"]"), "3", {"element 'd'"});
  expect_error(with("groups.tip = [\"c..a\"]"), "3", {"descending"});
  expect_error(with("groups.tip = [\"a..b\", \"b\"]"), "3", {"'b' twice"});
  expect_error(with("groups.tip = []"), "3", {"empty"});
  expect_error(with("groups.tip = [0.5]"), "3", {"0.5 is not an element"});
}

TEST_F(LayoutFile, RefusesPicturesThatCannotBeDrawn) {
  folder_.with("pad.png", std::string((std::size_t{512} << 10) + 1, 'x'));
  const std::string corners = "\npicture_corners = [[0, 0], [9, 9]]";
  expect_error(with("picture = \"pad.gif\"" + corners), "1", {"pad.gif", "PNG, JPEG or SVG"});
  expect_error(with("picture = \"pad.png\""), "1", {"two corners"});
  expect_error(with(corners), "1", {"needs its file"});
  expect_error(with("picture = \"pad.png\"\npicture_corners = [[9, 9], [0, 0]]"), "1",
               {"not below and right"});
  EXPECT_NE(error_of(with("picture = \"other.png\"" + corners)).find("other.png"),
            std::string::npos);
  EXPECT_NE(error_of(with("picture = \"pad.png\"" + corners)).find("pad.png"), std::string::npos);
}

TEST_F(LayoutFile, RefusesPicturesThatAreNoImages) {
  const std::string corners = "\npicture_corners = [[0, 0], [9, 9]]";
  const std::string png = "\x89PNG\r\n\x1a\n";
  const std::string jpeg = "\xff\xd8\xff\xe0";
  const auto error_with = [&](const std::string& name, const std::string& content) {
    folder_.with(name, content);
    return error_of(with("picture = \"" + name + "\"" + corners));
  };
  const auto is_refused = [&](const std::string& name, const std::string& content) {
    return error_with(name, content).find("the content of '" + name + "' is not a complete") !=
           std::string::npos;
  };
  EXPECT_TRUE(is_refused("pad.png", "places,1,2\n"));
  EXPECT_TRUE(is_refused("pad.png", ""));
  EXPECT_TRUE(is_refused("pad.png", png + " cut"));
  EXPECT_TRUE(is_refused("pad.png", jpeg + "\xff\xd9"));
  EXPECT_TRUE(is_refused("pad.jpg", png + " IEND"));
  EXPECT_TRUE(is_refused("pad.jpg", jpeg + " cut"));
  EXPECT_TRUE(is_refused("pad.svg", "<html></html>"));
  EXPECT_EQ(error_with("pad.jpeg", jpeg + "\xff\xd9"), "none");
  EXPECT_EQ(error_with("pad.svg", "<?xml version=\"1.0\"?>\n<svg width=\"3\"/>"), "none");
}

TEST_F(LayoutFile, TellsUnknownChannels) {
  const auto read = layout(with("")).value();
  EXPECT_TRUE(check_channels(read, {"joints", "touch"}));
  const auto checked = check_channels(read, {"joints", "touch1"});
  ASSERT_FALSE(checked);
  EXPECT_EQ(checked.error().advice, "did you mean 'touch1'?");
}

TEST_F(LayoutFile, IsAddedToTheChannelsOfPages) {
  const auto read = layout(with("groups.tip = [\"b\"]")).value();
  nlohmann::ordered_json channel{{"name", "touch"}, {"elements", {"a", "b", "c"}}};
  ASSERT_TRUE(add_places(read, channel));
  EXPECT_EQ(channel["layout"]["spacing"], 3.5);
  EXPECT_EQ(channel["layout"]["places"], nlohmann::ordered_json::parse("[[0,0],[4,0],[0,3.5]]"));
  EXPECT_EQ(channel["layout"]["groups"][0]["elements"], nlohmann::ordered_json::parse("[1]"));
  nlohmann::ordered_json other{{"name", "joints"}, {"elements", {"a"}}};
  ASSERT_TRUE(add_places(read, other));
  EXPECT_FALSE(other.contains("layout"));
}

}  // namespace
}  // namespace somato
