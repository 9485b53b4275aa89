#include "views/session/view_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "base/support/json_schema.h"
#include "bodies/objects/material_colour.h"

namespace somato::live {
namespace {

using testing::fits_schema;

TEST(FrameText, WritesWhatIsNotFiniteAsNull) {
  const std::vector<float> values{1.5F, std::numeric_limits<float>::quiet_NaN(),
                                  std::numeric_limits<float>::infinity()};
  ShownMoment moment;
  moment.channels.emplace_back("touch", values);
  moment.poses.resize(1);
  moment.poses[0].position[2] = std::numeric_limits<double>::quiet_NaN();
  const std::string text = frame_text(moment, nullptr, nullptr);
  EXPECT_TRUE(testing::text_fits_schema(text, "view.json#/$defs/Frame"));
  const Json frame = Json::parse(text);
  EXPECT_EQ(frame["channels"]["touch"], (Json{1.5, nullptr, nullptr}));
  EXPECT_EQ(frame["poses"], (Json{0, 0, nullptr, 1, 0, 0, 0}));
}

// Masked values are 0 in a channel, and no value in a page.
TEST(ShownValues, AreMissingWhereTheChannelMarksThem) {
  Channel skin;
  skin.frames = Matrix<float>(2, 3, {1, 0, 3, 0, 5, 0});
  skin.valid = Matrix<std::uint8_t>(2, 3, {1, 0, 1, 1, 1, 0});
  const std::vector<float> first = shown_values(skin, 10.0, 1);
  EXPECT_EQ(first[0], 1.0F);
  EXPECT_TRUE(std::isnan(first[1]));
  const std::vector<float> second = shown_values(skin, 10.0, 2);
  EXPECT_EQ(second[0], 0.0F);
  EXPECT_TRUE(std::isnan(second[2]));
  Channel sound;
  sound.frames = Matrix<float>(1000, 1, 2.0F);
  sound.valid = Matrix<std::uint8_t>(1000, 1, 1);
  sound.valid(999, 0) = 0;
  const std::vector<float> stretch = shown_values(sound, 8192.0, 1000);
  ASSERT_EQ(stretch.size(), 512U);
  EXPECT_EQ(stretch[510], 2.0F);
  EXPECT_TRUE(std::isnan(stretch[511]));
}

TEST(ThingJson, HasTheColourOfAKnownMaterial) {
  Material material;
  material.name = "wood";
  EXPECT_EQ(thing_json({"ball", {}, material})["colour"], Json(*material_colour("wood")));
  material.name = "cork";
  EXPECT_EQ(thing_json({"ball", {}, material})["colour"], nullptr);
}

TEST(ThingJson, OfAnObjectOrAMaterialFitsItsSchema) {
  Object object;
  object.shape = Shape::kCone;
  object.size = {60.0, 60.0, 90.0};
  object.mass = 0.4;
  object.material.name = "wood";
  const Json cone = thing_json({"cone", object, object.material});
  EXPECT_EQ(cone["shape"], "cone");
  EXPECT_TRUE(fits_schema(cone, "parts.json#/$defs/ThingData"));
  EXPECT_TRUE(fits_schema(thing_json({"cork", {}, {}}), "parts.json#/$defs/ThingData"));
}

TEST(SceneJson, FitsItsSchemaWithEachKindOfGeom) {
  Scene scene;
  scene.bodies = {"finger"};
  for (const auto& [shape, name] : Choices<GeomShape>::all()) {
    SceneGeom geom;
    geom.name = name;
    geom.shape = shape;
    geom.size = {0.1, 0.2, 0.3};
    scene.geoms.push_back(geom);
  }
  scene.geoms.front().body = 0;
  scene.geoms.front().taxel = 3;
  scene.geoms.front().role = GeomRole::kObject;
  scene.geoms.back().vertices = {0.0F, 0.5F, 1.0F};
  scene.geoms.back().faces = {0, 0, 0};
  const Json json = scene_json(scene);
  EXPECT_TRUE(fits_schema(json, "view.json#/$defs/Scene"));
  EXPECT_EQ(json["geoms"][0]["body"], 0);
  EXPECT_EQ(json["geoms"][1]["body"], -1);
  EXPECT_FALSE(json["geoms"][1].contains("vertices"));
  EXPECT_EQ(json["geoms"].back()["faces"], Json({0, 0, 0}));
}

}  // namespace
}  // namespace somato::live
