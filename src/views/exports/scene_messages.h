#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "recordings/mcap/mcap_records.h"
#include "somato/bodies/scene.h"

// Messages that show a scene in Foxglove, Rerun and RViz. Times are nanoseconds, at least 0.

namespace somato {

/// The frame of reference of what does not move.
inline constexpr const char* kWorldFrame = "world";

/// foxglove_msgs/msg/SceneUpdate, source: https://docs.foxglove.dev/docs/sdk/schemas/scene-update.
McapSchema scene_update_schema();

/// A message that replaces everything on its topic by `geoms`: an entity for each body, in the
/// body's frame of reference, which it follows. `bodies` are the names of the frames.
std::string scene_update_message(std::int64_t time, const std::vector<std::string>& bodies,
                                 std::span<const SceneGeom> geoms);

/// tf2_msgs/msg/TFMessage.
McapSchema transforms_schema();

/// The poses of the bodies in the world, one for each.
std::string transforms_message(std::int64_t time, const std::vector<std::string>& bodies,
                               const std::vector<ScenePose>& poses);

/// sensor_msgs/msg/PointCloud2.
McapSchema point_cloud_schema();

/// A point in the world and its value.
struct ValuedPoint {
  std::array<double, 3> position{};  ///< m
  float value = 0.0F;
};

/// Points with the fields `x`, `y`, `z` and `value` (float32) in the world.
std::string point_cloud_message(std::int64_t time, const std::vector<ValuedPoint>& points);

/// The position in the world of a point of a body with that pose.
std::array<double, 3> position_in_world(const ScenePose& body,
                                        const std::array<double, 3>& position);

}  // namespace somato
