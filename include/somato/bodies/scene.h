#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/recording/recording.h"

namespace somato {

/// Where something is: metres, and a unit quaternion w, x, y, z.
struct ScenePose {
  std::array<double, 3> position{};
  std::array<double, 4> turn{1.0, 0.0, 0.0, 0.0};
};

enum class GeomShape { kBox, kSphere, kCapsule, kCylinder, kEllipsoid, kMesh };
enum class GeomRole { kHand, kObject, kTable };

template <>
struct Choices<GeomShape> {
  static const std::vector<std::pair<GeomShape, std::string>>& all();
};
template <>
struct Choices<GeomRole> {
  static const std::vector<std::pair<GeomRole, std::string>>& all();
};

/// A piece of what is drawn in three dimensions.
struct SceneGeom {
  std::optional<std::size_t> body = {};  ///< That it moves with; none: it stands still.
  std::string name = {};
  GeomShape shape = GeomShape::kBox;
  /// m: half sizes of a box and an ellipsoid; radius of a sphere; radius and half length (along z)
  /// of a capsule or cylinder.
  std::array<double, 3> size{};
  ScenePose pose = {};                               ///< Off its body.
  std::array<double, 4> colour{0.7, 0.7, 0.7, 1.0};  ///< Red, green, blue, opacity; 0 to 1.
  GeomRole role = GeomRole::kHand;
  std::optional<std::size_t> taxel = {};  ///< Element of the channel `touch`.
  std::vector<float> vertices = {};       ///< Of a mesh, three numbers each, m.
  std::vector<std::uint32_t> faces = {};  ///< Of a mesh, three vertices each.
};

/// What is drawn in three dimensions while a body explores.
struct Scene {
  std::vector<std::string> bodies;  ///< What moves, by names: a pose belongs to each.
  std::vector<SceneGeom> geoms;
  std::array<double, 3> camera{};  ///< m: where one looks from,
  std::array<double, 3> target{};  ///< and where to.
};

/// Knows the scene of an exploration that was recorded, and how it looked at each of its frames.
class ScenePlayer {
 public:
  ScenePlayer() = default;
  ScenePlayer(const ScenePlayer&) = delete;
  ScenePlayer(ScenePlayer&&) = delete;
  ScenePlayer& operator=(const ScenePlayer&) = delete;
  ScenePlayer& operator=(ScenePlayer&&) = delete;
  virtual ~ScenePlayer() = default;

  virtual const Scene& scene() const = 0;

  /// A pose for each body of the scene at a frame of the exploration, counting from 0 and among
  /// those of its channel with most frames.
  virtual std::vector<ScenePose> poses(const Exploration& exploration, std::size_t frame) = 0;
};

/// Finds the scene of an exploration; nullptr when nobody knows what it looked like.
using SceneFinder = std::function<std::unique_ptr<ScenePlayer>(const Exploration&)>;

}  // namespace somato
