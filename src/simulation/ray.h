#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <cstddef>

namespace somato::detail {

using Vector3 = std::array<mjtNum, 3>;

/// The numbers of the thing of that index in one of the engine's tables, `size` of them a thing.
template <class T>
T* entry(T* table, std::ptrdiff_t size, std::ptrdiff_t index) {
  return table + size * index;
}

struct Ray {
  Vector3 from{};
  Vector3 direction{};  ///< Of length 1.
};

/// Where the ray first meets the geom: metres from its start, or below 0 where it does not.
mjtNum distance_to_geom(const mjModel& model, const mjData& data, int geom, const Ray& ray);

/// The unit normal of the geom where the ray meets it at `distance`, on the side it comes from.
Vector3 normal_of_geom(const mjModel& model, const mjData& data, int geom, const Ray& ray,
                       mjtNum distance);

/// The point `distance` along the ray.
Vector3 point_on(const Ray& ray, mjtNum distance);

mjtNum dot(const Vector3& a, const Vector3& b);

/// The vector scaled to length 1.
Vector3 normalized(Vector3 vector);

}  // namespace somato::detail
