#pragma once

// Inner loops of training by inner products (maps/products/product_state.h), one implementation an
// instruction set. Everything is in double precision; kRowLanes rows (neurons) stand side by side.
// A sum runs over its terms one after the other in ascending order, so that it is the same bits for
// every instruction set, and whether zeros are left out or not.

#include <cstddef>
#include <cstdint>

namespace somato::kernels {

/// Rows that are treated together.
inline constexpr std::size_t kRowLanes = 16;

/// Places in numbers at random: sixteen rows of a stream, see uniform_at().
struct RandomRows {
  std::uint32_t key[2];
  std::uint32_t stream;
  std::uint32_t first_row;
};

/// Values of samples, element by element: element e has values[k] of sample samples[k] for k from
/// begins[e] to ends[e].
struct ListedValues {
  const std::uint32_t* begins;
  const std::uint32_t* ends;
  const std::uint32_t* samples;
  const float* values;
};

/// A map as training by products knows it; each pointer to a value for each neuron, `padded` many
/// (a multiple of kRowLanes), on a cache line. With `samples` rows of coefficients.
struct ProductMap {
  std::size_t padded;
  std::size_t samples;
  double* of_start;         ///< Share of the initial weights in the weights.
  double* factors;          ///< The factors by which the coefficients are multiplied.
  double* squared_lengths;  ///< The squared lengths of the weights.
  double* coefficients;     ///< Samples x padded.
};

struct ProductTable {
  /// The numbers of uniform_at() in columns 4 quarter .. 4 quarter + 3 for each of `quarters`: a
  /// line of kRowLanes floats a column.
  void (*uniform_rows)(RandomRows rows, const std::uint32_t* quarters, std::size_t count,
                       float* out);
  /// The same of row rows.first_row and `count` quarters from first_quarter on: 4 floats a quarter.
  void (*uniform_row)(RandomRows rows, std::uint32_t first_quarter, std::size_t count, float* out);
  /// out[e] = low[e] + span[e] * uniform[places[e]] in single precision, lines of kRowLanes;
  /// squares += out^2.
  void (*initial_weights)(const float* uniform, const std::uint32_t* places, const float* low,
                          const float* span, std::size_t elements, double* out, double* squares);
  /// products[s] += sum over e of w[e] * x[e * samples + s]: lines of kRowLanes, those of
  /// neighbouring samples `stride` apart.
  void (*add_products)(const double* w, const double* x, std::size_t elements, std::size_t samples,
                       double* products, std::size_t stride);
  /// The same of values in lists: sample s has x[k] of element elements[k] for k from starts[s] to
  /// starts[s + 1].
  void (*add_listed_products)(const double* w, const std::uint32_t* starts,
                              const std::uint32_t* elements, const float* x, std::size_t samples,
                              double* products, std::size_t stride);
  /// out[places[e]] = of_start * w[e] + sum over s of coefficients[s] * x[e * samples + s]: lines
  /// of kRowLanes.
  void (*form_weights)(const double* w, const double* of_start, const double* x,
                       const double* coefficients, std::size_t elements, std::size_t samples,
                       const std::uint32_t* places, float* out);
  /// The same for values in lists.
  void (*form_listed_weights)(const double* w, const double* of_start, ListedValues x,
                              const double* coefficients, std::size_t elements,
                              const std::uint32_t* places, float* out);
  /// The weights' products with a sample, from its products with the initial weights and with the
  /// samples.
  void (*products_with)(const ProductMap& map, const double* of_initial, const double* of_samples,
                        double* out);
  /// The first number of the least of offsets - scale * products; `count` >= 1 of them.
  std::size_t (*least)(const double* offsets, const double* products, double scale,
                       std::size_t count, double* scores);
  /// Moves each neuron by its gain towards the sample, whose squared length and products with the
  /// weights are given; to length 1 when `normalize`.
  void (*move)(const ProductMap& map, std::size_t sample, double squared_length,
               const double* products, const double* gains, bool normalize);
  /// values = exponential(value), for values up to 0; 0 below -700.
  void (*exponentials)(double* values, std::size_t count);
};

/// The kernels of the instruction set in use.
const ProductTable& product_table();

}  // namespace somato::kernels
