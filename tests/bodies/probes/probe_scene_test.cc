#include "bodies/probes/probe_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace somato::detail {
namespace {

const SceneGeom& geom_of(const Scene& scene, const std::string& name) {
  return *std::find_if(scene.geoms.begin(), scene.geoms.end(),
                       [&](const SceneGeom& geom) { return geom.name == name; });
}

// Its half size along an axis; those of both probes stand along the axes.
double half_size(const SceneGeom& geom, std::size_t axis) {
  if (geom.shape == GeomShape::kBox) return geom.size[axis];
  if (geom.shape == GeomShape::kCylinder) return geom.size[axis == 2 ? 1 : 0];
  return geom.size[0];
}
double top(const SceneGeom& geom) {
  return geom.pose.position[2] + half_size(geom, 2);
}
double bottom(const SceneGeom& geom) {
  return geom.pose.position[2] - half_size(geom, 2);
}

TEST(ProbeScene, ASlabLiesOnATable) {
  const Scene scene = probe_scene(Probe::kBoth, "wood");
  const SceneGeom& slab = geom_of(scene, "wood");
  const SceneGeom& table = geom_of(scene, "table");
  EXPECT_EQ(slab.role, GeomRole::kObject);
  EXPECT_EQ(table.role, GeomRole::kTable);
  EXPECT_EQ(top(slab), 0.0);
  EXPECT_NEAR(top(table), bottom(slab), 1e-12);
  for (const std::size_t axis : {0U, 1U}) {
    EXPECT_EQ(table.pose.position[axis], slab.pose.position[axis]);
    EXPECT_GT(half_size(table, axis), half_size(slab, axis));
  }
}

TEST(ProbeScene, TheEdgeTouchesTheSlabAtTheEndOfItsLever) {
  const Scene scene = probe_scene(Probe::kTexture, "wood");
  const SceneGeom& lever = geom_of(scene, "lever");
  const SceneGeom& edge = geom_of(scene, "edge");
  EXPECT_EQ(edge.body, lever.body);
  EXPECT_EQ(bottom(edge), 0.0);
  EXPECT_EQ(top(edge), lever.pose.position[2]);
  EXPECT_EQ(edge.pose.position[0], lever.pose.position[0] + half_size(lever, 0));
  EXPECT_EQ(edge.pose.position[1], 0.0);
  // An edge: led along the second axis, and thin across the lever's end.
  EXPECT_LT(half_size(edge, 0), half_size(edge, 1));
}

TEST(ProbeScene, TheTipEndsTheStickAndTouchesTheSlabAfterAMillimetre) {
  const Scene scene = probe_scene(Probe::kHardness, "wood");
  const SceneGeom& stick = geom_of(scene, "stick");
  const SceneGeom& tip = geom_of(scene, "tip");
  EXPECT_EQ(tip.body, stick.body);
  EXPECT_EQ(tip.shape, GeomShape::kSphere);
  for (const std::size_t axis : {0U, 1U}) {
    EXPECT_EQ(tip.pose.position[axis], stick.pose.position[axis]);
  }
  EXPECT_NEAR(bottom(stick), tip.pose.position[2], 1e-12);
  const ScenePose touching = probe_poses(Probe::kHardness, {0.0, 1.0}).at(0);
  EXPECT_NEAR(touching.position[2] + bottom(tip), 0.0, 1e-12);
}

}  // namespace
}  // namespace somato::detail
