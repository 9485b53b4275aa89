#pragma once

namespace somato {

/// Displacement of an object from its default position before a hand. Before Hand II: along the
/// table's axes. Hand III has the object with its wider side against the palm: displaced along the
/// palm, and away from it by the magnitude of `y`. In both cases rotated about the vertical.
struct Placement {
  /// The greatest magnitude of `x` and of `y` in mm that a view accepts: the hands still touch the
  /// objects of their tables there.
  static constexpr double kFarthest = 50.0;

  double x = 0.0;     ///< mm.
  double y = 0.0;     ///< mm.
  double turn = 0.0;  ///< deg.
};

}  // namespace somato
