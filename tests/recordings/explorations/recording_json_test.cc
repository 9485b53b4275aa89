#include "recordings/explorations/recording_json.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

using Json = nlohmann::ordered_json;

TEST(LabelsJson, IsAnObjectInTheOrderOfTheLabels) {
  EXPECT_EQ(detail::labels_json({{"trial", "2"}, {"object", "a \"cube\""}}).dump(),
            R"({"trial":"2","object":"a \"cube\""})");
  EXPECT_EQ(detail::labels_json({}).dump(), "{}");
}

TEST(ChannelJson, NamesElementsThatHaveNoNamesByTheirNumbers) {
  Channel channel;
  channel.name = "touch";
  channel.unit = "N";
  channel.frames = Matrix<float>(3, 4);
  channel.shape = {2, 2};
  EXPECT_EQ(detail::channel_json(channel),
            Json::parse(R"({"name": "touch", "unit": "N", "elements": ["1", "2", "3", "4"],
                            "shape": [2, 2]})"));
}

TEST(ChannelJson, KeepsTheNamesOfElements) {
  Channel channel;
  channel.name = "joints";
  channel.frames = Matrix<float>(0, 2);
  channel.element_names = {"thumb", "finger"};
  const Json json = detail::channel_json(channel);
  EXPECT_EQ(json["elements"], (Json{"thumb", "finger"}));
  EXPECT_EQ(json["shape"], (Json{2}));
}

}  // namespace
}  // namespace somato
