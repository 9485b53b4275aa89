#include "studies/run/winners_picture.h"

#include <gtest/gtest.h>

#include "maps/pictures/panels.h"
#include "maps/pictures/xml.h"
#include "recordings/support/made_recording.h"
#include "studies/support/made_study.h"
#include "studies/support/study_results.h"

namespace somato {
namespace {

TEST(WinnersPicture, HasAMarkerForEachExplorationAndTheNameOfEachClass) {
  const StudyDescription description = testing::small_study();
  const StudyOutcome outcome =
      testing::outcome_of(description, testing::objects_apart(3, 4, 2.0, 1));
  const auto root = test::read_xml(winners_picture(description, outcome));
  ASSERT_TRUE(root);
  const auto markers = test::group(*root, "samples").children;
  EXPECT_EQ(markers.size(), 12U);
  EXPECT_EQ(test::texts(test::group(*root, "names")), outcome.classes.names);
  EXPECT_EQ(test::texts(*root).at(1), "12 explorations, all used for training;");  // wrapped
}

}  // namespace
}  // namespace somato
