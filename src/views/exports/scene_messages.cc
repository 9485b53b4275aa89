#include "views/exports/scene_messages.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string_view>
#include <utility>

#include "recordings/explorations/nanoseconds.h"
#include "recordings/ros/cdr.h"

namespace somato {
namespace {

struct Definition {
  std::string_view type;
  std::string_view fields;
};

constexpr Definition kTime{"builtin_interfaces/Time", "int32 sec\nuint32 nanosec\n"};
constexpr Definition kHeader{"std_msgs/Header", "builtin_interfaces/Time stamp\nstring frame_id\n"};
constexpr Definition kVector{"geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z\n"};
constexpr Definition kQuaternion{"geometry_msgs/Quaternion",
                                 "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n"};

// The schema of a type with the definitions that it uses.
McapSchema schema_of(std::string name, std::string_view fields, std::span<const Definition> used) {
  std::string text(fields);
  for (const Definition& definition : used) {
    text += fmt::format("{:=<80}\nMSG: {}\n{}", "", definition.type, definition.fields);
  }
  return {0, std::move(name), "ros2msg", std::move(text)};
}

CdrWriter& add_time(CdrWriter& to, std::int64_t time) {
  constexpr std::int64_t kLastSecond = std::numeric_limits<std::int32_t>::max();
  return to.number(static_cast<std::int32_t>(std::min(time / kNanosecondsASecond, kLastSecond)))
      .number(static_cast<std::uint32_t>(time % kNanosecondsASecond));
}

CdrWriter& add_count(CdrWriter& to, std::size_t count) {
  return to.number(static_cast<std::uint32_t>(count));
}

CdrWriter& add_vector(CdrWriter& to, const std::array<double, 3>& vector) {
  for (const double value : vector) to.number(value);
  return to;
}

// ROS has w last.
CdrWriter& add_pose(CdrWriter& to, const ScenePose& pose) {
  add_vector(to, pose.position);
  for (const std::size_t i : {1U, 2U, 3U, 0U}) to.number(pose.turn[i]);
  return to;
}

CdrWriter& add_colour(CdrWriter& to, const std::array<double, 4>& colour) {
  for (const double part : colour) to.number(part);
  return to;
}

// A box or a sphere: the fields of both are the same.
struct Block {
  ScenePose pose;
  std::array<double, 3> size{};
  const SceneGeom* geom = nullptr;
};

// The primitives of the geoms of a body.
struct Primitives {
  std::vector<Block> cubes;
  std::vector<Block> spheres;
  std::vector<Block> cylinders;
  std::vector<const SceneGeom*> meshes;
};

std::array<double, 3> cross(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// A capsule is a cylinder with two spheres.
void add_round(const SceneGeom& geom, Primitives& to) {
  const double width = 2.0 * geom.size[0];
  to.cylinders.push_back({geom.pose, {width, width, 2.0 * geom.size[1]}, &geom});
  if (geom.shape == GeomShape::kCylinder) return;
  for (const double end : {-geom.size[1], geom.size[1]}) {
    ScenePose pose = geom.pose;
    pose.position = position_in_world(geom.pose, {0.0, 0.0, end});
    to.spheres.push_back({pose, {width, width, width}, &geom});
  }
}

void add_geom(const SceneGeom& geom, Primitives& to) {
  const std::array<double, 3>& size = geom.size;
  switch (geom.shape) {
    case GeomShape::kBox:
      to.cubes.push_back({geom.pose, {2.0 * size[0], 2.0 * size[1], 2.0 * size[2]}, &geom});
      break;
    case GeomShape::kEllipsoid:
      to.spheres.push_back({geom.pose, {2.0 * size[0], 2.0 * size[1], 2.0 * size[2]}, &geom});
      break;
    case GeomShape::kSphere:
      to.spheres.push_back({geom.pose, {2.0 * size[0], 2.0 * size[0], 2.0 * size[0]}, &geom});
      break;
    case GeomShape::kCapsule:
    case GeomShape::kCylinder:
      add_round(geom, to);
      break;
    case GeomShape::kMesh:
      to.meshes.push_back(&geom);
      break;
  }
}

void add_blocks(CdrWriter& to, const std::vector<Block>& blocks) {
  add_count(to, blocks.size());
  for (const Block& block : blocks) {
    add_colour(add_vector(add_pose(to, block.pose), block.size), block.geom->colour);
  }
}

void add_cylinders(CdrWriter& to, const std::vector<Block>& cylinders) {
  add_count(to, cylinders.size());
  for (const Block& cylinder : cylinders) {
    add_vector(add_pose(to, cylinder.pose), cylinder.size).number(1.0).number(1.0);
    add_colour(to, cylinder.geom->colour);
  }
}

void add_mesh(CdrWriter& to, const SceneGeom& mesh) {
  add_pose(to, mesh.pose);
  add_count(to, mesh.vertices.size() / 3);
  for (const float coordinate : mesh.vertices) to.number(static_cast<double>(coordinate));
  add_colour(to, mesh.colour);
  add_count(to, 0);
  to.numbers(std::span<const std::uint32_t>(mesh.faces));
}

void add_entity(CdrWriter& to, std::int64_t time, const std::string& frame,
                const Primitives& primitives) {
  add_time(to, time).text(frame).text(frame);
  to.number(std::int32_t{0}).number(std::uint32_t{0});  // It lives until it is replaced.
  to.number(std::uint8_t{1});                           // It follows its frame.
  add_count(to, 0);                                     // No metadata,
  add_count(to, 0);                                     // no arrows.
  add_blocks(to, primitives.cubes);
  add_blocks(to, primitives.spheres);
  add_cylinders(to, primitives.cylinders);
  add_count(to, 0);  // No lines.
  add_count(to, primitives.meshes.size());
  for (const SceneGeom* mesh : primitives.meshes) add_mesh(to, *mesh);
  add_count(to, 0);  // No texts,
  add_count(to, 0);  // no models.
}

}  // namespace

std::array<double, 3> position_in_world(const ScenePose& body,
                                        const std::array<double, 3>& position) {
  const std::array<double, 3> axis{body.turn[1], body.turn[2], body.turn[3]};
  const std::array<double, 3> once = cross(axis, position);
  const std::array<double, 3> twice = cross(axis, once);
  std::array<double, 3> turned = body.position;
  for (std::size_t i = 0; i < turned.size(); ++i) {
    turned[i] += position[i] + 2.0 * (body.turn[0] * once[i] + twice[i]);
  }
  return turned;
}

McapSchema scene_update_schema() {
  static constexpr Definition kUsed[] = {
      {"foxglove_msgs/SceneEntityDeletion",
       "uint8 MATCHING_ID=0\nuint8 ALL=1\nbuiltin_interfaces/Time timestamp\nuint8 type\n"
       "string id\n"},
      {"foxglove_msgs/SceneEntity",
       "builtin_interfaces/Time timestamp\nstring frame_id\nstring id\n"
       "builtin_interfaces/Duration lifetime\nbool frame_locked\n"
       "foxglove_msgs/KeyValuePair[] metadata\nfoxglove_msgs/ArrowPrimitive[] arrows\n"
       "foxglove_msgs/CubePrimitive[] cubes\nfoxglove_msgs/SpherePrimitive[] spheres\n"
       "foxglove_msgs/CylinderPrimitive[] cylinders\nfoxglove_msgs/LinePrimitive[] lines\n"
       "foxglove_msgs/TriangleListPrimitive[] triangles\nfoxglove_msgs/TextPrimitive[] texts\n"
       "foxglove_msgs/ModelPrimitive[] models\n"},
      {"foxglove_msgs/KeyValuePair", "string key\nstring value\n"},
      {"foxglove_msgs/ArrowPrimitive",
       "geometry_msgs/Pose pose\nfloat64 shaft_length\nfloat64 shaft_diameter\n"
       "float64 head_length\nfloat64 head_diameter\nfoxglove_msgs/Color color\n"},
      {"foxglove_msgs/CubePrimitive",
       "geometry_msgs/Pose pose\ngeometry_msgs/Vector3 size\nfoxglove_msgs/Color color\n"},
      {"foxglove_msgs/SpherePrimitive",
       "geometry_msgs/Pose pose\ngeometry_msgs/Vector3 size\nfoxglove_msgs/Color color\n"},
      {"foxglove_msgs/CylinderPrimitive",
       "geometry_msgs/Pose pose\ngeometry_msgs/Vector3 size\nfloat64 bottom_scale\n"
       "float64 top_scale\nfoxglove_msgs/Color color\n"},
      {"foxglove_msgs/LinePrimitive",
       "uint8 LINE_STRIP=0\nuint8 LINE_LOOP=1\nuint8 LINE_LIST=2\nuint8 type\n"
       "geometry_msgs/Pose pose\nfloat64 thickness\nbool scale_invariant\n"
       "geometry_msgs/Point[] points\nfoxglove_msgs/Color color\nfoxglove_msgs/Color[] colors\n"
       "uint32[] indices\n"},
      {"foxglove_msgs/TriangleListPrimitive",
       "geometry_msgs/Pose pose\ngeometry_msgs/Point[] points\nfoxglove_msgs/Color color\n"
       "foxglove_msgs/Color[] colors\nuint32[] indices\n"},
      {"foxglove_msgs/TextPrimitive",
       "geometry_msgs/Pose pose\nbool billboard\nfloat64 font_size\nbool scale_invariant\n"
       "foxglove_msgs/Color color\nstring text\n"},
      {"foxglove_msgs/ModelPrimitive",
       "geometry_msgs/Pose pose\ngeometry_msgs/Vector3 scale\nfoxglove_msgs/Color color\n"
       "bool override_color\nstring url\nstring media_type\nuint8[] data\n"},
      {"foxglove_msgs/Color", "float64 r\nfloat64 g\nfloat64 b\nfloat64 a\n"},
      {"geometry_msgs/Pose",
       "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n"},
      {"geometry_msgs/Point", kVector.fields},
      kVector,
      kQuaternion,
      kTime,
      {"builtin_interfaces/Duration", kTime.fields},
  };
  return schema_of("foxglove_msgs/msg/SceneUpdate",
                   "foxglove_msgs/SceneEntityDeletion[] deletions\n"
                   "foxglove_msgs/SceneEntity[] entities\n",
                   kUsed);
}

std::string scene_update_message(std::int64_t time, const std::vector<std::string>& bodies,
                                 std::span<const SceneGeom> geoms) {
  std::vector<Primitives> primitives(bodies.size() + 1);  // The last ones are those of the world.
  for (const SceneGeom& geom : geoms) add_geom(geom, primitives[geom.body.value_or(bodies.size())]);
  CdrWriter message;
  add_count(message, 1);
  constexpr std::uint8_t kAll = 1;
  add_time(message, time).number(kAll).text("");
  add_count(message, primitives.size());
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    add_entity(message, time, i < bodies.size() ? bodies[i] : kWorldFrame, primitives[i]);
  }
  return message.bytes();
}

McapSchema transforms_schema() {
  static constexpr Definition kUsed[] = {
      {"geometry_msgs/TransformStamped",
       "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform\n"},
      kHeader,
      {"geometry_msgs/Transform",
       "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n"},
      kVector,
      kQuaternion,
      kTime,
  };
  return schema_of("tf2_msgs/msg/TFMessage", "geometry_msgs/TransformStamped[] transforms\n",
                   kUsed);
}

std::string transforms_message(std::int64_t time, const std::vector<std::string>& bodies,
                               const std::vector<ScenePose>& poses) {
  CdrWriter message;
  add_count(message, bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    add_time(message, time).text(kWorldFrame).text(bodies[i]);
    add_pose(message, poses[i]);
  }
  return message.bytes();
}

McapSchema point_cloud_schema() {
  static constexpr Definition kUsed[] = {
      kHeader,
      {"sensor_msgs/PointField",
       "uint8 INT8=1\nuint8 UINT8=2\nuint8 INT16=3\nuint8 UINT16=4\nuint8 INT32=5\n"
       "uint8 UINT32=6\nuint8 FLOAT32=7\nuint8 FLOAT64=8\nstring name\nuint32 offset\n"
       "uint8 datatype\nuint32 count\n"},
      kTime,
  };
  return schema_of("sensor_msgs/msg/PointCloud2",
                   "std_msgs/Header header\nuint32 height\nuint32 width\n"
                   "sensor_msgs/PointField[] fields\nbool is_bigendian\nuint32 point_step\n"
                   "uint32 row_step\nuint8[] data\nbool is_dense\n",
                   kUsed);
}

std::string point_cloud_message(std::int64_t time, const std::vector<ValuedPoint>& points) {
  constexpr std::uint8_t kFloat32 = 7;
  constexpr std::uint32_t kNumber = sizeof(float);
  const std::vector<std::string> fields{"x", "y", "z", "value"};
  const auto step = static_cast<std::uint32_t>(fields.size()) * kNumber;
  const auto width = static_cast<std::uint32_t>(points.size());
  CdrWriter message;
  add_time(message, time).text(kWorldFrame).number(std::uint32_t{1}).number(width);
  add_count(message, fields.size());
  for (std::uint32_t i = 0; i < fields.size(); ++i) {
    message.text(fields[i]).number(i * kNumber).number(kFloat32).number(std::uint32_t{1});
  }
  message.number(std::uint8_t{0}).number(step).number(step * width);
  std::string data;
  data.reserve(std::size_t{step} * width);
  for (const ValuedPoint& point : points) {
    for (const double coordinate : point.position) {
      append_little_endian(data, static_cast<float>(coordinate));
    }
    append_little_endian(data, point.value);
  }
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(data.data());
  return message.numbers(std::span(bytes, data.size())).number(std::uint8_t{1}).bytes();
}

}  // namespace somato
