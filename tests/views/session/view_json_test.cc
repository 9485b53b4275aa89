#include "views/session/view_json.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

#include "base/support/json_schema.h"
#include "bodies/objects/material_colour.h"

namespace somato::live {
namespace {

using testing::fits_schema;

TEST(FrameText, WritesWhatIsNotFiniteAsNull) {
  const std::array<float, 3> values{1.5F, std::numeric_limits<float>::quiet_NaN(),
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
