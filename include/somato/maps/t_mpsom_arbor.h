#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "somato/core/lane_matrix.h"
#include "somato/core/matrix.h"
#include "somato/maps/t_mpsom_parameters.h"

namespace somato {

/// The arbor A of one input of a T-MPSOM, as far as it is not zero:
///
///     A(u, k) = exp(-(u - k I/K)^2 / (2 s^2))        zero below 1e-18, which is beyond 9.1 s
///
/// A depends on the place u along one axis alone, so it is computed once a place. Neurons are taken
/// in groups, in row-major order, and a group has a mask: A of its neurons, in the order of
/// LaneMatrix, for the elements from the first to the last that any of them sees. Groups at the
/// same places of the axis share a mask.
class TMpsomArbor {
 public:
  /// Blocks of a cache line of neurons in a group, fewer in the last one.
  static constexpr std::size_t kBlocks = 4;
  static constexpr std::size_t kNeurons = kBlocks * LaneMatrix<float>::kLanes;

  /// What the neurons of a group see: elements from `first` to before `end`, by `mask`.
  struct Field {
    std::size_t first = 0;
    std::size_t end = 0;
    LaneMatrix<float> mask;
  };

  /// `parameters` must be valid and `input` one of theirs.
  TMpsomArbor(const TMpsomParameters& parameters, std::size_t input);

  std::size_t neurons() const { return places_.size(); }
  std::size_t elements() const { return by_place_.columns(); }
  std::size_t groups() const { return field_of_.size(); }
  const Field& field(std::size_t group) const { return fields_[field_of_[group]]; }

  /// The masks that are kept, one for all groups that share it.
  std::size_t masks() const { return fields_.size(); }

  /// A of every neuron and element.
  Matrix<float> to_matrix() const;

 private:
  Field make_field(std::span<const std::size_t> places) const;

  Matrix<float> by_place_;
  std::vector<std::size_t> places_;    // of each neuron along the axis
  std::vector<std::size_t> field_of_;  // each group
  std::vector<Field> fields_;
};

}  // namespace somato
