#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "somato/bodies/material.h"

namespace somato::detail {

/// The surface of a material in a world: a height at every position, constant in time.
///
/// Self-affine: a sum of random heights on lattices whose spacing starts at the correlation length
/// and halves from one to the next, down to the smallest spacing that an edge can follow. Lattice j
/// has the share (1 - 4^-H) 4^(-H j) of the variance, with the Hurst exponent H; cubic B-splines
/// interpolate between its nodes. A weave is a cosine along x; the edge does not follow one whose
/// ridges and grooves are less than that spacing apart.
class Surface {
 public:
  /// `finest` (mm) is the least spacing of heights that the edge follows.
  Surface(const Material& material, double finest, std::uint64_t world_seed);

  /// um, at a place in mm. Remembers the nodes around it, so that the next place is cheap.
  double height(double x, double y);

 private:
  struct Lattice {
    double spacing = 0.0;    // mm
    double amplitude = 0.0;  // um
    std::uint32_t number = 0;
    double shift_x = 0.0;  // cells
    double shift_y = 0.0;
    std::int64_t cell_x = INT64_MIN;
    std::int64_t cell_y = INT64_MIN;
    std::array<double, 16> nodes{};  // around that cell
  };

  Lattice make_lattice(const Material& material, std::uint32_t number, double spacing) const;
  void visit(Lattice& lattice, std::int64_t cell_x, std::int64_t cell_y) const;
  double height_of(Lattice& lattice, double x, double y) const;
  double weave(double x) const;

  std::array<std::uint32_t, 2> key_;
  std::vector<Lattice> lattices_;
  double weave_period_;
  double weave_amplitude_;
  double weave_phase_;
};

}  // namespace somato::detail
