#include "systems/model/element_names.h"

#include <gtest/gtest.h>

#include "systems/support/systems.h"

namespace somato {
namespace {

using Names = std::vector<std::string>;
using testing::build;
using testing::hand_recording;
using testing::module;

Recording named_hand() {
  Recording recording = hand_recording(2, 1);
  for (Exploration& exploration : recording.explorations) {
    exploration.channels[2].element_names = {"thumb", "index", "little"};
  }
  return recording;
}

Names names_of(const std::string& text, const std::string& name) {
  const System system = build(text, named_hand());
  return element_names(system, *system.find(name));
}

const std::string kHandJoints = module("joints", "channel", "channel = 'joints'");

TEST(ElementNames, AreThoseOfTheChannelThroughModulesThatKeepElements) {
  const std::string text = kHandJoints + module("last", "last", "input = 'joints'") +
                           module("scaled", "scale", "input = 'last'\nfactor = 2");
  EXPECT_EQ(names_of(text, "scaled"), (Names{"joints thumb", "joints index", "joints little"}));
}

TEST(ElementNames, FollowASelectionOfElements) {
  const std::string text =
      module("some", "channel", "channel = 'joints'\nelements = ['3', 'thumb']");
  EXPECT_EQ(names_of(text, "some"), (Names{"joints little", "joints thumb"}));
}

TEST(ElementNames, OfAConcatenationFollowEachOther) {
  const std::string text = kHandJoints + module("height", "channel", "channel = 'height'") +
                           module("a", "last", "input = 'joints'") +
                           module("b", "mean", "input = 'height'") +
                           module("both", "concatenation", "inputs = ['b', 'a']");
  EXPECT_EQ(names_of(text, "both"),
            (Names{"height 1", "joints thumb", "joints index", "joints little"}));
}

TEST(ElementNames, OfOtherModulesAreTheirNumbers) {
  const std::string text =
      kHandJoints + module("curve", "resampling", "input = 'joints'\npoints = 2");
  const Names names = names_of(text, "curve");
  ASSERT_EQ(names.size(), 6U);
  EXPECT_EQ(names[5], "curve 6");
}

TEST(ElementNames, OfAnOnlyChannelHaveNoPrefix) {
  Recording recording = named_hand();
  for (Exploration& exploration : recording.explorations) {
    std::erase_if(exploration.channels,
                  [](const Channel& channel) { return channel.name != "joints"; });
  }
  const System system = build(kHandJoints, recording);
  EXPECT_EQ(element_names(system, 0), (Names{"thumb", "index", "little"}));
}

}  // namespace
}  // namespace somato
