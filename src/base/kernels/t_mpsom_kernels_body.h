// The kernels of the T-MPSOM, written once. Each kernels_*.cc includes this after kernels_body.h,
// whose vectors it takes.

#include "base/kernels/t_mpsom_kernels.h"

namespace somato::kernels::SOMATO_KERNELS {
namespace {

using Floats = Vector<float>;
using Doubles = Vector<double>;
constexpr std::size_t kFloats = kLaneCount<float>;
constexpr std::size_t kDoubles = kLaneCount<double>;

// Wherever it starts.
inline Doubles load_anywhere(const double* from) {
  Doubles vector;
  __builtin_memcpy(&vector, from, sizeof vector);
  return vector;
}

inline void store_anywhere(const Doubles& vector, double* to) {
  __builtin_memcpy(to, &vector, sizeof vector);
}

void banded_inner_products(Lanes<const float> w, Lanes<const float> mask, std::size_t first,
                           const std::uint32_t* columns, const float* x, std::size_t count,
                           float* out) {
  sum_rows<float>(w.blocks, count, out, [&](std::size_t block, std::size_t i, Floats sum) {
    const auto masked = Floats::load(lanes_at(mask, block, columns[i] - first)) *
                        Floats::load(lanes_at(w, block, columns[i]));
    return multiply_add(masked, Floats::all(x[i]), sum);
  });
}

// w x and w w of neighbouring blocks.
template <std::size_t Count>
struct Sums {
  Floats products[Count];
  Floats squares[Count];

  void clear() {
#pragma GCC unroll 4
    for (std::size_t i = 0; i < Count; ++i) products[i] = squares[i] = Floats::all(0);
  }

  void add(const Sums& other) {
#pragma GCC unroll 4
    for (std::size_t i = 0; i < Count; ++i) {
      products[i] = products[i] + other.products[i];
      squares[i] = squares[i] + other.squares[i];
    }
  }
};

template <std::size_t Count>
inline Sums<Count> measure(Lanes<const float> w, std::size_t first_block, const float* x) {
  Sums<Count> totals;
  totals.clear();
  for (std::size_t start = 0; start < w.columns; start += kChunk) {
    const std::size_t end = start + kChunk < w.columns ? start + kChunk : w.columns;
    Sums<Count> sums;
    sums.clear();
    for (std::size_t column = start; column < end; ++column) {
      const auto element = Floats::all(x[column]);
#pragma GCC unroll 4
      for (std::size_t i = 0; i < Count; ++i) {
        const auto weight = Floats::load(lanes_at(w, first_block + i, column));
        sums.products[i] = multiply_add(weight, element, sums.products[i]);
        sums.squares[i] = multiply_add(weight, weight, sums.squares[i]);
      }
    }
    totals.add(sums);
  }
  return totals;
}

// Where parts cancel, or squares leave what single precision holds well, a length is doubtful.
inline Floats find_unit_move(const Floats& product, const Floats& square, const Floats& sample,
                             std::size_t lane, const float* gains, const Moves& moves) {
  const auto gain = Floats::load(gains + lane);
  const auto rest = Floats::all(1) - gain;
  const auto twice = (gain + gain) * rest;
  const auto parts = multiply_add(rest * rest, square, gain * gain * sample);
  const auto squared = multiply_add(twice, product, parts);
  const auto limit = multiply_add(Floats::all(0.5F), parts, Floats::all(1e-30F));
  const auto doubtful = zero_below(limit, squared) + zero_below(squared, Floats::all(1e30F));
  const auto inverse = Floats::all(1) / square_root(squared);
  (rest * inverse).store(moves.keep + lane);
  (gain * inverse).store(moves.add + lane);
  doubtful.store(moves.doubtful + lane);
  return doubtful;
}

template <std::size_t Count>
inline bool find_unit_moves_of(Lanes<const float> w, std::size_t first_block, const float* x,
                               float squared_length_of_x, const float* gains, const Moves& moves) {
  const Sums<Count> sums = measure<Count>(w, first_block, x);
  const auto sample = Floats::all(squared_length_of_x);
  bool certain = true;
#pragma GCC unroll 4
  for (std::size_t i = 0; i < Count; ++i) {
    const std::size_t lane = (first_block + i) * kFloats;
    certain &=
        find_unit_move(sums.products[i], sums.squares[i], sample, lane, gains, moves).is_zero();
  }
  return certain;
}

bool find_unit_moves(Lanes<const float> w, const float* x, float squared_length_of_x,
                     const float* gains, const Moves& moves) {
  bool certain = true;
  std::size_t block = 0;
  for (; block + 4 <= w.blocks; block += 4) {
    certain &= find_unit_moves_of<4>(w, block, x, squared_length_of_x, gains, moves);
  }
  for (; block < w.blocks; ++block) {
    certain &= find_unit_moves_of<1>(w, block, x, squared_length_of_x, gains, moves);
  }
  return certain;
}

bool find_measured_moves(const Measures& measures, std::size_t blocks, float squared_length_of_x,
                         const float* gains, const Moves& moves) {
  const auto sample = Floats::all(squared_length_of_x);
  bool certain = true;
  for (std::size_t lane = 0; lane < blocks * kFloats; lane += kFloats) {
    certain &= find_unit_move(Floats::load(measures.products + lane),
                              Floats::load(measures.squares + lane), sample, lane, gains, moves)
                   .is_zero();
  }
  return certain;
}

void find_plain_moves(const float* gains, std::size_t blocks, const Moves& moves) {
  for (std::size_t lane = 0; lane < blocks * kFloats; lane += kFloats) {
    const auto gain = Floats::load(gains + lane);
    (Floats::all(1) - gain).store(moves.keep + lane);
    gain.store(moves.add + lane);
  }
}

void move(Lanes<float> w, const float* x, const Moves& moves) {
  const auto limit = Floats::all(kNegligible<float>);
  for (std::size_t block = 0; block < w.blocks; ++block) {
    const auto keep = Floats::load(moves.keep + block * kFloats);
    const auto add = Floats::load(moves.add + block * kFloats);
    for (std::size_t column = 0; column < w.columns; ++column) {
      float* lanes = lanes_at(w, block, column);
      const auto kept = Floats::load(lanes) * keep;
      zero_below(multiply_add(add, Floats::all(x[column]), kept), limit).store(lanes);
    }
  }
}

// One block, moved and measured column by column: it is memory that this waits for, so that more
// blocks at once gain nothing.
template <bool Moving, bool HasInput>
class Passage {
 public:
  Passage(float* lanes, std::size_t lane, const float* sample, const Moves& moves)
      : lanes_(lanes), sample_(sample) {
    if constexpr (Moving) {
      keep_ = Floats::load(moves.keep + lane);
      add_ = Floats::load(moves.add + lane);
    }
  }

