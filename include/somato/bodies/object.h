#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "somato/bodies/material.h"
#include "somato/core/parameter.h"

namespace somato {

enum class Shape { kSphere, kCylinder, kBlock, kCone, kEllipsoid, kCapsule, kMesh };

template <>
struct Choices<Shape> {
  static const std::vector<std::pair<Shape, std::string>>& all();
};

/// A thing to explore, standing upright on a table.
struct Object {
  std::string name;
  Shape shape = Shape::kSphere;
  /// Width (x), depth (y) and height (z) in mm: a sphere has the same three times, round things
  /// the diameter twice. A mesh takes them from its file.
  std::array<double, 3> size{};
  Material material;
  double mass = 0.0;          ///< kg; from volume and density unless given.
  double top_diameter = 0.0;  ///< mm, of a cone alone.
  std::string mesh_file;      ///< STL or OBJ, of a mesh alone; an absolute path.
  double mesh_scale = 1.0;    ///< mm for a unit of the file.
};

}  // namespace somato
