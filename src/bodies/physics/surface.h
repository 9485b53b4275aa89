#pragma once

#include <array>
#include <cmath>
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
  // A position along one axis of a lattice.
  struct Position {
    double cells = NAN;  // from the origin
    std::int64_t cell = INT64_MIN;
    std::array<double, 4> weights{};  // of the nodes around the cell
  };

  struct Lattice {
    double refinement = 1.0;  // cells in a correlation length, a power of two
    double amplitude = 0.0;   // um
    std::uint32_t number = 0;
    double shift_x = 0.0;  // cells
    double shift_y = 0.0;
    Position x;
    Position y;
    std::array<double, 16> nodes{};  // around the cell of both positions
  };

  Lattice make_lattice(const Material& material, std::uint32_t number, double refinement) const;
  void visit(Lattice& lattice, double x, double y) const;
  static bool move(Position& position, double cells);
  double height_of(Lattice& lattice, double x, double y) const;
  double weave(double x) const;

  std::array<std::uint32_t, 2> key_;
  double correlation_length_;  // mm
  std::vector<Lattice> lattices_;
  double weave_period_;
  double weave_amplitude_;
  double weave_phase_;
};

}  // namespace somato::detail
