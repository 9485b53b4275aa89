#include "somato/studies/protocol.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "somato/core/check.h"

namespace somato {
namespace {

TEST(Protocol, TrainIsTestLearnsAndTestsAll) {
  EXPECT_EQ(folds(Protocol::kTrainIsTest, 3), (std::vector<Fold>{{{0, 1, 2}, {0, 1, 2}}}));
  EXPECT_EQ(folds(Protocol::kTrainIsTest, 1), (std::vector<Fold>{{{0}, {0}}}));
}

TEST(Protocol, LeaveOneOutTestsEachOnTheOthers) {
  EXPECT_EQ(folds(Protocol::kLeaveOneOut, 3),
            (std::vector<Fold>{{{1, 2}, {0}}, {{0, 2}, {1}}, {{0, 1}, {2}}}));
}

bool contains(const std::vector<std::size_t>& samples, std::size_t sample) {
  return std::find(samples.begin(), samples.end(), sample) != samples.end();
}

TEST(Protocol, EverySampleIsTestedOnce) {
  for (const auto& [protocol, name] : Choices<Protocol>::all()) {
    for (std::size_t count = 2; count < 20; ++count) {
      std::vector<std::size_t> tests(count);
      for (const Fold& fold : folds(protocol, count)) {
        for (const std::size_t sample : fold.test) ++tests.at(sample);
      }
      EXPECT_EQ(tests, std::vector<std::size_t>(count, 1)) << name << " " << count;
    }
  }
}

TEST(Protocol, LeaveOneOutNeverTrainsOnWhatItTests) {
  for (std::size_t count = 2; count < 20; ++count) {
    for (const Fold& fold : folds(Protocol::kLeaveOneOut, count)) {
      EXPECT_EQ(fold.training.size(), count - 1);
      EXPECT_TRUE(std::is_sorted(fold.training.begin(), fold.training.end()));
      for (const std::size_t sample : fold.test) EXPECT_FALSE(contains(fold.training, sample));
    }
  }
}

TEST(Protocol, NeedsSomethingToTrainOn) {
  EXPECT_THROW(folds(Protocol::kTrainIsTest, 0), InvalidArgument);
  EXPECT_THROW(folds(Protocol::kLeaveOneOut, 1), InvalidArgument);
}

}  // namespace
}  // namespace somato
