#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <cstddef>
#include <span>
#include <string>

#include "simulation/png.h"
#include "somato/core/result.h"

namespace somato::detail {

/// Red, green and blue, 0 to 1.
using Colour = std::array<float, 3>;

/// Shows a geom in a colour other than its own.
struct Tint {
  int geom = 0;
  Colour colour{};
};

struct RayPictureSettings {
  std::size_t width = 480;  ///< Pixels.
  std::size_t height = 360;
  std::size_t rays = 2;  ///< Rays each way a pixel; more make smoother edges.
  std::string camera = "view";
};

/// What the camera sees of the geoms, traced by the engine's own rays: no graphics are needed.
/// `data` must be at a state whose positions are known (mj_forward or a step). A light stands above
/// the camera's left and casts shadows; the background is white. Geoms of group 3 and above and
/// those wholly transparent are not shown; what is partly transparent is shown as if it were not.
/// Of two tints for a geom the last holds. Errors (kData): no such camera. Throws InvalidArgument
/// for a size that write_png would not take, for no rays or more than 8, and for a tint of no geom.
Result<Image> ray_picture(const mjModel& model, const mjData& data,
                          const RayPictureSettings& settings = {},
                          std::span<const Tint> tints = {});

}  // namespace somato::detail
