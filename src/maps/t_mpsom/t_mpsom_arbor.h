#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/maps/t_mpsom.h"

namespace somato {

/// The arbor A of one input of a T-MPSOM, without its zeros:
///
///     A(u, k) = exp(-(u - k I/K)^2 / (2 s^2))        zero below 1e-18, which is beyond 9.1 s
///
/// A depends only on the position u along one axis, so it is computed once per position. Neurons
/// are divided into groups, in row-major order, and a group has a mask: A of its neurons, in the
/// layout of LaneMatrix, for the elements from the first to the last in their receptive fields.
/// Groups at the same positions of the axis share a mask.
class TMpsomArbor {
 public:
  /// Number of blocks of a cache line of neurons in a group, fewer in the last one.
  static constexpr std::size_t kBlocks = 4;
  static constexpr std::size_t kNeurons = kBlocks * LaneMatrix<float>::kLanes;

  /// The receptive field of a group: elements from `first` to before `end`, with `mask`.
  struct Field {
    std::size_t first = 0;
    std::size_t end = 0;
    LaneMatrix<float> mask;
  };

  /// `parameters` must be valid and `input` one of their inputs.
  TMpsomArbor(const TMpsomParameters& parameters, std::size_t input);

  std::size_t neurons() const { return places_.size(); }
  std::size_t elements() const { return by_place_.columns(); }
  std::size_t groups() const { return field_of_.size(); }
  const Field& field(std::size_t group) const { return fields_[field_of_[group]]; }

  /// The stored masks, one for all groups that share it.
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
