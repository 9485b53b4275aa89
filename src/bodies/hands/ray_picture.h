#pragma once

#include <mujoco/mujoco.h>

#include <array>
#include <cstddef>
#include <span>
#include <string>

#include "bodies/hands/png.h"
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

/// A picture of the geoms from the camera, traced with the engine's rays, without graphics
/// libraries. `data` must have computed positions (mj_forward or a step). A light is above the
/// camera on its left side and casts shadows the background is white. Geoms of group 3 and above
/// and completely transparent ones are not shown; partly transparent ones are shown as opaque. Of
/// two tints for a geom the last one applies. Errors (kData): an unknown camera. Throws
/// InvalidArgument for a size that write_png does not accept, for no rays or more than 8, and for a
/// tint without a geom.
Result<Image> ray_picture(const mjModel& model, const mjData& data,
                          const RayPictureSettings& settings = {},
                          std::span<const Tint> tints = {});

}  // namespace somato::detail
