#include "studies/codes/representation.h"

#include <gtest/gtest.h>

#include "studies/support/made_senses.h"

namespace somato {
namespace {

std::vector<float> numbers(const Samples& samples) {
  std::vector<float> values;
  for (std::size_t i = 0; i < samples.count(); ++i) {
    values.insert(values.end(), samples[i].values.begin(), samples[i].values.end());
  }
  return values;
}

Code mean_code(const Recording& frames) {
  return codes_of({{}, {"touch"}}, facts_of(frames, false))[1];
}

TEST(Representation, IsComputedFromTheFramesOfEachView) {
  const Recording frames = testing::frames_as_given("touch", {{1, 3, 5, 7}, {2, 2, 4, 4}});
  const auto found =
      represent(all_views_of(frames), mean_code(frames), {Scaling::kNone}, 100, 1).value();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(numbers(found[0].vectors[View::kWhole]), (std::vector<float>{4, 3}));
  EXPECT_EQ(numbers(found[0].vectors[View::kOdd]), (std::vector<float>{3, 3}));
  EXPECT_EQ(numbers(found[0].vectors[View::kSecond]), (std::vector<float>{6, 4}));
}

// The whole explorations have the mean 3.5 and the standard deviation 0.5.
TEST(Representation, AStandardizationIsFittedToWholeExplorations) {
  const Recording frames = testing::frames_as_given("touch", {{1, 3, 5, 7}, {2, 2, 4, 4}});
  const auto found =
      represent(all_views_of(frames), mean_code(frames), {Scaling::kStandardized}, 100, 1).value();
  EXPECT_EQ(numbers(found[0].vectors[View::kWhole]), (std::vector<float>{1, -1}));
  EXPECT_EQ(numbers(found[0].vectors[View::kSecond]), (std::vector<float>{5, 1}));
}

TEST(Representation, ASingleFrameIsSeenByItsElements) {
  Recording frames = testing::frames_as_given("touch", {{0}, {0}});
  frames.explorations[0].channels[0].frames = Matrix<float>(1, 3, {1, 2, 3});
  frames.explorations[1].channels[0].frames = Matrix<float>(1, 3, {3, 2, 7});
  const Code last = codes_of({{}, {"touch"}}, facts_of(frames, false))[0];
  const auto found =
      represent(all_views_of(frames), last, {Scaling::kStandardized}, 100, 1).value();
  EXPECT_EQ(numbers(found[0].vectors[View::kWhole]), (std::vector<float>{-1, 0, -1, 1, 0, 1}));
  EXPECT_EQ(numbers(found[0].vectors[View::kEven]), (std::vector<float>{0, 0}));
  EXPECT_EQ(numbers(found[0].vectors[View::kFirst]), (std::vector<float>{-1, 0, 1, 0}));
}

TEST(Representation, LongVectorsAreRefused) {
  const Recording frames = testing::frames_as_given("touch", {{1, 3}, {2, 2}});
  const Code curve = codes_of({{}, {"touch"}}, facts_of(frames, false))[3];
  const auto found = represent(all_views_of(frames), curve, {Scaling::kNone}, 9, 1);
  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().what, "'curve_of_touch' has 10 elements, more than 9");
}

}  // namespace
}  // namespace somato
