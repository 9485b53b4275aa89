#pragma once

// Inner loops over many samples and a whole map at once. The search for winners is a product of
// integer matrices, screened while it stands in registers: 16-bit integers are exact to add up, so
// every instruction set finds the same candidates, and processors multiply them at twice the rate
// of single precision or better. The winner among the candidates is decided in double precision.

#include <cstddef>
#include <cstdint>

namespace somato::kernels {

/// Samples that are screened together.
inline constexpr std::size_t kTileSamples = 6;

/// Neurons that stand side by side in a block.
inline constexpr std::size_t kBlockNeurons = 16;

/// So many candidates can be kept for a sample.
inline constexpr std::size_t kMostCandidates = 128;

/// The greatest magnitude of an integer. Rows of Euclidean length kGreatestInteger have products
/// that are sums within 32 bits whatever their number of columns (Cauchy and Schwarz).
inline constexpr float kGreatestInteger = 32766.0F;

/// Neurons as integers: block after block, in a block pair after pair of columns, in a pair neuron
/// after neuron. An odd number of columns is filled up with 0, a last block with offsets that are
/// infinite.
struct ScreenedNeurons {
  const std::int16_t* values;
  const float* offsets;
  std::size_t pairs;
};

/// A neuron that may win, by its place in the order of ScreenedNeurons.
struct CandidateNeuron {
  float score;
  std::uint32_t place;
};

/// The candidates for one sample: all with scores below `threshold`, and perhaps others.
struct Candidates {
  float threshold;
  float margin;  ///< Scores below the least one (or second least) plus this are kept.
  float least;
  float second_least;
  std::uint32_t count;
  bool overflown;  ///< There was no room for all.
  CandidateNeuron kept[kMostCandidates];
};

/// kTileSamples samples as integers, row after row.
struct ScreenedTile {
  const std::int16_t* rows;
  const float* factors;  ///< A score is offset - factor * (integer product).
  Candidates* candidates;
  bool two;  ///< The threshold follows the second least score, not the least.
};

struct BatchTable {
  /// Adds to the tile's candidates the neurons of the listed blocks whose scores are below the
  /// thresholds, and lowers those.
  void (*screen)(const ScreenedNeurons& neurons, const std::uint32_t* blocks, std::size_t count,
                 const ScreenedTile& tile);
  /// out = the scores of all `blocks` blocks, blocks after blocks for each sample of the tile.
  void (*score)(const ScreenedNeurons& neurons, std::size_t blocks, const ScreenedTile& tile,
                float* out);
  /// The least of `blocks` cache lines of values.
  float (*least)(const float* values, std::size_t blocks);
  /// Writes where values are not above `limit` to `places`, in order; returns how many there are.
  std::size_t (*places_up_to)(const float* values, std::size_t blocks, float limit,
                              std::uint32_t* places);
  /// marks = 1 where 2 * score + shift <= (reach + radius)^2, for each of `count` blocks; others
  /// stay as they are.
  void (*mark_near)(const float* scores, const float* radii, std::size_t count, float reach,
                    float shift, std::int32_t* marks);
  /// out = (x - centre) * factor, rounded to the nearest integers, which must be within 16 bits.
  /// Returns the sum of the squares of what was rounded off.
  float (*to_integers)(const float* x, const float* centre, float factor, std::size_t count,
                       std::int16_t* out);
  /// The sum of (a - b)^2 in single precision, off by at most (count / 16 + 20) 2^-24 of itself.
  float (*squared_length)(const float* a, const float* b, std::size_t count);
  /// The sum of (a - b)^2 in double precision, in one fixed order.
  double (*squared_distance)(const float* a, const float* b, std::size_t count);
  /// The sum of a * b in double precision, in one fixed order.
  double (*inner_product)(const float* a, const float* b, std::size_t count);
  /// The sum of |a - b| in double precision, in one fixed order.
  double (*absolute_distance)(const float* a, const float* b, std::size_t count);
  /// The greatest |a - b| in double precision.
  double (*greatest_difference)(const float* a, const float* b, std::size_t count);
  /// sums(winner) += the eight values at `values` times the eight powers of 2 at `scales`, rounded
  /// to the nearest integers, which must be below 2^51 in magnitude, even ones in ties, for each of
  /// `count` winners; those of the next are `stride` further on. `sums` holds eight for each
  /// neuron; scales and sums stand on cache lines.
  void (*add_by_winner)(const float* values, std::size_t stride, const double* scales,
                        const std::size_t* winners, std::size_t count, std::int64_t* sums);
  /// out(u) += sum over v of factors[u * places + v] * in(v), where `in` and `out` hold a cache
  /// line of lanes for each of `places` and `outputs` places.
  void (*mix)(const double* factors, const double* in, std::size_t places, double* out,
              std::size_t outputs);
};

/// The kernels of the instruction set in use.
const BatchTable& batch_table();

}  // namespace somato::kernels
