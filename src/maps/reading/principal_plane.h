#pragma once

#include <array>
#include <vector>

#include "somato/maps/som.h"

namespace somato {

/// The plane of the first two principal components of a map's weights: the directions of the
/// greatest variance of the neurons around their mean (Pearson 1901). The element of an axis with
/// the greatest magnitude, the first one in a tie, is positive. An axis without variance is 0.
class PrincipalPlane {
 public:
  explicit PrincipalPlane(const Som& som);

  /// The coordinates of each neuron.
  const std::vector<Position>& neurons() const { return neurons_; }

  /// The share of the weights' variance that each axis has; 0 if there is none.
  std::array<double, 2> shares() const { return shares_; }

  /// The axes, of length 1 or 0, over the map's stored elements.
  const std::array<std::vector<double>, 2>& axes() const { return axes_; }

  /// The coordinates of samples of `som`, after normalization; elements that the map does not store
  /// have no effect. Throws InvalidArgument if the size differs from the map's input size.
  std::vector<Position> positions_of(const Som& som, const Samples& samples) const;

 private:
  std::vector<double> mean_;
  std::array<std::vector<double>, 2> axes_;
  std::array<double, 2> shares_{};
  std::vector<Position> neurons_;
};

}  // namespace somato
