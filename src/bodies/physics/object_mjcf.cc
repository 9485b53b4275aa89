#include "bodies/physics/object_mjcf.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>

#include "bodies/objects/material_colour.h"
#include "bodies/physics/physics.h"
#include "bodies/physics/units.h"

namespace somato::detail {
namespace {

constexpr std::array kUnknownMaterial{0.35, 0.55, 0.75};  // red, green, blue

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += letter;
    }
  }
  return safe;
}

std::string mesh_asset(const Object& object) {
  const double scale = object.mesh_scale * kMetres;
  return fmt::format(R"(<mesh name="object" file="{}" scale="{} {} {}"/>)",
                     escaped(object.mesh_file), scale, scale, scale);
}

// A regular polygon of `corners` corners round the vertical, as text of vertices.
std::string ring(double radius, double height, int corners) {
  std::string text;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    text += fmt::format("{:.9g} {:.9g} {:.9g} ", radius * std::cos(angle), radius * std::sin(angle),
                        height);
  }
  return text;
}

// The engine has no cones: a mesh with a number of sides for which the deviation is 0.1 % of the
// radius.
std::string cone_asset(const Object& object) {
  constexpr int kSides = 64;
  const double radius = object.size[0] / 2 * kMetres;
  const double top = object.top_diameter / 2 * kMetres;
  const double height = object.size[2] * kMetres;
  const std::string tip = top > 0.0 ? ring(top, height, kSides) : fmt::format("0 0 {:.9g}", height);
  return fmt::format(R"(<mesh name="object" vertex="{}{}"/>)", ring(radius, 0.0, kSides), tip);
}

struct GeomForm {
  std::string assets;
  std::string attributes;
};

GeomForm form_of(const MeasuredObject& measured) {
  const Object& object = measured.object;
  const double x = object.size[0] / 2 * kMetres;
  const double y = object.size[1] / 2 * kMetres;
  const double z = object.size[2] / 2 * kMetres;
  const auto sized = [&](const char* type, const std::string& size) {
    return GeomForm{"", fmt::format(R"(type="{}" size="{}" pos="0 0 {}")", type, size, z)};
  };
  switch (object.shape) {
    case Shape::kSphere:
      return sized("sphere", fmt::format("{}", x));
    case Shape::kCylinder:
      return sized("cylinder", fmt::format("{} {}", x, z));
    case Shape::kBlock:
      return sized("box", fmt::format("{} {} {}", x, y, z));
    case Shape::kEllipsoid:
      return sized("ellipsoid", fmt::format("{} {} {}", x, y, z));
    case Shape::kCapsule:
      return sized("capsule", fmt::format("{} {}", x, z - x));
    case Shape::kCone:
      return {cone_asset(object), R"(type="mesh" mesh="object")"};
    case Shape::kMesh:
      break;
  }
  const auto& origin = measured.mesh_origin;
  return {mesh_asset(object), fmt::format(R"(type="mesh" mesh="object" pos="{} {} {}")", -origin[0],
                                          -origin[1], -origin[2])};
}

std::string mass_of(const Object& object) {
  return object.mass > 0.0 ? fmt::format(R"(mass="{}")", object.mass)
                           : fmt::format(R"(density="{}")", object.material.density);
}

bool is_round_below(Shape shape) {
  return shape == Shape::kSphere || shape == Shape::kEllipsoid || shape == Shape::kCapsule;
}

// Three beads in a ring hold a free round object in place, like a sphere on a test stand.
std::string beads(const Object& object) {
  const double radius = std::min(object.size[0], object.size[1]) / 2 * kMetres;
  std::string text = R"(<body name="stand" mocap="true">)";
  for (int i = 0; i < 3; ++i) {
    const double angle = 2 * std::numbers::pi * i / 3;
    text += fmt::format(
        R"(<geom type="sphere" size="{}" pos="{} {} {}" contype="4" conaffinity="2")"
        R"( rgba="0.5 0.5 0.5 1"/>)",
        radius / 9, 0.55 * radius * std::cos(angle), 0.55 * radius * std::sin(angle), radius / 9);
  }
  return text + "</body>";
}

struct Box {
  std::array<double, 3> least;
  std::array<double, 3> most;
};

// The bounding box of the first geom, a mesh, in the frame it was given in.
Box bounding_box(const mjModel& model) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Box box{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};
  std::array<mjtNum, 9> rotation{};
  mju_quat2Mat(rotation.data(), model.geom_quat);
  for (int vertex = 0; vertex < static_cast<int>(model.nmeshvert); ++vertex) {
    std::array<mjtNum, 3> local{};
    mju_f2n(local.data(), row_of(model.mesh_vert, vertex, 3), 3);
    std::array<mjtNum, 3> point{};
    mju_mulMatVec(point.data(), rotation.data(), local.data(), 3, 3);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      point[axis] += model.geom_pos[axis];
      box.least[axis] = std::min(box.least[axis], point[axis]);
      box.most[axis] = std::max(box.most[axis], point[axis]);
    }
  }
  return box;
}

Result<MeasuredObject> measured_by(Object object, const Box& box) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    object.size[axis] = (box.most[axis] - box.least[axis]) / kMetres;
    if (object.size[axis] > 0.1 && object.size[axis] <= 1000.0) continue;
    return fail(ErrorKind::kUsage,
                fmt::format("the mesh of '{}' measures {:.4g} mm along one axis", object.name,
                            object.size[axis]),
                object.mesh_file, "set 'scale', the mm per unit of the file");
  }
  return MeasuredObject{
      std::move(object),
      {(box.least[0] + box.most[0]) / 2, (box.least[1] + box.most[1]) / 2, box.least[2]}};
}

}  // namespace

Result<MeasuredObject> measure_object(Object object) {
  if (object.shape != Shape::kMesh) return MeasuredObject{std::move(object), {}};
  const std::string mjcf = fmt::format(
      R"(<mujoco><asset>{}</asset><worldbody><geom type="mesh" mesh="object"/></worldbody></mujoco>)",
      mesh_asset(object));
  SOMATO_TRY(const auto model, compile_model(mjcf, object.mesh_file));
  return measured_by(std::move(object), bounding_box(*model));
}

ObjectMjcf object_mjcf(const MeasuredObject& measured, const ObjectSettings& settings) {
  const Object& object = measured.object;
  const GeomForm form = form_of(measured);
  const auto [red, green, blue] = material_colour(object.material.name).value_or(kUnknownMaterial);
  ObjectMjcf mjcf;
  mjcf.assets = form.assets;
  mjcf.bodies = fmt::format(
      R"(<body name="object"{}>{}<geom name="object" {} {} contype="2" conaffinity="5" priority="1")"
      R"( friction="{} 0.001 0.0001" condim="4")"
      R"( rgba="{} {} {} 1"/></body>)",
      settings.free ? "" : R"( mocap="true")", settings.free ? "<freejoint/>" : "", form.attributes,
      mass_of(object), settings.friction, red, green, blue);
  if (settings.free && is_round_below(object.shape)) mjcf.bodies += beads(object);
  return mjcf;
}

}  // namespace somato::detail