  // `mask` is that of column `begin`, where the columns are in the field.
  template <bool InField>
  void pass(std::size_t begin, std::size_t end, const float* x, const float* mask) {
    const auto limit = Floats::all(kNegligible<float>);
    for (std::size_t column = begin; column < end; ++column) {
      float* const lanes = lanes_ + column * kFloats;
      auto weight = Floats::load(lanes);
      if constexpr (Moving) {
        const auto kept = weight * keep_;
        weight = zero_below(multiply_add(add_, Floats::all(sample_[column]), kept), limit);
        weight.store(lanes);
      }
      squares_ = multiply_add(weight, weight, squares_);
      if constexpr (!HasInput) continue;
      const auto element = Floats::all(x[column]);
      products_ = multiply_add(weight, element, products_);
      if constexpr (!InField) continue;
      const auto seen = Floats::load(mask + (column - begin) * kFloats) * weight;
      partial_ = multiply_add(seen, element, partial_);
    }
  }

  // Zero is added as the sums over chunks do, which leaves no negative zero.
  void store(std::size_t lane, const Measures& measures) const {
    (Floats::all(0) + partial_).store(measures.partial + lane);
    (Floats::all(0) + products_).store(measures.products + lane);
    (Floats::all(0) + squares_).store(measures.squares + lane);
  }

