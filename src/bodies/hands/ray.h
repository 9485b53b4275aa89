#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <cstddef>

namespace somato::detail {

using Vector3 = std::array<mjtNum, 3>;

/// The numbers of the element with that index in one of the engine's tables, `size` per element.
template <class T>
T* entry(T* table, std::ptrdiff_t size, std::ptrdiff_t index) {
  return table + size * index;
}

struct Ray {
  Vector3 from{};
  Vector3 direction{};  ///< The direction, of length 1.
};

/// The first intersection of the ray with the geom: metres from its start, or below 0 without an
/// intersection.
mjtNum distance_to_geom(const mjModel& model, const mjData& data, int geom, const Ray& ray);

/// The unit normal of the geom at the intersection at `distance`, on the side of the ray's origin.
Vector3 normal_of_geom(const mjModel& model, const mjData& data, int geom, const Ray& ray,
                       mjtNum distance);

/// The point `distance` along the ray.
Vector3 point_on(const Ray& ray, mjtNum distance);

mjtNum dot(const Vector3& a, const Vector3& b);

/// The vector scaled to length 1.
Vector3 normalized(Vector3 vector);

}  // namespace somato::detail
