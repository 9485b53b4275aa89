#include "bodies/probes/probe_scene.h"

#include <array>
#include <utility>

#include "base/core/elementary.h"
#include "bodies/objects/material_colour.h"
#include "bodies/physics/units.h"

namespace somato::detail {
namespace {

constexpr double kScale = 2.0;
constexpr double kLever = 0.040 * kScale;  // m; from its axis to its edge
constexpr double kBeside = 0.055;          // m; from the edge to the adjacent stick
constexpr double kSlab = 0.010;            // m; half as thick, so that no stick comes through
constexpr std::array<double, 4> kMetal{0.62, 0.65, 0.70, 1.0};
constexpr std::array<double, 4> kDark{0.20, 0.21, 0.24, 1.0};

// An unknown one is grey.
std::array<double, 4> colour_of(const std::string& material) {
  const auto [red, green, blue] = material_colour(material).value_or(std::array{0.6, 0.6, 0.6});
  return {red, green, blue, 1.0};
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
Scene bench(const std::string& material) {
  Scene scene;
  SceneGeom slab = box(material, {0.09, 0.09, kSlab}, {0.0, 0.0, -kSlab}, colour_of(material));
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

// Geoms of a separate body.
void add_moving(Scene& scene, const char* name, std::vector<SceneGeom> geoms) {
  for (SceneGeom& geom : geoms) {
    geom.body = scene.bodies.size();
    scene.geoms.push_back(std::move(geom));
  }
  scene.bodies.emplace_back(name);
}

void add_lever(Scene& scene) {
  scene.geoms.push_back(cylinder("servo", 0.014, 0.022, {-kLever, 0.0, 0.062}, kDark));
  add_moving(scene, "lever",
             {box("lever", {kLever / 2, 0.005, 0.003}, {kLever / 2, 0.0, 0.036}, kMetal),
              box("edge", {0.002, 0.007, 0.018}, {kLever, 0.0, 0.018}, kMetal),
              cylinder("hub", 0.009, 0.006, {0.0, 0.0, 0.036}, kDark)});
}

void add_stick(Scene& scene, double along) {
  scene.geoms.push_back(box("servo", {0.022, 0.016, 0.022}, {along, 0.0, 0.085}, kDark));
  SceneGeom tip;
  tip.name = "tip";
  tip.shape = GeomShape::kSphere;
  tip.size = {0.006, 0.0, 0.0};
  tip.pose.position = {0.0, 0.0, 0.006};
  tip.colour = kMetal;
  add_moving(scene, "stick",
             {cylinder("stick", 0.005, 0.035, {0.0, 0.0, 0.041}, kMetal), std::move(tip)});
}

// The position of the stick along the slab: next to the lever if there is one.
double stick_along(Probe probe) {
  return probe == Probe::kBoth ? kBeside : 0.0;
}

// The lever turns about the vertical, half of its stroke to either side.
ScenePose lever_pose(double degrees) {
  const double half = (degrees - 18.0) / 720.0;  // turns
  ScenePose pose;
  pose.position = {-kLever, 0.0, 0.0};
  pose.turn = {cosine_of_turns(half), 0.0, 0.0, cosine_of_turns(half - 0.25)};
  return pose;
}

// At 0 the tip is a millimetre above the material.
ScenePose stick_pose(double along, double millimetres) {
  ScenePose pose;
  pose.position = {along, 0.0, (1.0 - millimetres) * kMetres * kScale};
  return pose;
}

}  // namespace

Scene probe_scene(Probe probe, const std::string& material) {
  Scene scene = bench(material);
  if (probe != Probe::kHardness) add_lever(scene);
  if (probe != Probe::kTexture) add_stick(scene, stick_along(probe));
  return scene;
}

std::vector<ScenePose> probe_poses(Probe probe, const ProbePlace& place) {
  std::vector<ScenePose> poses;
  if (probe != Probe::kHardness) poses.push_back(lever_pose(place.lever));
  if (probe != Probe::kTexture) poses.push_back(stick_pose(stick_along(probe), place.stick));
  return poses;
}

}  // namespace somato::detail
