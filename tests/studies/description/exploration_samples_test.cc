#include "studies/description/exploration_samples.h"

#include <gtest/gtest.h>

#include "recordings/support/made_recording.h"

namespace somato {
namespace {

Recording recording() {
  return {{testing::exploration_of("ball", {1}), testing::exploration_of("cube", {2}),
           testing::exploration_of("ball", {3})}};
}

TEST(LabelsOf, AreThoseOfTheExplorations) {
  EXPECT_EQ(labels_of(recording(), "object").value(),
            (std::vector<std::string>{"ball", "cube", "ball"}));
  EXPECT_EQ(labels_of(recording(), "objcet").error().kind, ErrorKind::kUsage);
}

TEST(NumbersOf, AreEqualWhereLabelsAre) {
  EXPECT_EQ(numbers_of(recording(), "object").value(), (std::vector<std::size_t>{0, 1, 0}));
  EXPECT_EQ(numbers_of(recording(), "").value(), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(numbers_of(recording(), "objcet").error().kind, ErrorKind::kUsage);
}

}  // namespace
}  // namespace somato
