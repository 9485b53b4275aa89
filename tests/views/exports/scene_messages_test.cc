#include "views/exports/scene_messages.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "recordings/ros/channel_reader.h"
#include "recordings/ros/definition.h"

namespace somato {
namespace {

// The numbers at a path of a message, read by the definition in its schema.
std::vector<double> numbers(const McapSchema& schema, const std::string& message,
                            const std::string& path) {
  auto type = compile_ros_definition(schema.name, schema.encoding, schema.data);
  if (!type) ADD_FAILURE() << to_string(type.error());
  const auto reader =
      ChannelReader::compile(std::make_shared<const RosType>(std::move(*type)), {path});
  if (!reader) ADD_FAILURE() << to_string(reader.error());
  std::vector<double> values;
  const Result<void> read = reader->read(message, values);
  if (!read) ADD_FAILURE() << to_string(read.error());
  return values;
}

using Coordinates = std::vector<double>;

constexpr std::int64_t kTime = 3'000'000'007;

TEST(SceneMessages, EveryBodyIsAnEntityInItsFrame) {
  SceneGeom box{.body = 0, .shape = GeomShape::kBox, .size = {1.0, 2.0, 3.0}};
  box.pose = {{0.5, 0.25, 0.125}, {0.1, 0.2, 0.3, 0.4}};
  box.colour = {0.2, 0.4, 0.6, 0.8};
  const SceneGeom ball{.shape = GeomShape::kSphere, .size = {4.0, 0.0, 0.0}};
  const SceneGeom egg{.shape = GeomShape::kEllipsoid, .size = {1.0, 2.0, 3.0}};
  const McapSchema schema = scene_update_schema();
  const std::string message =
      scene_update_message(kTime, {"palm"}, std::vector<SceneGeom>{box, ball, egg});
  const auto at = [&](const std::string& path) { return numbers(schema, message, path); };
  EXPECT_EQ(at("deletions"), (Coordinates{3, 7, 1}));
  EXPECT_EQ(at("entities[*].timestamp"), (Coordinates{3, 7, 3, 7}));
  EXPECT_EQ(at("entities[*].frame_locked"), (Coordinates{1, 1}));
  EXPECT_EQ(at("entities[0].cubes"),
            (Coordinates{0.5, 0.25, 0.125, 0.2, 0.3, 0.4, 0.1, 2.0, 4.0, 6.0, 0.2, 0.4, 0.6, 0.8}));
  EXPECT_EQ(at("entities[1].cubes"), Coordinates{});
  EXPECT_EQ(at("entities[1].spheres[*].size"), (Coordinates{8.0, 8.0, 8.0, 2.0, 4.0, 6.0}));
}

TEST(SceneMessages, ACapsuleIsACylinderWithTwoSpheres) {
  SceneGeom capsule{.shape = GeomShape::kCapsule, .size = {0.5, 2.0, 0.0}};
  const double half = std::sqrt(0.5);
  capsule.pose = {{10.0, 0.0, 0.0}, {half, half, 0.0, 0.0}};  // Its axis turns from z to -y.
  const McapSchema schema = scene_update_schema();
  const std::string message = scene_update_message(kTime, {}, std::vector<SceneGeom>{capsule});
  EXPECT_EQ(numbers(schema, message, "entities[0].cylinders[*].size"),
            (Coordinates{1.0, 1.0, 4.0}));
  EXPECT_EQ(numbers(schema, message, "entities[0].cylinders[*].top_scale"), Coordinates{1.0});
  const Coordinates ends = numbers(schema, message, "entities[0].spheres[*].pose.position");
  const Coordinates expected{10.0, 2.0, 0.0, 10.0, -2.0, 0.0};
  ASSERT_EQ(ends.size(), expected.size());
  for (std::size_t i = 0; i < ends.size(); ++i) EXPECT_NEAR(ends[i], expected[i], 1e-12) << i;
}

TEST(SceneMessages, AMeshKeepsItsCornersAndFaces) {
  SceneGeom mesh{.shape = GeomShape::kMesh};
  mesh.vertices = {0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 0.0F, 1.0F, 0.5F};
  mesh.faces = {2, 0, 1};
  const McapSchema schema = scene_update_schema();
  const std::string message = scene_update_message(kTime, {}, std::vector<SceneGeom>{mesh});
  EXPECT_EQ(numbers(schema, message, "entities[0].triangles[*].points"),
            (Coordinates{0, 0, 0, 1, 0, 0, 0, 1, 0.5}));
  EXPECT_EQ(numbers(schema, message, "entities[0].triangles[*].indices"), (Coordinates{2, 0, 1}));
}

TEST(SceneMessages, PosesAreTransformsFromTheWorld) {
  const McapSchema schema = transforms_schema();
  const std::string message =
      transforms_message(kTime, {"a", "b"}, {{{1, 2, 3}, {0.5, 0.1, 0.2, 0.3}}, {{4, 5, 6}, {}}});
  EXPECT_EQ(numbers(schema, message, "transforms[*].header.stamp"), (Coordinates{3, 7, 3, 7}));
  EXPECT_EQ(numbers(schema, message, "transforms[0].transform"),
            (Coordinates{1, 2, 3, 0.1, 0.2, 0.3, 0.5}));
  EXPECT_EQ(numbers(schema, message, "transforms[1].transform.translation"),
            (Coordinates{4, 5, 6}));
}

TEST(SceneMessages, PointsHavePlaceAndValue) {
  const McapSchema schema = point_cloud_schema();
  const std::string message = point_cloud_message(kTime, {{{1, 2, 3}, 4.0F}, {{5, 6, 7}, 8.0F}});
  const auto at = [&](const std::string& path) { return numbers(schema, message, path); };
  EXPECT_EQ(at("width"), Coordinates{2});
  EXPECT_EQ(at("point_step"), Coordinates{16});
  EXPECT_EQ(at("row_step"), Coordinates{32});
  EXPECT_EQ(at("fields[*].offset"), (Coordinates{0, 4, 8, 12}));
  EXPECT_EQ(at("fields[*].datatype"), (Coordinates{7, 7, 7, 7}));
  const Coordinates data = at("data");
  ASSERT_EQ(data.size(), 32U);
  EXPECT_EQ((Coordinates{data.begin() + 12, data.begin() + 16}),
            (Coordinates{0, 0, 0x80, 0x40}));  // 4.0F
  EXPECT_EQ(at("is_dense"), Coordinates{1});
}

}  // namespace
}  // namespace somato
