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

/// A position in metres, and a unit quaternion w, x, y, z.
struct ScenePose {
  std::array<double, 3> position{};
  std::array<double, 4> turn{1.0, 0.0, 0.0, 0.0};
};

/// The shape of a part of a scene.
enum class GeomShape { kBox, kSphere, kCapsule, kCylinder, kEllipsoid, kMesh };
/// The role of a part of a scene.
enum class GeomRole { kHand, kObject, kTable };

template <>
struct Choices<GeomShape> {
  static const std::vector<std::pair<GeomShape, std::string>>& all();
};
template <>
struct Choices<GeomRole> {
  static const std::vector<std::pair<GeomRole, std::string>>& all();
};

/// A shape of a three-dimensional scene.
struct SceneGeom {
  std::optional<std::size_t> body = {};  ///< The body that it moves with; empty: it is fixed.
  std::string name = {};
  GeomShape shape = GeomShape::kBox;
  /// m: half sizes of a box and an ellipsoid; radius of a sphere; radius and half length (along z)
  /// of a capsule or cylinder.
  std::array<double, 3> size{};
  ScenePose pose = {};                               ///< Relative to its body.
  std::array<double, 4> colour{0.7, 0.7, 0.7, 1.0};  ///< Red, green, blue, opacity; 0 to 1.
  GeomRole role = GeomRole::kHand;
  std::optional<std::size_t> taxel = {};  ///< Element of the channel `touch`.
  std::vector<float> vertices = {};       ///< The vertices of a mesh, three numbers each, m.
  std::vector<std::uint32_t> faces = {};  ///< The faces of a mesh, three vertices each.
};

/// The three-dimensional scene of an exploring body.
struct Scene {
  std::vector<std::string> bodies;  ///< The moving bodies, by name: each has a pose.
  std::vector<SceneGeom> geoms;
  std::array<double, 3> camera{};  ///< m: position of the camera,
  std::array<double, 3> target{};  ///< and the point it looks at.
};

/// Provides the scene of a recorded exploration, and its poses for each frame.
class ScenePlayer {
 public:
  ScenePlayer() = default;
  ScenePlayer(const ScenePlayer&) = delete;
  ScenePlayer(ScenePlayer&&) = delete;
  ScenePlayer& operator=(const ScenePlayer&) = delete;
  ScenePlayer& operator=(ScenePlayer&&) = delete;
  virtual ~ScenePlayer() = default;

  virtual const Scene& scene() const = 0;

  /// One pose for each body of the scene at a frame of the exploration, counting from 0 in the
  /// channel with most frames.
  virtual std::vector<ScenePose> poses(const Exploration& exploration, std::size_t frame) = 0;
};

/// Finds the scene of an exploration; returns nullptr if it is unknown.
using SceneFinder = std::function<std::unique_ptr<ScenePlayer>(const Exploration&)>;

}  // namespace somato
