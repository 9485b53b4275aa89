// The kernels of training by inner products, written once. Each kernels_*.cc includes this file
// after kernels_body.h.

#include <cstddef>
#include <cstdint>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "base/kernels/kernels.h"
#include "base/kernels/product_kernels.h"

namespace somato::kernels::SOMATO_KERNELS {
namespace {

// Each stands on those before.
#include "base/kernels/vector.h"  // NOLINT(bugprone-suspicious-include): meant to be inside the namespace

#include "base/kernels/product_vector.h"  // NOLINT(bugprone-suspicious-include): as above

#include "base/kernels/product_random.h"  // NOLINT(bugprone-suspicious-include): as above

void initial_weights(const float* uniform, const std::uint32_t* places, const float* low,
                     const float* span, std::size_t elements, double* out, double* squares) {
  auto low_squares = Vector<double>::load(squares);
  auto high_squares = Vector<double>::load(squares + kWidth);
  for (std::size_t e = 0; e < elements; ++e) {
    const auto number = Vector<float>::load(uniform + places[e] * kRowLanes);
    const auto weights = Vector<float>::all(low[e]) + Vector<float>::all(span[e]) * number;
    const auto first = lower_half(weights);
    const auto second = upper_half(weights);
    first.store(out + e * kRowLanes);
    second.store(out + e * kRowLanes + kWidth);
    low_squares = multiply_add(first, first, low_squares);
    high_squares = multiply_add(second, second, high_squares);
  }
  low_squares.store(squares);
  high_squares.store(squares + kWidth);
}

// For Count samples at once, as many as registers hold.
template <std::size_t Count>
inline void add_products_of(const double* w, const double* x, std::size_t elements,
                            std::size_t samples, double* products, std::size_t stride) {
  Vector<double> low[Count];
  Vector<double> high[Count];
#pragma GCC unroll 12
  for (std::size_t s = 0; s < Count; ++s) {
    low[s] = Vector<double>::load(products + s * stride);
    high[s] = Vector<double>::load(products + s * stride + kWidth);
  }
  for (std::size_t e = 0; e < elements; ++e) {
    const auto first = Vector<double>::load(w + e * kRowLanes);
    const auto second = Vector<double>::load(w + e * kRowLanes + kWidth);
#pragma GCC unroll 12
    for (std::size_t s = 0; s < Count; ++s) {
      const auto value = Vector<double>::all(x[e * samples + s]);
      low[s] = multiply_add(first, value, low[s]);
      high[s] = multiply_add(second, value, high[s]);
    }
  }
#pragma GCC unroll 12
  for (std::size_t s = 0; s < Count; ++s) {
    low[s].store(products + s * stride);
    high[s].store(products + s * stride + kWidth);
  }
}

#if defined(__AVX512F__)
constexpr std::size_t kTogether = 12;
#else
constexpr std::size_t kTogether = 2;
#endif

void add_products(const double* w, const double* x, std::size_t elements, std::size_t samples,
                  double* products, std::size_t stride) {
  std::size_t s = 0;
  for (; s + kTogether <= samples; s += kTogether) {
    add_products_of<kTogether>(w, x + s, elements, samples, products + s * stride, stride);
  }
  for (; s + 4 <= samples; s += 4) {
    add_products_of<4>(w, x + s, elements, samples, products + s * stride, stride);
  }
  for (; s < samples; ++s) {
    add_products_of<1>(w, x + s, elements, samples, products + s * stride, stride);
  }
}

void add_listed_products(const double* w, const std::uint32_t* starts,
                         const std::uint32_t* elements, const float* x, std::size_t samples,
                         double* products, std::size_t stride) {
  for (std::size_t s = 0; s < samples; ++s) {
    if (starts[s] == starts[s + 1]) continue;
    auto low = Vector<double>::load(products + s * stride);
    auto high = Vector<double>::load(products + s * stride + kWidth);
    for (std::uint32_t k = starts[s]; k < starts[s + 1]; ++k) {
      const auto value = Vector<double>::all(static_cast<double>(x[k]));
      const double* line = w + elements[k] * kRowLanes;
      low = multiply_add(Vector<double>::load(line), value, low);
      high = multiply_add(Vector<double>::load(line + kWidth), value, high);
    }
    low.store(products + s * stride);
    high.store(products + s * stride + kWidth);
  }
}

// Count neighbouring elements at once.
template <std::size_t Count>
inline void form_weights_of(const double* w, const double* of_start, const double* x,
                            const double* coefficients, std::size_t samples,
                            const std::uint32_t* places, float* out) {
  Vector<double> low[Count];
  Vector<double> high[Count];
#pragma GCC unroll 12
  for (std::size_t e = 0; e < Count; ++e) {
    low[e] = Vector<double>::load(of_start) * Vector<double>::load(w + e * kRowLanes);
    high[e] =
        Vector<double>::load(of_start + kWidth) * Vector<double>::load(w + e * kRowLanes + kWidth);
  }
  for (std::size_t s = 0; s < samples; ++s) {
    const auto first = Vector<double>::load(coefficients + s * kRowLanes);
    const auto second = Vector<double>::load(coefficients + s * kRowLanes + kWidth);
#pragma GCC unroll 12
    for (std::size_t e = 0; e < Count; ++e) {
      const auto value = Vector<double>::all(x[e * samples + s]);
      low[e] = multiply_add(first, value, low[e]);
      high[e] = multiply_add(second, value, high[e]);
    }
  }
#pragma GCC unroll 12
  for (std::size_t e = 0; e < Count; ++e) {
    store_halves(low[e], high[e], out + places[e] * kRowLanes);
  }
}

void form_weights(const double* w, const double* of_start, const double* x,
                  const double* coefficients, std::size_t elements, std::size_t samples,
                  const std::uint32_t* places, float* out) {
  std::size_t e = 0;
  for (; e + kTogether <= elements; e += kTogether) {
    form_weights_of<kTogether>(w + e * kRowLanes, of_start, x + e * samples, coefficients, samples,
                               places + e, out);
  }
  for (; e < elements; ++e) {
    form_weights_of<1>(w + e * kRowLanes, of_start, x + e * samples, coefficients, samples,
                       places + e, out);
  }
}

void form_listed_weights(const double* w, const double* of_start, ListedValues x,
                         const double* coefficients, std::size_t elements,
                         const std::uint32_t* places, float* out) {
  const auto first_start = Vector<double>::load(of_start);
  const auto second_start = Vector<double>::load(of_start + kWidth);
  for (std::size_t e = 0; e < elements; ++e) {
    auto low = first_start * Vector<double>::load(w + e * kRowLanes);
    auto high = second_start * Vector<double>::load(w + e * kRowLanes + kWidth);
    for (std::uint32_t k = x.begins[e]; k < x.ends[e]; ++k) {
      const auto value = Vector<double>::all(static_cast<double>(x.values[k]));
      const double* line = coefficients + x.samples[k] * kRowLanes;
      low = multiply_add(Vector<double>::load(line), value, low);
      high = multiply_add(Vector<double>::load(line + kWidth), value, high);
    }
    store_halves(low, high, out + places[e] * kRowLanes);
  }
}

// Count vectors of neurons from `first` on: so many sums hide the latency of the multiply-add.
template <std::size_t Count>
inline void products_with_of(const ProductMap& map, std::size_t first, const double* of_initial,
                             const double* of_samples, double* out) {
  Vector<double> sums[Count];
#pragma GCC unroll 8
  for (std::size_t i = 0; i < Count; ++i) sums[i] = Vector<double>::all(0);
  const double* coefficients = map.coefficients + first;
  for (std::size_t s = 0; s < map.samples; ++s) {
    const auto product = Vector<double>::all(of_samples[s]);
#pragma GCC unroll 8
    for (std::size_t i = 0; i < Count; ++i) {
      sums[i] = multiply_add(Vector<double>::load(coefficients + i * kWidth), product, sums[i]);
    }
    coefficients += map.padded;
  }
#pragma GCC unroll 8
  for (std::size_t i = 0; i < Count; ++i) {
    const std::size_t at = first + i * kWidth;
    const auto of_start =
        Vector<double>::load(map.of_start + at) * Vector<double>::load(of_initial + at);
    multiply_add(sums[i], Vector<double>::load(map.factors + at), of_start).store(out + at);
  }
}

void products_with(const ProductMap& map, const double* of_initial, const double* of_samples,
                   double* out) {
  std::size_t at = 0;
  for (; at + 8 * kWidth <= map.padded; at += 8 * kWidth) {
    products_with_of<8>(map, at, of_initial, of_samples, out);
  }
  const std::size_t left = (map.padded - at) / kWidth;  // an even number
  if (left == 6) products_with_of<6>(map, at, of_initial, of_samples, out);
  if (left == 4) products_with_of<4>(map, at, of_initial, of_samples, out);
  if (left == 2) products_with_of<2>(map, at, of_initial, of_samples, out);
}

std::size_t least(const double* offsets, const double* products, double scale, std::size_t count,
                  double* scores) {
  const std::size_t whole = count / kWidth * kWidth;
  const auto negative = Vector<double>::all(-scale);
  auto least = Vector<double>::all(__builtin_inf());
  for (std::size_t at = 0; at < whole; at += kWidth) {
    const auto score = multiply_add(negative, Vector<double>::load(products + at),
                                    Vector<double>::load(offsets + at));
    score.store(scores + at);
    least = minimum(least, score);
  }
  alignas(64) double lanes[kWidth];
  least.store(lanes);
  double value = lanes[0];
  for (const double lane : lanes) value = lane < value ? lane : value;
  for (std::size_t at = whole; at < count; ++at) {
    scores[at] = __builtin_fma(-scale, products[at], offsets[at]);
    value = scores[at] < value ? scores[at] : value;
  }
  const auto wanted = Vector<double>::all(value);
  for (std::size_t at = 0; at < whole; at += kWidth) {
    const unsigned equal = equal_lanes(Vector<double>::load(scores + at), wanted);
    if (equal != 0) return at + static_cast<std::size_t>(__builtin_ctz(equal));
  }
  for (std::size_t at = whole; at < count; ++at) {
    if (scores[at] == value) return at;
  }
  return 0;  // no number is the least
}

// Multiplies the factors into the coefficients, for eight neurons: small ones would leave the range
// of normal numbers.
inline void fold(const ProductMap& map, std::size_t at) {
  const auto factor = Vector<double>::load(map.factors + at);
  const auto limit = Vector<double>::all(kNegligible<double>);
  for (std::size_t s = 0; s < map.samples; ++s) {
    double* line = map.coefficients + s * map.padded + at;
    zero_below(Vector<double>::load(line) * factor, limit).store(line);
  }
  Vector<double>::all(1).store(map.factors + at);
}

void move(const ProductMap& map, std::size_t sample, double squared_length, const double* products,
          const double* gains, bool normalize) {
  const auto smallest = Vector<double>::all(1e-100);
  const auto negligible = Vector<double>::all(kNegligible<double>);
  const auto one = Vector<double>::all(1);
  const auto zero = Vector<double>::all(0);
  const auto of_sample = Vector<double>::all(squared_length);
  double* coefficients = map.coefficients + sample * map.padded;
  for (std::size_t at = 0; at < map.padded; at += kWidth) {
    const auto gain = Vector<double>::load(gains + at);
    if (gain.is_zero()) continue;
    const auto kept = one - gain;
    const auto product = Vector<double>::load(products + at);
    auto squared = kept * kept * Vector<double>::load(map.squared_lengths + at);
    squared = multiply_add((gain + gain) * kept, product, squared);
    squared = multiply_add(gain * gain, of_sample, squared);
    auto factor = kept * Vector<double>::load(map.factors + at);
    auto of_start = kept * Vector<double>::load(map.of_start + at);
    factor.store(map.factors + at);
    if (equal_lanes(zero_below(factor, smallest), zero) != 0) {
      fold(map, at);
      factor = one;
    }
    const auto added = Vector<double>::load(coefficients + at) + gain / factor;
    added.store(coefficients + at);
    if (normalize) {
      const auto shrink = where_positive(squared, one / square_root(squared), one);
      squared = where_positive(squared, one, squared);
      factor = factor * shrink;
      of_start = of_start * shrink;
      factor.store(map.factors + at);
    }
    squared.store(map.squared_lengths + at);
    zero_below(of_start, negligible).store(map.of_start + at);
  }
}

// As exponential() in elementary.cc, in the same steps.
inline Vector<double> exponential(Vector<double> x) {
  constexpr double kLowest = -700.0;
  static constexpr double kTerms[] = {1.0,
                                      1.0,
                                      1.0 / 2,
                                      1.0 / 6,
                                      1.0 / 24,
                                      1.0 / 120,
                                      1.0 / 720,
                                      1.0 / 5040,
                                      1.0 / 40320,
                                      1.0 / 362880,
                                      1.0 / 3628800,
                                      1.0 / 39916800,
                                      1.0 / 479001600,
                                      1.0 / 6227020800.0};
  const auto lowest = Vector<double>::all(kLowest);
  const auto in_range = x - lowest;
  x = where_positive(in_range, x, lowest);
  const auto multiple = floor_of(
      multiply_add(x, Vector<double>::all(0x1.71547652b82fep+0), Vector<double>::all(0.5)));
  const auto negative = Vector<double>::all(0) - multiple;
  auto rest = multiply_add(negative, Vector<double>::all(0x1.62e42fefa3800p-1), x);
  rest = multiply_add(negative, Vector<double>::all(0x1.ef35793c76730p-45), rest);
  auto sum = Vector<double>::all(kTerms[13]);
#pragma GCC unroll 13
  for (std::size_t i = 13; i-- > 0;) sum = multiply_add(sum, rest, Vector<double>::all(kTerms[i]));
  return where_positive(in_range, sum * power_of_two(multiple), Vector<double>::all(0));
}

void exponentials(double* values, std::size_t count) {
  alignas(64) double lanes[kWidth];
  for (std::size_t at = 0; at < count; at += kWidth) {
    const std::size_t left = count - at < kWidth ? count - at : kWidth;
    for (std::size_t i = 0; i < kWidth; ++i) lanes[i] = i < left ? values[at + i] : 0.0;
    exponential(Vector<double>::load(lanes)).store(lanes);
    for (std::size_t i = 0; i < left; ++i) values[at + i] = lanes[i];
  }
}

}  // namespace

// NOLINTBEGIN(misc-definitions-in-headers): each source that includes this has its own namespace
extern const ProductTable kProductTable = {
    uniform_rows, uniform_row,         initial_weights, add_products, add_listed_products,
    form_weights, form_listed_weights, products_with,   least,        move,
    exponentials};
// NOLINTEND(misc-definitions-in-headers)

}  // namespace somato::kernels::SOMATO_KERNELS
