#include "bodies/hands/ray.h"

#include <cmath>

namespace somato::detail {
namespace {

// From 3.17 on, the engine's rays also return the normal.
#if mjVERSION_HEADER >= 3017000
mjtNum cast(const mjModel& model, const mjData& data, int geom, const Ray& ray, mjtNum* normal) {
  const mjtNum* from = ray.from.data();
  const mjtNum* to = ray.direction.data();
  const int type = model.geom_type[geom];
  if (type == mjGEOM_MESH) return mj_rayMesh(&model, &data, geom, from, to, normal);
  if (type == mjGEOM_HFIELD) return mj_rayHfield(&model, &data, geom, from, to, normal);
  return mju_rayGeom(entry(data.geom_xpos, 3, geom), entry(data.geom_xmat, 9, geom),
                     entry(model.geom_size, 3, geom), from, to, type, normal);
}

Vector3 find_normal(const mjModel& model, const mjData& data, int geom, const Ray& ray, mjtNum) {
  Vector3 normal{};
  cast(model, data, geom, ray, normal.data());
  return normal;
}
#else
mjtNum cast(const mjModel& model, const mjData& data, int geom, const Ray& ray, mjtNum*) {
  const mjtNum* from = ray.from.data();
  const mjtNum* to = ray.direction.data();
  const int type = model.geom_type[geom];
  if (type == mjGEOM_MESH) return mj_rayMesh(&model, &data, geom, from, to);
  if (type == mjGEOM_HFIELD) return mj_rayHfield(&model, &data, geom, from, to);
  return mju_rayGeom(entry(data.geom_xpos, 3, geom), entry(data.geom_xmat, 9, geom),
                     entry(model.geom_size, 3, geom), from, to, type);
}

// From the intersection of the ray with the geom to that of a slightly displaced ray.
Vector3 tangent(const mjModel& model, const mjData& data, int geom, const Ray& ray, mjtNum distance,
                const Vector3& aside) {
  constexpr mjtNum kShift = 1e-5;
  for (const mjtNum shift : {kShift, -kShift}) {
    const Ray other{point_on({ray.from, aside}, shift), ray.direction};
    const mjtNum there = cast(model, data, geom, other, nullptr);
    if (there < 0) continue;
    Vector3 between{};
    for (std::size_t k = 0; k < 3; ++k) {
      between[k] = (shift * aside[k] + (there - distance) * ray.direction[k]) / shift;
    }
    return between;
  }
  return aside;
}

Vector3 find_normal(const mjModel& model, const mjData& data, int geom, const Ray& ray,
                    mjtNum distance) {
  const Vector3 axis = std::abs(ray.direction[0]) < 0.6 ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
  Vector3 right{};
  Vector3 up{};
  Vector3 normal{};
  mju_cross(right.data(), ray.direction.data(), axis.data());
  mju_normalize3(right.data());
  mju_cross(up.data(), right.data(), ray.direction.data());
  const Vector3 one = tangent(model, data, geom, ray, distance, right);
  const Vector3 other = tangent(model, data, geom, ray, distance, up);
  mju_cross(normal.data(), one.data(), other.data());
  return normal;
}
#endif

}  // namespace

mjtNum distance_to_geom(const mjModel& model, const mjData& data, int geom, const Ray& ray) {
  return cast(model, data, geom, ray, nullptr);
}

Vector3 normal_of_geom(const mjModel& model, const mjData& data, int geom, const Ray& ray,
                       mjtNum distance) {
  Vector3 normal = normalized(find_normal(model, data, geom, ray, distance));
  if (dot(normal, ray.direction) > 0) {
    for (mjtNum& part : normal) part = -part;
  }
  return normal;
}

Vector3 point_on(const Ray& ray, mjtNum distance) {
  return {ray.from[0] + distance * ray.direction[0], ray.from[1] + distance * ray.direction[1],
          ray.from[2] + distance * ray.direction[2]};
}

mjtNum dot(const Vector3& a, const Vector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector3 normalized(Vector3 vector) {
  mju_normalize3(vector.data());
  return vector;
}

}  // namespace somato::detail
