#include "simulation/probe_scene.h"

#include <array>
#include <string>
#include <utility>

#include "simulation/units.h"
#include "somato/core/elementary.h"

namespace somato::detail {
namespace {

constexpr double kScale = 2.0;
constexpr double kLever = 0.040 * kScale;  // m; from its axis to its edge
constexpr double kSlab = 0.006;            // m; half as thick
constexpr std::array<double, 4> kMetal{0.62, 0.65, 0.70, 1.0};
constexpr std::array<double, 4> kDark{0.20, 0.21, 0.24, 1.0};

// Something like what they look like; an unknown one is grey.
std::array<double, 4> colour_of(const Material& material) {
  static const std::array<std::pair<const char*, std::array<double, 4>>, 8> known{{
      {"rubber", {0.28, 0.28, 0.30, 1.0}},
      {"wood", {0.76, 0.58, 0.38, 1.0}},
      {"metal", {0.66, 0.68, 0.72, 1.0}},
      {"felt", {0.40, 0.50, 0.42, 1.0}},
      {"hard_board", {0.52, 0.38, 0.26, 1.0}},
      {"corduroy", {0.45, 0.36, 0.52, 1.0}},
      {"plastic", {0.27, 0.48, 0.70, 1.0}},
      {"sponge", {0.92, 0.82, 0.45, 1.0}},
  }};
  for (const auto& [name, colour] : known) {
    if (material.name == name) return colour;
  }
  return {0.6, 0.6, 0.6, 1.0};
}

SceneGeom box(std::string name, std::array<double, 3> half_sizes, std::array<double, 3> position,
              const std::array<double, 4>& colour) {
  SceneGeom geom;
  geom.name = std::move(name);
  geom.size = half_sizes;
  geom.pose.position = position;
  geom.colour = colour;
  return geom;
}

SceneGeom cylinder(std::string name, double radius, double half_length,
                   std::array<double, 3> position, const std::array<double, 4>& colour) {
  SceneGeom geom = box(std::move(name), {radius, half_length, 0.0}, position, colour);
  geom.shape = GeomShape::kCylinder;
  return geom;
}

// Table and slab, whose top is at height 0.
Scene bench(const Material& material) {
  Scene scene;
  SceneGeom slab = box(material.name, {0.09, 0.09, kSlab}, {0.0, 0.0, -kSlab}, colour_of(material));
  slab.role = GeomRole::kObject;
  scene.geoms.push_back(slab);
  SceneGeom table =
      box("table", {0.3, 0.3, 0.01}, {0.0, 0.0, -2 * kSlab - 0.01}, {0.9, 0.9, 0.88, 1.0});
  table.role = GeomRole::kTable;
  scene.geoms.push_back(table);
  scene.camera = {0.22, -0.30, 0.24};
  scene.target = {0.0, 0.0, 0.03};
  return scene;
}

void add_moving(Scene& scene, std::vector<SceneGeom> geoms) {
  for (SceneGeom& geom : geoms) {
    geom.body = 0;
    scene.geoms.push_back(std::move(geom));
  }
}

}  // namespace

Scene texture_probe_scene(const Material& material) {
  Scene scene = bench(material);
  scene.bodies = {"lever"};
  scene.geoms.push_back(cylinder("servo", 0.014, 0.022, {-kLever, 0.0, 0.062}, kDark));
  add_moving(scene, {box("lever", {kLever / 2, 0.005, 0.003}, {kLever / 2, 0.0, 0.036}, kMetal),
                     box("edge", {0.002, 0.007, 0.018}, {kLever, 0.0, 0.018}, kMetal),
                     cylinder("hub", 0.009, 0.006, {0.0, 0.0, 0.036}, kDark)});
  return scene;
}

Scene hardness_probe_scene(const Material& material) {
  Scene scene = bench(material);
  scene.bodies = {"stick"};
  scene.geoms.push_back(box("servo", {0.022, 0.016, 0.022}, {0.0, 0.0, 0.085}, kDark));
  SceneGeom tip;
  tip.name = "tip";
  tip.shape = GeomShape::kSphere;
  tip.size = {0.006, 0.0, 0.0};
  tip.pose.position = {0.0, 0.0, 0.006};
  tip.colour = kMetal;
  add_moving(scene, {cylinder("stick", 0.005, 0.035, {0.0, 0.0, 0.041}, kMetal), std::move(tip)});
  return scene;
}

// The lever turns about the vertical, half of its stroke to either side.
std::vector<ScenePose> texture_probe_poses(double degrees) {
  const double half = (degrees - 18.0) / 720.0;  // turns
  ScenePose pose;
  pose.position = {-kLever, 0.0, 0.0};
  pose.turn = {cosine_of_turns(half), 0.0, 0.0, cosine_of_turns(half - 0.25)};
  return {pose};
}

// At 0 the tip is a millimetre above the material.
std::vector<ScenePose> hardness_probe_poses(double millimetres) {
  ScenePose pose;
  pose.position = {0.0, 0.0, (1.0 - millimetres) * kMetres * kScale};
  return {pose};
}

}  // namespace somato::detail
