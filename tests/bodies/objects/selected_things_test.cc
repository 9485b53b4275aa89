#include "bodies/objects/selected_things.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

Recording stock(const char* label = "object") {
  Recording recording;
  for (const char* trial : {"1", "2", "3"}) {
    for (const char* thing : {"cup", "box", "egg"}) {
      recording.explorations.push_back({{{label, thing}, {"trial", trial}}, "", {}});
    }
  }
  return recording;
}

std::string text_of(const Result<Recording>& recording) {
  if (!recording) return to_string(recording.error());
  std::string text;
  for (const Exploration& exploration : recording->explorations) {
    text += exploration.labels[0].value + exploration.labels[1].value + " ";
  }
  return text;
}

TEST(SelectedThings, ComeObjectAfterObjectInTheOrderOfTheirNames) {
  EXPECT_EQ(text_of(select_things(stock(), {{"egg", "cup"}, 2})), "egg1 egg2 cup1 cup2 ");
  EXPECT_EQ(text_of(select_things(stock(), {{"egg"}, {}})), "egg1 egg2 egg3 ");
  EXPECT_EQ(text_of(select_things(stock("material"), {{}, 1})), "cup1 box1 egg1 ");
  EXPECT_EQ(text_of(select_things(stock(), {})), text_of(stock()));
}

TEST(SelectedThings, OthersThanThoseOfTheRecordingAreRefused) {
  EXPECT_NE(text_of(select_things(stock(), {{"cap"}, {}})).find("did you mean 'cup'"),
            std::string::npos);
  EXPECT_EQ(text_of(select_things(stock(), {{"cup", "box", "cup"}, {}})),
            "cup: 'cup' is selected twice; name each object or material once");
  EXPECT_EQ(text_of(select_things(stock(), {{"box"}, 4})),
            "box: 'box' has 3 explorations, not 4; select fewer of each, or explore more");
  EXPECT_NE(text_of(select_things(stock("person"), {{"cup"}, {}})).find("neither a label"),
            std::string::npos);
  EXPECT_NE(text_of(select_things({}, {{"cup"}, {}})).find("neither a label"), std::string::npos);
}

}  // namespace
}  // namespace somato
