#include "somato/recording/recording.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace somato {
namespace {

Exploration exploration_of(const std::string& object, const std::string& trial) {
  return {{{"object", object}, {"trial", trial}},
          object + "_" + trial + ".txt",
          {{"joints", "deg", {"thumb", "index"}, Matrix<float>(3, 2, 1.0F), {0.0, 0.1, 0.1}},
           {"touch", "counts", {}, Matrix<float>(2, 4, 2.0F), {}}}};
}

Recording recording_of_two() {
  return {{exploration_of("ball", "1"), exploration_of("cube", "1")}};
}

// Validates a good recording after `spoil` did something to its second exploration.
Error error_after(const std::function<void(Exploration&)>& spoil) {
  Recording recording = recording_of_two();
  spoil(recording.explorations[1]);
  const Result<void> checked = validate(recording);
  return checked ? Error{} : checked.error();
}

TEST(FindChannel, FindsItByName) {
  const Exploration exploration = exploration_of("ball", "1");
  const auto touch = find_channel(exploration, "touch");
  ASSERT_TRUE(touch);
  EXPECT_EQ(*touch, &exploration.channels[1]);
}

TEST(FindChannel, NamesTheNearestWhenUnknown) {
  const Exploration exploration = exploration_of("ball", "1");
  const auto found = find_channel(exploration, "joint");
  ASSERT_FALSE(found);
  EXPECT_EQ(to_string(found.error()),
            "ball_1.txt: unknown channel 'joint'; did you mean 'joints'?");
}

TEST(FindLabel, GivesTheValueOrTheNearestName) {
  const Exploration exploration = exploration_of("ball", "7");
  EXPECT_EQ(find_label(exploration, "trial"), "7");
  const auto found = find_label(exploration, "objects");
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().kind, ErrorKind::kUsage);
  EXPECT_EQ(to_string(found.error()),
            "ball_7.txt: unknown label 'objects'; did you mean 'object'?");
}

TEST(LabelValues, ComeOnceEachInOrderOfAppearance) {
  const Recording recording{{exploration_of("cube", "1"), exploration_of("ball", "1"),
                             exploration_of("cube", "2"), exploration_of("apple", "1")}};
  EXPECT_EQ(label_values(recording, "object"), (std::vector<std::string>{"cube", "ball", "apple"}));
  EXPECT_EQ(label_values(recording, "trial"), (std::vector<std::string>{"1", "2"}));
  EXPECT_FALSE(label_values(recording, "material"));
  EXPECT_EQ(label_values(Recording{}, "object"), std::vector<std::string>{});
}

TEST(Validate, AcceptsARecordingThatFits) {
  EXPECT_TRUE(validate(recording_of_two()));
}

TEST(Validate, RefusesNothing) {
  ASSERT_FALSE(validate(Recording{}));
  EXPECT_EQ(validate(Recording{}).error().what, "the recording has no explorations");
  EXPECT_EQ(error_after([](Exploration& e) { e.channels.clear(); }).what,
            "the exploration has no channels");
  EXPECT_EQ(error_after([](Exploration& e) { e.channels[0].frames = {}; }).what,
            "channel 'joints' has no frames");
}

TEST(Validate, PointsAtTheSourceOrTheNumber) {
  EXPECT_EQ(error_after([](Exploration& e) { e.channels.clear(); }).where, "cube_1.txt");
  EXPECT_EQ(error_after([](Exploration& e) { e = {}; }).where, "exploration 2");
  EXPECT_EQ(error_after([](Exploration& e) { e = {}; }).kind, ErrorKind::kData);
}

TEST(Validate, RefusesNamesThatAreMissingOrDouble) {
  EXPECT_EQ(error_after([](Exploration& e) { e.labels[1].name = "object"; }).what,
            "there are two labels 'object'");
  EXPECT_EQ(error_after([](Exploration& e) { e.labels[1].name = ""; }).what, "a label has no name");
  EXPECT_EQ(error_after([](Exploration& e) { e.channels[1].name = "joints"; }).what,
            "there are two channels 'joints'");
  EXPECT_EQ(error_after([](Exploration& e) { e.channels[0].name = ""; }).what,
            "a channel has no name");
}

TEST(Validate, RefusesElementNamesAndTimesThatDoNotFit) {
  EXPECT_EQ(error_after([](Exploration& e) { e.channels[0].element_names = {"thumb"}; }).what,
            "channel 'joints' has 1 element names for 2 elements");
  EXPECT_EQ(error_after([](Exploration& e) { e.channels[1].times = {0.0}; }).what,
            "channel 'touch' has 1 times for 2 frames");
  EXPECT_EQ(error_after([](Exploration& e) { e.channels[1].times = {0.5, 0.25}; }).what,
            "channel 'touch', frame 2: the time 0.25 s is not finite or precedes that of the "
            "preceding frame");
  EXPECT_EQ(error_after([](Exploration& e) { e.channels[1].times = {HUGE_VAL, HUGE_VAL}; }).what,
            "channel 'touch', frame 1: the time inf s is not finite or precedes that of the "
            "preceding frame");
}

