#include "bodies/hands/object_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bodies/physics/units.h"

namespace somato::detail {
namespace {

constexpr double kGap = 0.0002;  // m, so that nothing overlaps

bool is_free(const HandScene::Impl& scene) {
  return scene.parameters.free;
}

void put_mocap(const mjModel& model, int body, const Pose& pose, mjData& data) {
  const int mocap = model.body_mocapid[body];
  std::copy(pose.position.begin(), pose.position.end(), row_of(data.mocap_pos, mocap, 3));
  std::copy(pose.turn.begin(), pose.turn.end(), row_of(data.mocap_quat, mocap, 4));
}

// Above the beads of a stand by less than their thickness, so that it settles between them.
double drop_of(const HandScene::Impl& scene) {
  const double radius = std::min(scene.object.size[0], scene.object.size[1]) / 2 * kMetres;
  return scene.stand_body < 0 ? 0.0 : radius / 9;
}

void put_free(const HandScene::Impl& scene, const Pose& pose, mjData& data) {
  const mjModel& model = *scene.model;
  mjtNum* at = data.qpos + model.jnt_qposadr[model.body_jntadr[scene.object_body]];
  std::copy(pose.position.begin(), pose.position.end(), at);
  at[2] += drop_of(scene);
  std::copy(pose.turn.begin(), pose.turn.end(), at + 3);
}

// The half extent of the outline of an object, rotated by `turn`, along y.
double half_extent(const Object& object, double turn) {
  const double x = object.size[0] / 2 * kMetres * std::abs(std::sin(turn));
  const double y = object.size[1] / 2 * kMetres * std::abs(std::cos(turn));
  const bool has_corners = object.shape == Shape::kBlock || object.shape == Shape::kMesh;
  return has_corners ? x + y : std::hypot(x, y);
}

Error lost(const HandScene::Impl& scene, const std::string& how) {
  return {ErrorKind::kData, fmt::format("the object {}", how), scene.object.name,
          "keep it fixed, or give it another mass"};
}

}  // namespace

Pose object_pose(const HandScene::Impl& scene, const Placement& placement) {
  const mjModel& model = *scene.model;
  const mjtNum* site = row_of(model.site_pos, scene.place, 3);
  const double turn = placement.turn * kRadians + (scene.turn_to_palm ? std::numbers::pi / 2 : 0.0);
  const double y = placement.y * kMetres;
  const std::array<mjtNum, 3> off{
      placement.x * kMetres,
      scene.at_palm ? std::abs(y) + half_extent(scene.object, turn) + kGap : y, 0.0};
  Pose pose;
  mju_rotVecQuat(pose.position.data(), off.data(), row_of(model.site_quat, scene.place, 4));
  mju_addTo3(pose.position.data(), site);
  const std::array<mjtNum, 4> about{std::cos(turn / 2), 0.0, 0.0, std::sin(turn / 2)};
  mju_mulQuat(pose.turn.data(), row_of(model.site_quat, scene.place, 4), about.data());
  return pose;
}

void put_object(const HandScene::Impl& scene, const Pose& pose, mjData& data) {
  if (scene.stand_body >= 0) put_mocap(*scene.model, scene.stand_body, pose, data);
  if (is_free(scene)) {
    put_free(scene, pose, data);
  } else {
    put_mocap(*scene.model, scene.object_body, pose, data);
  }
}

Result<void> check_object(const HandScene::Impl& scene, const Pose& placed, const mjData& data) {
  if (!is_free(scene)) return {};
  constexpr double kFarthest = 0.06;  // m; a free block drifts by a tenth of this
  constexpr double kDeepest = 0.005;  // m
  const mjtNum* now = row_of(data.xpos, scene.object_body, 3);
  const double height = now[2] - placed.position[2];
  if (height < -kDeepest) return fail(lost(scene, "sank into the table"));
  if (std::hypot(now[0] - placed.position[0], now[1] - placed.position[1], height) > kFarthest)
    return fail(lost(scene, "flew away"));
  // The third column of its rotation: where its own vertical points.
  if (row_of(data.xmat, scene.object_body, 9)[8] < std::numbers::sqrt2 / 2)
    return fail(lost(scene, "fell over"));
  return {};
}

Result<void> check_apart(const HandScene::Impl& scene, const mjData& data) {
  for (int i = 0; i < data.ncon; ++i) {
    const auto [one, other] = contact_geoms(data.contact[i]);
    if (one != scene.object_geom && other != scene.object_geom) continue;
    const int geom = one == scene.object_geom ? other : one;
    const int body = scene.model->geom_bodyid[geom];
    const bool of_hand = body != 0 && body != scene.stand_body;
    if (!of_hand || data.contact[i].dist > 0.0) continue;
    return fail(ErrorKind::kUsage,
                fmt::format("'{}' does not fit the hand: '{}' touches it before the hand closes",
                            scene.object.name, mj_id2name(scene.model.get(), mjOBJ_BODY, body)),
                scene.object.name, "use a smaller object, or less placement noise");
  }
  return {};
}

}  // namespace somato::detail
