#include "systems/signals/onset.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "somato/core/check.h"

namespace somato {
namespace {

Matrix<float> column(std::vector<float> values) {
  const std::size_t count = values.size();
  return Matrix<float>(count, 1, std::move(values));
}

OnsetParameters onset_of(OnsetQuantity quantity, double threshold, std::size_t element = 0) {
  OnsetParameters parameters;
  parameters.quantity = quantity;
  parameters.threshold = threshold;
  parameters.element = element;
  return parameters;
}

// Offset 10, a dip, then a rise.
const Matrix<float> kPress = column({10.0F, 10.5F, -12.0F, 13.0F, 20.0F});

TEST(Onset, ComparesTheSelectedQuantityWithTheThreshold) {
  EXPECT_EQ(find_onset(kPress, onset_of(OnsetQuantity::kValue, 13.0)), 3U);
  EXPECT_EQ(find_onset(kPress, onset_of(OnsetQuantity::kMagnitude, 11.0)), 2U);
  EXPECT_EQ(find_onset(kPress, onset_of(OnsetQuantity::kMagnitude, 12.5)), 3U);
  EXPECT_EQ(find_onset(kPress, onset_of(OnsetQuantity::kChange, 0.5)), 1U);
  EXPECT_EQ(find_onset(kPress, onset_of(OnsetQuantity::kChange, 22.0)), 2U);
}

TEST(Onset, MayBeInTheFirstFrame) {
  EXPECT_EQ(find_onset(kPress, onset_of(OnsetQuantity::kValue, 10.0)), 0U);
  EXPECT_EQ(find_onset(kPress, onset_of(OnsetQuantity::kValue, -20.0)), 0U);
}

TEST(Onset, TakesOneElementOrAny) {
  const Matrix<float> frames(3, 2, {0, 0, 0, 5, 5, 5});
  EXPECT_EQ(find_onset(frames, onset_of(OnsetQuantity::kValue, 5.0, 1)), 2U);
  EXPECT_EQ(find_onset(frames, onset_of(OnsetQuantity::kValue, 5.0, 2)), 1U);
  EXPECT_EQ(find_onset(frames, onset_of(OnsetQuantity::kValue, 5.0, 0)), 1U);
}

TEST(Onset, SaysTheGreatestValueWhereThereIsNone) {
  const auto onset = find_onset(kPress, onset_of(OnsetQuantity::kChange, 30.0));
  ASSERT_FALSE(onset);
  EXPECT_EQ(onset.error().kind, ErrorKind::kData);
  EXPECT_EQ(onset.error().what,
            "there is no onset: the change of any element never reaches the threshold 30; the "
            "maximum is 22");
  const auto of_one = find_onset(kPress, onset_of(OnsetQuantity::kValue, 30.0, 1));
  ASSERT_FALSE(of_one);
  EXPECT_EQ(of_one.error().what,
            "there is no onset: the value of element 1 never reaches the threshold 30; the "
            "maximum is 20");
}

TEST(Onset, HasNoneWithoutFramesAndNeverTakesNaN) {
  const auto empty = find_onset(Matrix<float>(0, 2), onset_of(OnsetQuantity::kValue, 1.0));
  ASSERT_FALSE(empty);
  EXPECT_EQ(empty.error().what,
            "there is no onset: the value of any element never reaches the threshold 1; there are "
            "no frames");
  const Matrix<float> frames = column({0.0F, std::nanf(""), 2.0F});
  EXPECT_EQ(find_onset(frames, onset_of(OnsetQuantity::kValue, 1.0)), 2U);
}

TEST(Onset, RefusesAnElementThatIsNotThere) {
  const auto onset = find_onset(kPress, onset_of(OnsetQuantity::kValue, 1.0, 2));
  ASSERT_FALSE(onset);
  EXPECT_EQ(onset.error().kind, ErrorKind::kUsage);
  EXPECT_EQ(onset.error().what, "element 2 of the onset does not exist: the frames have 1");
}

Matrix<float> ramp() {
  return column({0, 1, 2, 3, 4, 5});
}

OnsetParameters window_of(double threshold, std::size_t before, std::size_t length,
                          BeyondFrames beyond) {
  OnsetParameters parameters = onset_of(OnsetQuantity::kValue, threshold);
  parameters.before = before;
  parameters.length = length;
  parameters.beyond = beyond;
  return parameters;
}

TEST(OnsetWindow, StartsAtTheOnsetOrBefore) {
  for (const BeyondFrames beyond : {BeyondFrames::kRefuse, BeyondFrames::kHold}) {
    EXPECT_EQ(window_at_onset(ramp(), window_of(3.0, 0, 2, beyond)), column({3, 4}));
    EXPECT_EQ(window_at_onset(ramp(), window_of(3.0, 3, 6, beyond)), ramp());
    EXPECT_EQ(window_at_onset(ramp(), window_of(5.0, 2, 1, beyond)), column({3}));
  }
}

TEST(OnsetWindow, KeepsAllElements) {
  const Matrix<float> frames(3, 2, {0, 1, 7, 2, 8, 3});
  EXPECT_EQ(window_at_onset(frames, window_of(7.0, 0, 2, BeyondFrames::kRefuse)),
            Matrix<float>(2, 2, {7, 2, 8, 3}));
}

TEST(OnsetWindow, RefusesToReachBeyondTheFrames) {
  const auto late = window_at_onset(ramp(), window_of(3.0, 1, 5, BeyondFrames::kRefuse));
  ASSERT_FALSE(late);
  EXPECT_EQ(late.error().kind, ErrorKind::kData);
  EXPECT_EQ(late.error().what,
            "the window of 5 frames from 1 before the onset in frame 4 extends beyond the 6 frames "
            "of the exploration");
  EXPECT_FALSE(window_at_onset(ramp(), window_of(1.0, 2, 1, BeyondFrames::kRefuse)));
}

TEST(OnsetWindow, HoldsTheFirstAndTheLastFrameOnRequest) {
  EXPECT_EQ(window_at_onset(ramp(), window_of(4.0, 0, 4, BeyondFrames::kHold)),
            column({4, 5, 5, 5}));
  EXPECT_EQ(window_at_onset(ramp(), window_of(1.0, 3, 5, BeyondFrames::kHold)),
            column({0, 0, 0, 1, 2}));
  EXPECT_EQ(window_at_onset(ramp(), window_of(0.0, 9, 2, BeyondFrames::kHold)), column({0, 0}));
}

TEST(OnsetWindow, NeedsAnOnsetAndAFrame) {
  EXPECT_FALSE(window_at_onset(ramp(), window_of(6.0, 0, 1, BeyondFrames::kHold)));
  EXPECT_THROW((void)window_at_onset(ramp(), window_of(1.0, 0, 0, BeyondFrames::kHold)),
               InvalidArgument);
}

TEST(OnsetParameters, AreReadByTheirNames) {
  const Table table{"",
                    {{"element", "", Value{std::int64_t{3}}},
                     {"quantity", "", Value{std::string("magnitude")}},
                     {"threshold", "", Value{0.25}},
                     {"before", "", Value{std::int64_t{4}}},
                     {"length", "", Value{std::int64_t{50}}},
                     {"beyond", "", Value{std::string("hold")}}}};
  const auto parameters = read_parameters<OnsetParameters>(table);
  ASSERT_TRUE(parameters);
  EXPECT_EQ(parameters->element, 3U);
  EXPECT_EQ(parameters->quantity, OnsetQuantity::kMagnitude);
  EXPECT_EQ(parameters->threshold, 0.25);
  EXPECT_EQ(parameters->before, 4U);
  EXPECT_EQ(parameters->length, 50U);
  EXPECT_EQ(parameters->beyond, BeyondFrames::kHold);
}

}  // namespace
}  // namespace somato