TEST(Validate, RefusesWhatIsNotFinite) {
  EXPECT_EQ(error_after([](Exploration& e) { e.channels[1].frames(1, 3) = std::nanf(""); }).what,
            "channel 'touch', frame 2, element 4: nan is not a finite number");
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(error_after([&](Exploration& e) { e.channels[0].frames(0, 0) = -infinity; }).what,
            "channel 'joints', frame 1, element 1: -inf is not a finite number");
}

TEST(Validate, RefusesExplorationsThatDiffer) {
  EXPECT_EQ(error_after([](Exploration& e) { e.channels[1].frames = {2, 5, 0.0F}; }).what,
            "channel 'touch' has 5 elements, but 4 in the first exploration");
  EXPECT_EQ(error_after([](Exploration& e) { e.channels[0].unit = "rad"; }).what,
            "channel 'joints' is in 'rad', but in 'deg' in the first exploration");
  EXPECT_EQ(error_after([](Exploration& e) { e.channels[0].element_names[1] = "little"; }).what,
            "its elements of channel 'joints' are 'thumb, little', but those of the first "
            "exploration are 'thumb, index'");
  EXPECT_EQ(error_after([](Exploration& e) { e.labels.pop_back(); }).what,
            "its labels are 'object', but those of the first exploration are 'object, trial'");
  EXPECT_EQ(error_after([](Exploration& e) { e.channels.pop_back(); }).what,
            "its channels are 'joints', but those of the first exploration are 'joints, touch'");
}

TEST(Validate, AllowsDifferentNumbersOfFrames) {
  EXPECT_EQ(
      error_after([](Exploration& e) { e.channels[1].frames = Matrix<float>(7, 4, 0.0F); }).what,
      "");
}

TEST(Validate, AcceptsARateAShapeAndAMask) {
  Recording recording = recording_of_two();
  for (Exploration& exploration : recording.explorations) {
    Channel& touch = exploration.channels[1];
    touch.rate = 50.0;
    touch.shape = {2, 2};
    touch.valid = Matrix<std::uint8_t>(2, 4, 1);
    touch.valid(1, 3) = 0;
    touch.frames(1, 3) = 0.0F;
  }
  EXPECT_TRUE(validate(recording));
}

TEST(Validate, RefusesARateThatIsNoneOrBesideTimes) {
  EXPECT_NE(error_after([](Exploration& e) { e.channels[1].rate = -1.0; }).what.find("-1 Hz"),
            std::string::npos);
  EXPECT_NE(error_after([](Exploration& e) { e.channels[0].rate = 10.0; }).what.find("both"),
            std::string::npos);
}

TEST(Validate, RefusesAShapeThatDoesNotFitOrDiffers) {
  EXPECT_EQ(error_after([](Exploration& e) { e.channels[1].shape = {3, 2}; }).what,
            "channel 'touch' has frames of 4 elements, which do not fill its shape 3 x 2");
  EXPECT_NE(error_after([](Exploration& e) { e.channels[1].shape = {4, 0}; }).what, "");
  EXPECT_EQ(error_after([](Exploration& e) { e.channels[1].shape = {2, 2}; }).what,
            "channel 'touch' has the shape 2 x 2, but 4 in the first exploration");
}

TEST(Validate, RefusesAMaskThatDoesNotFit) {
  EXPECT_NE(error_after([](Exploration& e) {
              e.channels[1].valid = Matrix<std::uint8_t>(2, 3, 1);
            }).what.find("2 x 3 validity marks"),
            std::string::npos);
  EXPECT_NE(error_after([](Exploration& e) {
              e.channels[1].valid = Matrix<std::uint8_t>(2, 4, 2);
            }).what.find("0 or 1"),
            std::string::npos);
  EXPECT_NE(error_after([](Exploration& e) {
              e.channels[1].valid = Matrix<std::uint8_t>(2, 4, 0);
            }).what.find("frame 1, element 1"),
            std::string::npos);
}

TEST(Channel, KnowsItsRateFromTheMedianStep) {
  Channel channel{"touch", "", {}, Matrix<float>(4, 1), {0.0, 0.1, 0.2, 0.9}};
  EXPECT_NEAR(channel.frame_rate(), 10.0, 1e-9);
  channel.times.clear();
  EXPECT_EQ(channel.frame_rate(), 0.0);
  channel.rate = 16000.0;
  EXPECT_EQ(channel.frame_rate(), 16000.0);
}

}  // namespace
}  // namespace somato
