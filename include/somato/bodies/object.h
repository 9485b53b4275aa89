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
  /// the diameter twice, a capsule its height with both ends. A mesh takes them from its file:
  /// until whoever reads it has filled them in they are 0.
  std::array<double, 3> size{};
  double top_diameter = 0.0;  ///< mm, of a cone alone: 0 with a point, else cut off.
  Material material;
  double mass = 0.0;      ///< kg; from volume and density unless given. Of a mesh that says none it
                          ///< is 0 until whoever reads the mesh has filled it in.
  std::string mesh_file;  ///< STL or OBJ, of a mesh alone; an absolute path.
  double mesh_scale = 1.0;  ///< mm for a unit of the file.
};

/// The object's volume in mm^3. Throws InvalidArgument for a mesh: only its file knows.
double volume(const Object& object);

/// The mass in kg of `volume` mm^3 of a material.
double mass_of(const Material& material, double volume);

/// The length in mm round the object's widest horizontal section. A mesh counts as the ellipse in
/// its width and depth, whatever its outline.
double girth(const Object& object);

/// Whether it looks the same however it is turned on the table: no block, no mesh, and round ones
/// whose width is their depth.
bool is_radially_symmetric(const Object& object);

/// What is known about an exploration of the object: object, shape, symmetry (radial or none, P06
/// section 2.3), girth, width and depth (mm, with one decimal), material, hardness, and trial,
/// which is written counting from 1 and given from 0.
std::vector<Label> labels_of(const Object& object, std::size_t trial);

}  // namespace somato
