#pragma once

namespace somato {

/// How an object stands off its place before a hand. Before Hand II: along the table's axes. Hand
/// III has it with its wider side against the palm: shifted along it, and away by the size of `y`.
/// Either way turned about the vertical.
struct Placement {
  double x = 0.0;     ///< mm.
  double y = 0.0;     ///< mm.
  double turn = 0.0;  ///< deg.
};

}  // namespace somato
