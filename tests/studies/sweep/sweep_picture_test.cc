#include "studies/sweep/sweep_picture.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "maps/pictures/xml.h"
#include "studies/sweep/sweeps.h"

namespace somato {
namespace {

using test::Element;
using test::elements;
using test::groups;

PartResults judged(double accuracy) {
  PartResults part;
  part.system = "press";
  part.protocols.push_back({"train_is_test", {}, "material", 8, {}, {}});
  part.protocols[0].metrics.push_back({"accuracy", {accuracy, 1.0}});
  return part;
}

// The first claim of a sweep of one_at_a_time over three rows, where a row has half of the pairs.
Element picture(const std::string& unknown, const std::string& design) {
  const SystemSweep sweep = test::planned(test::sweep_toml(design, unknown)).value();
  SweepResults results{sweep, {}};
  double accuracy = 1.0;
  for (const SweepPoint& point : sweep_points(sweep.sweep)) {
    results.points.push_back(judge_point(sweep, point, {judged(accuracy)}));
    accuracy = 0.0;
  }
  return test::read_xml(sweep_picture(results)).value();
}

std::vector<std::string> texts_in(const Element& root) {
  std::vector<std::string> all;
  for (const Element& text : elements(root, "text")) all.push_back(text.text);
  return all;
}

TEST(SweepPicture, ShowsEachClaimOverEachUnknownAndMarksTheSystem) {
  const Element root = picture(
      "[unknown.side]\nkey = 'module.map.rows'\ntext = 'x'\nvalues = [3, 5, 9]\n", "one_at_a_time");
  const auto panels = groups(root, "panel");
  ASSERT_EQ(panels.size(), 2U);
  EXPECT_EQ(texts_in(panels[0])[0], "All materials are named.");
  const auto strips = groups(panels[0], "strip");
  ASSERT_EQ(strips.size(), 1U);
  const auto texts = texts_in(strips[0]);
  const auto has = [&](const std::string& text) {
    return std::find(texts.begin(), texts.end(), text) != texts.end();
  };
  for (const char* text :
       {"side", "module.map.rows", "3", "5", "9", "50", "the system: 5 (100 %)"}) {
    EXPECT_TRUE(has(text)) << text << " in " << ::testing::PrintToString(texts);
  }
  // The triangle stands above the middle of the second of three cells.
  ASSERT_EQ(elements(strips[0], "polygon").size(), 1U);
  EXPECT_EQ(elements(strips[0], "polygon")[0]["points"], "235,-10 245,-10 240,-1");
  // A part that was not run is stated, not drawn.
  EXPECT_TRUE(groups(panels[1], "strip").empty());
  EXPECT_NE(texts_in(panels[1])[1].find("could not be judged"), std::string::npos);
}

// Rows 3 to 6 in two cells: the system's 5 is in the second.
TEST(SweepPicture, MarksTheCellOfWholeNumbersThatHoldsTheSystemsOwn) {
  const Element root = picture(
      "[unknown.side]\nkey = 'module.map.rows'\ntext = 'x'\nlow = 3\nhigh = 6\nwhole = true\n",
      "sobol'\npoints = 4 #");
  const Element strip = groups(root, "strip")[0];
  const auto texts = texts_in(strip);
  for (const char* text : {"3 to 4", "5 to 6", "the system: 5"}) {
    EXPECT_NE(std::find(texts.begin(), texts.end(), text), texts.end()) << text;
  }
  ASSERT_EQ(elements(strip, "polygon").size(), 1U);
  EXPECT_EQ(elements(strip, "polygon")[0]["points"], "355,-10 365,-10 360,-1");
}

TEST(SweepPicture, SaysWhereNothingChangesAClaim) {
  const Element root = picture(
      "[unknown.side]\nkey = 'module.map.rows'\ntext = 'x'\nvalues = [3]\n", "full_factorial");
  const Element panel = groups(root, "panel")[0];
  EXPECT_TRUE(groups(panel, "strip").empty());
  std::string note;
  for (const std::string& line : texts_in(panel)) note += line + " ";
  EXPECT_NE(note.find("Holds at 100 % of the points"), std::string::npos) << note;
  EXPECT_TRUE(note.ends_with("No unknown changes that. ")) << note;
}

TEST(SweepPicture, ShowsTheEdgesOfTheCellsOfARange) {
  const Element root = picture(test::rate(), "sobol'\npoints = 4 #");
  const auto texts = texts_in(groups(root, "strip")[0]);
  for (const char* text : {"0.1", "0.5", "0.9"}) {
    EXPECT_NE(std::find(texts.begin(), texts.end(), text), texts.end()) << text;
  }
}

}  // namespace
}  // namespace somato