 private:
  float* lanes_;
  const float* sample_;
  Floats keep_ = Floats::all(1);
  Floats add_ = Floats::all(0);
  Floats partial_ = Floats::all(0);
  Floats products_ = Floats::all(0);
  Floats squares_ = Floats::all(0);
};

template <bool Moving, bool HasInput>
inline void move_and_measure_all(Lanes<float> w, const float* sample, const Moves& moves,
                                 const ReceptiveInput& input, const Measures& measures) {
  const std::size_t end = input.first + input.mask.columns;
  for (std::size_t block = 0; block < w.blocks; ++block) {
    const std::size_t lane = block * kFloats;
    Passage<Moving, HasInput> passage(lanes_at(w, block, 0), lane, sample, moves);
    const float* const mask = lanes_at(input.mask, block, 0);
    passage.template pass<false>(0, input.first, input.x, mask);
    passage.template pass<HasInput>(input.first, end, input.x, mask);
    passage.template pass<false>(end, w.columns, input.x, mask);
    passage.store(lane, measures);
  }
}

void move_and_measure(Lanes<float> w, const float* sample, const Moves& moves,
                      const ReceptiveInput& input, const Measures& measures) {
  const bool moving = sample != nullptr;
  const auto pass = moving && input.is_zero ? move_and_measure_all<true, false>
                    : moving                ? move_and_measure_all<true, true>
                    : input.is_zero         ? move_and_measure_all<false, false>
                                            : move_and_measure_all<false, true>;
  pass(w, sample, moves, input, measures);
}

bool any(const float* values, std::size_t blocks) {
  for (std::size_t block = 0; block < blocks; ++block) {
    if (!Floats::load(values + block * kFloats).is_zero()) return true;
  }
  return false;
}

// Plain loops, for the compiler to vectorize, where values do not depend on each other.

void start_activity(const float* p, std::size_t count, double* y) {
  for (std::size_t n = 0; n < count; ++n) y[n] = static_cast<double>(p[n]);
}

void multiply_activity(const float* p, std::size_t count, double* y) {
  for (std::size_t n = 0; n < count; ++n) y[n] *= static_cast<double>(p[n]);
}

void add_activity(const float* p, std::size_t count, double* y) {
  for (std::size_t n = 0; n < count; ++n) y[n] += static_cast<double>(p[n]);
}

// A value that is not finite gives NaN when multiplied by zero, which a sum keeps.
bool rectify(const double* y, std::size_t count, double* out) {
  double strange[kDoubles] = {};
  std::size_t n = 0;
  for (; n + kDoubles <= count; n += kDoubles) {
    for (std::size_t i = 0; i < kDoubles; ++i) {
      strange[i] += y[n + i] * 0.0;
      out[n + i] = y[n + i] > 0.0 ? y[n + i] : 0.0;
    }
  }
  for (; n < count; ++n) {
    strange[0] += y[n] * 0.0;
    out[n] = y[n] > 0.0 ? y[n] : 0.0;
  }
  double sum = 0.0;
  for (const double value : strange) sum += value;
  return sum == 0.0;
}

double largest(const double* values, std::size_t count) {
  double best[kDoubles] = {};
  std::size_t n = 0;
  for (; n + kDoubles <= count; n += kDoubles) {
    for (std::size_t i = 0; i < kDoubles; ++i) {
      best[i] = best[i] < values[n + i] ? values[n + i] : best[i];
    }
  }
  for (; n < count; ++n) best[0] = best[0] < values[n] ? values[n] : best[0];
  double most = 0.0;
  for (const double value : best) most = most < value ? value : most;
  return most;
}

void find_gains(double* values, std::size_t count, double maximum, double alpha, float* gains) {
  constexpr auto kLimit = static_cast<double>(kNegligible<float>);
  const auto most = Doubles::all(maximum);
  const auto rate = Doubles::all(alpha);
  const auto gain_of = [&](double* at) {
    const auto value = load_anywhere(at) / most;
    store_anywhere(value, at);
    return zero_below(rate * value, Doubles::all(kLimit));
  };
  std::size_t n = 0;
  for (; n + 2 * kDoubles <= count; n += 2 * kDoubles) {
    const auto low = gain_of(values + n);
    store_halves(low, gain_of(values + n + kDoubles), gains + n);
  }
  for (; n < count; ++n) {
    values[n] /= maximum;
    const double gain = alpha * values[n];
    gains[n] = gain < kLimit ? 0.0F : static_cast<float>(gain);
  }
}

// Columns `column` and on of Count neighbouring rows.
template <std::size_t Count>
inline void spread_to_rows(std::size_t place, std::size_t column, const double* in,
                           std::size_t places, std::size_t width, const double* factors,
                           std::size_t reach, double* out) {
  const std::size_t first = place > reach ? place - reach : 0;
  const std::size_t end = place + Count + reach < places ? place + Count + reach : places;
  Doubles sums[Count];
#pragma GCC unroll 4
  for (std::size_t i = 0; i < Count; ++i) sums[i] = Doubles::all(0);
  for (std::size_t from = first; from < end; ++from) {
    const auto value = load_anywhere(in + from * width + column);
    const double* factor = factors + from - place;
#pragma GCC unroll 4
    for (std::size_t i = 0; i < Count; ++i) {
      sums[i] = multiply_add(value, Doubles::all(*(factor - i)), sums[i]);
    }
  }
#pragma GCC unroll 4
  for (std::size_t i = 0; i < Count; ++i) {
    store_anywhere(sums[i], out + (place + i) * width + column);
  }
}

void spread_columns(std::size_t column, const double* in, std::size_t places, std::size_t width,
                    const double* factors, std::size_t reach, double* out) {
  std::size_t place = 0;
  for (; place + kSpreadGroup <= places; place += kSpreadGroup) {
    spread_to_rows<kSpreadGroup>(place, column, in, places, width, factors, reach, out);
  }
  for (; place < places; ++place) {
    spread_to_rows<1>(place, column, in, places, width, factors, reach, out);
  }
}

// Columns too few for a vector.
void spread_column(std::size_t column, const double* in, std::size_t places, std::size_t width,
                   const double* factors, std::size_t reach, double* out) {
  for (std::size_t place = 0; place < places; ++place) {
    const std::size_t first = place > reach ? place - reach : 0;
    const std::size_t end = place + reach < places ? place + reach + 1 : places;
    double sum = 0.0;
    for (std::size_t from = first; from < end; ++from) {
      sum = __builtin_fma(in[from * width + column], *(factors + from - place), sum);
    }
    out[place * width + column] = sum;
  }
}

// The last columns may be computed twice.
void spread_rows(const double* in, std::size_t places, std::size_t width, const double* factors,
                 std::size_t reach, double* out) {
  if (width < kDoubles) {
    for (std::size_t column = 0; column < width; ++column) {
      spread_column(column, in, places, width, factors, reach, out);
    }
    return;
  }
  for (std::size_t column = 0; column < width; column += kDoubles) {
    const std::size_t last = width - kDoubles;
    spread_columns(column < last ? column : last, in, places, width, factors, reach, out);
  }
}

// Four vectors at a time hide the latency of the multiply-add; the last of a line may be computed
// several times.
void spread_line(const double* in, std::size_t places, const double* factors, std::size_t reach,
                 double* out) {
  if (places < kDoubles) return spread_column(0, in, places, 1, factors, reach, out);
  constexpr std::size_t kAtOnce = 4;
  const std::size_t last = places - kDoubles;
  for (std::size_t place = 0; place < places; place += kAtOnce * kDoubles) {
    std::size_t starts[kAtOnce];
    Doubles sums[kAtOnce];
#pragma GCC unroll 4
    for (std::size_t i = 0; i < kAtOnce; ++i) {
      starts[i] = place + i * kDoubles < last ? place + i * kDoubles : last;
      sums[i] = Doubles::all(0);
    }
    for (std::size_t near = 0; near <= 2 * reach; ++near) {
      const auto factor = Doubles::all(*(factors + near - reach));
#pragma GCC unroll 4
      for (std::size_t i = 0; i < kAtOnce; ++i) {
        sums[i] = multiply_add(load_anywhere(in + starts[i] + near - reach), factor, sums[i]);
      }
    }
#pragma GCC unroll 4
    for (std::size_t i = 0; i < kAtOnce; ++i) store_anywhere(sums[i], out + starts[i]);
  }
}

}  // namespace

// NOLINTNEXTLINE(misc-definitions-in-headers): each source that includes this has its own namespace
extern const TMpsomTable kTMpsomTable = {banded_inner_products,
                                         find_unit_moves,
                                         find_measured_moves,
                                         move_and_measure,
                                         find_plain_moves,
                                         move,
                                         any,
                                         start_activity,
                                         multiply_activity,
                                         add_activity,
                                         rectify,
                                         largest,
                                         find_gains,
                                         spread_rows,
                                         spread_line};

}  // namespace somato::kernels::SOMATO_KERNELS
