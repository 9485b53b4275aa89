#pragma once

// The inner loops of the activity of a map, one implementation an instruction set: see
// base/kernels/kernels.h, whose rules hold here. Values are neuron after neuron in whole cache
// lines, `blocks` of them, and change in place. Every operation is in double precision.

#include <cstddef>

namespace somato::kernels {

struct ActivityTable {
  /// values = 1 / (1 + sqrt(values + left_out)).
  void (*similarities)(float* values, std::size_t blocks, double left_out);
  /// values = max(values, 0). Returns the largest one.
  float (*rectify)(float* values, std::size_t blocks);
  /// values = (values / largest)^exponent, by squaring. The exponent is above 0.
  void (*powers)(float* values, std::size_t blocks, double largest, unsigned exponent);
  /// The same in double precision; `terms` start on a cache line.
  void (*power_terms)(const float* values, std::size_t blocks, double largest, unsigned exponent,
                      double* terms);
  /// values /= divisor.
  void (*divide)(float* values, std::size_t blocks, double divisor);
};

/// The kernels of the instruction set in use.
const ActivityTable& activity_table();

}  // namespace somato::kernels
