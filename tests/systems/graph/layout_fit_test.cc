#include "systems/graph/layout_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>

#include "systems/support/systems.h"

namespace somato {
namespace {

System trained_on(const Recording& recording) {
  const std::string text =
      testing::channels({"joints"}) + testing::module("rest", "last", "input = 'joints'");
  return testing::build(text, recording);
}

Channel& find_joints(Exploration& exploration) {
  return *std::find_if(exploration.channels.begin(), exploration.channels.end(),
                       [](const Channel& channel) { return channel.name == "joints"; });
}

TEST(LayoutFit, AcceptsTheChannelsOfTheTrainingData) {
  Recording recording = testing::hand_recording(2, 1);
  const System system = trained_on(recording);
  EXPECT_TRUE(check_layout(system, layout_of(recording)));
  recording.explorations.resize(1);
  for (Channel& channel : recording.explorations[0].channels) {
    channel.frames = Matrix<float>(0, channel.frames.columns());
  }
  EXPECT_TRUE(check_layout(system, layout_of(recording))) << "frames are not part of the layout";
}

TEST(LayoutFit, NamesWhatDiffers) {
  const Recording recording = testing::hand_recording(2, 1);
  const System system = trained_on(recording);
  RecordingLayout layout = layout_of(recording);
  for (ChannelLayout& channel : layout.channels) {
    if (channel.name == "joints") channel.shape = {5};
  }
  const auto wider = check_layout(system, layout);
  ASSERT_FALSE(wider);
  EXPECT_NE(wider.error().what.find("'joints' gives"), std::string::npos) << wider.error().what;
  for (ChannelLayout& channel : layout.channels) {
    if (channel.name == "joints") channel.name = "elbows";
  }
  const auto missing = check_layout(system, layout);
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.error().what.find("joints"), std::string::npos) << missing.error().what;
}

// Values of other elements or units would be taken for those of the training.
TEST(LayoutFit, RefusesOtherElementsAndUnits) {
  Recording recording = testing::hand_recording(2, 1);
  for (Exploration& exploration : recording.explorations) {
    Channel& joints = find_joints(exploration);
    joints.unit = "deg";
    joints.element_names.clear();
    for (std::size_t i = 0; i < joints.frames.columns(); ++i) {
      joints.element_names.push_back("joint_" + std::to_string(i));
    }
  }
  const System system = trained_on(recording);
  const RecordingLayout layout = layout_of(recording);
  EXPECT_TRUE(check_layout(system, layout));
  for (const bool has_other_unit : {false, true}) {
    RecordingLayout other = layout;
    for (ChannelLayout& channel : other.channels) {
      if (channel.name != "joints") continue;
      if (has_other_unit) channel.unit = "rad";
      if (!has_other_unit) std::swap(channel.element_names[0], channel.element_names[1]);
    }
    const auto checked = check_layout(system, other);
    ASSERT_FALSE(checked);
    EXPECT_NE(checked.error().what.find(has_other_unit ? "is in 'rad', but was in 'deg'"
                                                       : "has the elements 'joint_1', 'joint_0'"),
              std::string::npos)
        << checked.error().what;
    for (ChannelLayout& channel : other.channels) {
      channel.unit.clear();
      channel.element_names.clear();
    }
    EXPECT_TRUE(check_layout(system, other)) << "nothing is stated";
  }
}

}  // namespace
}  // namespace somato
