#pragma once

#include <array>
#include <vector>

#include "maps/grid/principal_plane.h"
#include "somato/core/samples.h"
#include "somato/maps/grid.h"
#include "somato/maps/som.h"

namespace somato {

/// The plane of the first two principal components of a map's weights (PrincipalPlane), and the
/// places of its neurons and of samples on it. On a map with more than 4096 neurons and stored
/// elements, the components are those of 4096 neurons at equal steps of their numbers.
class WeightPlane {
 public:
  explicit WeightPlane(const Som& som);

  /// The coordinates of each neuron.
  const std::vector<Position>& neurons() const { return neurons_; }

  /// The share of the weights' variance that each axis has; 0 if there is none.
  std::array<double, 2> shares() const { return shares_; }

  /// The axes, of length 1 or 0, over the map's stored elements. The element of an axis with the
  /// greatest magnitude, the first one in a tie, is positive.
  const std::array<std::vector<double>, 2>& axes() const { return axes_; }

  /// The coordinates of samples of `som`, after normalization; elements that the map does not store
  /// have no effect. Throws InvalidArgument if the size differs from the map's input size.
  std::vector<Position> positions_of(const Som& som, const Samples& samples) const;

 private:
  Position position(const SignalView& vector) const;

  std::array<std::vector<double>, 2> axes_;
  std::array<double, 2> of_mean_{};  // coordinates of the mean
  std::array<double, 2> shares_{};
  std::vector<Position> neurons_;
};

}  // namespace somato
