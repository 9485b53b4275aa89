#pragma once

#include <cstddef>
#include <vector>

#include "bodies/hands/ray.h"

namespace somato::detail {

/// A square image with parallel rays: `centre` is a point in its middle, and the axes are unit
/// vectors at right angles, of which `forward` leads into the picture.
struct ParallelView {
  Vector3 centre{};
  Vector3 right{};
  Vector3 up{};
  Vector3 forward{};
  double side = 0.0;  ///< m.
};

/// The view of a model's camera, with parallel rays, of a point. The model must have the camera.
ParallelView view_of_camera(const mjModel& model, const mjData& data, const char* camera,
                            const Vector3& centre, double side);

/// The silhouette of a geom: for each of `pixels` x `pixels` pixels, row by row from the top left,
/// the share of the pixel that the geom covers, from 0 to 1 in steps of 1/16. Exact for every shape
/// of the engine at the sixteen points of a pixel; nothing hides the geom.
std::vector<double> silhouette(const mjModel& model, const mjData& data, int geom,
                               const ParallelView& view, std::size_t pixels);

}  // namespace somato::detail
