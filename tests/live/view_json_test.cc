#include "live/view_json.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "somato/bodies/material_colour.h"

namespace somato::live {
namespace {

TEST(FrameText, WritesWhatIsNotFiniteAsNull) {
  const std::array<float, 3> values{1.5F, std::numeric_limits<float>::quiet_NaN(),
                                    std::numeric_limits<float>::infinity()};
  ShownMoment moment;
  moment.channels.emplace_back("touch", values);
  moment.poses.resize(1);
  moment.poses[0].position[2] = std::numeric_limits<double>::quiet_NaN();
  const Json frame = Json::parse(frame_text(moment, nullptr, nullptr));
  EXPECT_EQ(frame["channels"]["touch"], (Json{1.5, nullptr, nullptr}));
  EXPECT_EQ(frame["poses"], (Json{0, 0, nullptr, 1, 0, 0, 0}));
}

TEST(ThingJson, TellsTheColourOfItsMaterialWhereItIsKnown) {
  Material material;
  material.name = "wood";
  EXPECT_EQ(thing_json({"ball", {}, material})["colour"], Json(*material_colour("wood")));
  material.name = "cork";
  EXPECT_EQ(thing_json({"ball", {}, material})["colour"], nullptr);
}

}  // namespace
}  // namespace somato::live
