#include "systems/graph/layout_fit.h"

#include <gtest/gtest.h>

#include "systems/support/systems.h"

namespace somato {
namespace {

System trained_on(const Recording& recording) {
  const std::string text =
      testing::channels({"joints"}) + testing::module("rest", "last", "input = 'joints'");
  return testing::build(text, recording);
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

}  // namespace
}  // namespace somato
