#pragma once

// The inner loops of a T-MPSOM, one implementation an instruction set: see base/kernels/kernels.h,
// whose rules hold here. Lanes run over neurons, blocks of a cache line of them at a time.

#include <cstddef>
#include <cstdint>

#include "base/kernels/kernels.h"

namespace somato::kernels {

/// The update of each neuron's weights: w <- keep w + add x. Values of a lane each.
struct Moves {
  float* keep;
  float* add;
  float* doubtful;  ///< Not zero where single precision does not know the length of what is moved.
};

/// The result of reading the weights once, for each neuron: values of a lane each.
struct Measures {
  float* partial;   ///< The sum of (mask * w) * x.
  float* products;  ///< w x.
  float* squares;   ///< w w.
};

/// The next input: elements of which some are in the mask, which begins at column `first`.
struct ReceptiveInput {
  Lanes<const float> mask;
  std::size_t first;
  const float* x;
  bool is_zero;  ///< Whether all of x is.
};

struct TMpsomTable {
  /// out = sum over the listed columns of (mask * w) * x; `mask` begins at column `first` of w.
  void (*banded_inner_products)(Lanes<const float> w, Lanes<const float> mask, std::size_t first,
                                const std::uint32_t* columns, const float* x, std::size_t count,
                                float* out);
  /// Finds the moves by `gains` that leave each row of w with unit length:
  ///
  ///     keep = (1 - gain) / length      add = gain / length
  ///     length^2 = (1 - gain)^2 |w|^2 + 2 gain (1 - gain) w x + gain^2 |x|^2
  ///
  /// from sums over one reading of w. Returns whether no lane is doubtful.
  bool (*find_unit_moves)(Lanes<const float> w, const float* x, float squared_length_of_x,
                          const float* gains, const Moves& moves);
  /// The same from sums that have been found before.
  bool (*find_measured_moves)(const Measures& measures, std::size_t blocks,
                              float squared_length_of_x, const float* gains, const Moves& moves);
  /// Moves w by `moves` towards `sample`, as move() does, or leaves it as it is when `sample` is
  /// nullptr, and measures it as it is then, in one pass. The same bits as those of the others, for
  /// up to kChunk columns.
  void (*move_and_measure)(Lanes<float> w, const float* sample, const Moves& moves,
                           const ReceptiveInput& input, const Measures& measures);
  /// keep = 1 - gain, add = gain.
  void (*find_plain_moves)(const float* gains, std::size_t blocks, const Moves& moves);
  /// w = keep w + add x, zero where its magnitude is below kNegligible.
  void (*move)(Lanes<float> w, const float* x, const Moves& moves);
  /// Whether any of so many blocks of values is not zero.
  bool (*any)(const float* values, std::size_t blocks);
  /// y = p, y *= p, y += p, one value a neuron.
  void (*start_activity)(const float* p, std::size_t count, double* y);
  void (*multiply_activity)(const float* p, std::size_t count, double* y);
  void (*add_activity)(const float* p, std::size_t count, double* y);
  /// out = max(y, 0). Returns whether all y are finite.
  bool (*rectify)(const double* y, std::size_t count, double* out);
  /// The greatest of values not below zero; 0 of none.
  double (*largest)(const double* values, std::size_t count);
  /// values /= maximum; gains = alpha * values, zero below kNegligible. Values and alpha are not
  /// below zero; gains start on a cache line.
  void (*find_gains)(double* values, std::size_t count, double maximum, double alpha, float* gains);
  /// Spreads `places` rows of `width` values each to their neighbours: out(u) = sum over v with
  /// |u - v| <= reach, in ascending order, of factors[v - u] * in(v). `factors` points to the
  /// middle of its values and has them up to reach + kSpreadGroup on both sides, zeros beyond
  /// reach.
  void (*spread_rows)(const double* in, std::size_t places, std::size_t width,
                      const double* factors, std::size_t reach, double* out);
  /// The same of a line of single values that has `reach` zeros before it and after it.
  void (*spread_line)(const double* in, std::size_t places, const double* factors,
                      std::size_t reach, double* out);
};

/// The kernels of the instruction set in use.
const TMpsomTable& t_mpsom_table();

}  // namespace somato::kernels
