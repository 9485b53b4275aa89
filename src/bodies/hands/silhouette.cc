#include "bodies/hands/silhouette.h"

#include "bodies/physics/physics.h"
#include "somato/core/check.h"

namespace somato::detail {
namespace {

constexpr std::size_t kPointsPerSide = 4;  // of a pixel

Vector3 column(const mjtNum* matrix, std::size_t number, mjtNum sign) {
  return {sign * matrix[number], sign * matrix[3 + number], sign * matrix[6 + number]};
}

}  // namespace

ParallelView view_of_camera(const mjModel& model, const mjData& data, const char* camera,
                            const Vector3& centre, double side) {
  const int number = find_in(model, mjOBJ_CAMERA, camera);
  SOMATO_ASSERT(number >= 0);
  const mjtNum* axes = row_of(data.cam_xmat, number, 9);  // a camera looks along its negative z
  return {centre, column(axes, 0, 1), column(axes, 1, 1), column(axes, 2, -1), side};
}

std::vector<double> silhouette(const mjModel& model, const mjData& data, int geom,
                               const ParallelView& view, std::size_t pixels) {
  constexpr mjtNum kAhead = 1.0;  // m, before everything that a hand explores
  const std::size_t points = pixels * kPointsPerSide;
  const mjtNum apart = view.side / static_cast<mjtNum>(points);
  const auto offset = [&](std::size_t point) {
    return (static_cast<mjtNum>(point) + 0.5) * apart - view.side / 2;
  };
  std::vector<double> covered(pixels * pixels, 0.0);
  Ray ray{{}, view.forward};
  for (std::size_t row = 0; row < points; ++row) {
    for (std::size_t column = 0; column < points; ++column) {
      for (std::size_t k = 0; k < 3; ++k) {
        ray.from[k] = view.centre[k] - kAhead * view.forward[k] + offset(column) * view.right[k] -
                      offset(row) * view.up[k];
      }
      if (distance_to_geom(model, data, geom, ray) < 0) continue;
      covered[row / kPointsPerSide * pixels + column / kPointsPerSide] +=
          1.0 / static_cast<double>(kPointsPerSide * kPointsPerSide);
    }
  }
  return covered;
}

}  // namespace somato::detail
