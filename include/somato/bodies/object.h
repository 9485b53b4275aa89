#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "somato/bodies/material.h"
#include "somato/core/parameter.h"
#include "somato/recording/recording.h"

namespace somato {

/// The shape of an object; docs/objects.md lists the keys of each.
enum class Shape { kSphere, kCylinder, kBlock, kCone, kEllipsoid, kCapsule, kMesh };

template <>
struct Choices<Shape> {
  static const std::vector<std::pair<Shape, std::string>>& all();
};

/// An object to explore, standing upright on a table.
struct Object {
  std::string name;
  Shape shape = Shape::kSphere;
  /// Width (x), depth (y) and height (z) in mm: equal for a sphere, the diameter twice for round
  /// objects, for a capsule the height including both ends. The size of a mesh is 0 until it is
  /// read from its file.
  std::array<double, 3> size{};
  double top_diameter = 0.0;  ///< mm, only of a cone: 0 with a point, else truncated.
  Material material;
  double mass = 0.0;      ///< kg; by default computed from volume and density. For a mesh without a
                          ///< mass it is 0 until the mesh is read.
  std::string mesh_file;  ///< STL or OBJ, only of a mesh; an absolute path.
  double mesh_scale = 1.0;  ///< mm per unit of the file.

  bool operator==(const Object&) const = default;
};

/// The object's volume in mm^3. Throws InvalidArgument for a mesh, which requires its file.
double volume(const Object& object);

/// The mass in kg of `volume` mm^3 of a material.
double mass_of(const Material& material, double volume);

/// The circumference in mm of the object's widest horizontal section. A mesh is treated as the
/// ellipse with its width and depth, regardless of its outline.
double girth(const Object& object);

/// Whether it is invariant under rotation on the table: not for blocks, meshes, and round objects
/// whose width differs from their depth.
bool is_radially_symmetric(const Object& object);

/// The labels of an exploration of the object: object, shape, symmetry (radial or none, P06
/// section 2.3), girth, width and depth (mm, with one decimal), material, hardness, and trial,
/// which is written counting from 1 and passed counting from 0.
std::vector<Label> labels_of(const Object& object, std::size_t trial);

}  // namespace somato
