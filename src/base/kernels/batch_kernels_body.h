// The kernels of batch_kernels.h, written once. Each kernels_*.cc defines SOMATO_KERNELS as a
// namespace of its own and includes this file, compiled for its instruction set.

#include <cstddef>
#include <cstdint>
#include <cstring>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include "base/kernels/batch_kernels.h"

namespace somato::kernels::SOMATO_KERNELS {
namespace {

#include "base/kernels/vector.h"  // NOLINT(bugprone-suspicious-include): meant to be inside the namespace

// A double of this size has no places behind the point: adding it rounds, and the bits of the sum
// differ from its own by the integer.
constexpr double kOneIsLast = 0x1.8p52;
constexpr std::int64_t kBitsOfOneIsLast = __builtin_bit_cast(std::int64_t, kOneIsLast);

// Sixteen sums of products of pairs of 16-bit integers. Blocks are so many as registers can hold.
#if defined(__AVX512BW__)
constexpr std::size_t kBlocksAtOnce = 4;
constexpr std::size_t kSamplesAtOnce = 6;
constexpr std::size_t kMixedAtOnce = 8;
struct IntegerSums {
  __m512i lanes;
  static IntegerSums zero() { return {_mm512_setzero_si512()}; }
  Vector<float> to_floats() const { return {_mm512_maskz_cvtepi32_ps(0xFFFF, lanes)}; }
};
struct Pairs {
  __m512i lanes;
  static Pairs load(const std::int16_t* from) { return {_mm512_load_si512(from)}; }
  static Pairs all(std::int32_t pair) { return {_mm512_set1_epi32(pair)}; }
};
inline IntegerSums add_products(IntegerSums sums, Pairs a, Pairs b) {
#if defined(__AVX512VNNI__)
  return {_mm512_dpwssd_epi32(sums.lanes, a.lanes, b.lanes)};
#else
  return {_mm512_add_epi32(sums.lanes, _mm512_madd_epi16(a.lanes, b.lanes))};
#endif
}
inline unsigned below(Vector<float> a, Vector<float> b) {
  return _mm512_cmp_ps_mask(a.lanes, b.lanes, _CMP_LT_OQ);
}
inline unsigned not_above(Vector<float> a, Vector<float> b) {
  return _mm512_cmp_ps_mask(a.lanes, b.lanes, _CMP_LE_OQ);
}
inline Vector<float> lesser(Vector<float> a, Vector<float> b) {
  return {_mm512_maskz_min_ps(0xFFFF, a.lanes, b.lanes)};
}
inline Vector<float> unaligned(const float* from) {
  return {_mm512_loadu_ps(from)};
}
inline Vector<double> as_doubles(const float* from) {
  return {_mm512_maskz_cvtps_pd(0xFF, _mm256_loadu_ps(from))};
}
inline void add_integers(Vector<double> a, std::int64_t* to) {
  const __m512i integers =
      _mm512_sub_epi64(_mm512_castpd_si512(a.lanes), _mm512_set1_epi64(kBitsOfOneIsLast));
  _mm512_store_si512(to, _mm512_add_epi64(_mm512_load_si512(to), integers));
}
inline Vector<float> to_sixteen(Vector<float> a, std::int16_t* out) {
  const __m512i wide = _mm512_maskz_cvtps_epi32(0xFFFF, a.lanes);
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), _mm512_maskz_cvtepi32_epi16(0xFFFF, wide));
  return {_mm512_maskz_cvtepi32_ps(0xFFFF, wide)};
}
#elif defined(__AVX2__) && defined(__FMA__)
constexpr std::size_t kBlocksAtOnce = 1;
constexpr std::size_t kSamplesAtOnce = 3;
constexpr std::size_t kMixedAtOnce = 4;
struct IntegerSums {
  __m256i low, high;
  static IntegerSums zero() { return {_mm256_setzero_si256(), _mm256_setzero_si256()}; }
  Vector<float> to_floats() const { return {_mm256_cvtepi32_ps(low), _mm256_cvtepi32_ps(high)}; }
};
struct Pairs {
  __m256i low, high;
  static Pairs load(const std::int16_t* from) {
    const auto* at = reinterpret_cast<const __m256i*>(from);
    return {_mm256_load_si256(at), _mm256_load_si256(at + 1)};
  }
  static Pairs all(std::int32_t pair) { return {_mm256_set1_epi32(pair), _mm256_set1_epi32(pair)}; }
};
inline IntegerSums add_products(IntegerSums sums, Pairs a, Pairs b) {
  return {_mm256_add_epi32(sums.low, _mm256_madd_epi16(a.low, b.low)),
          _mm256_add_epi32(sums.high, _mm256_madd_epi16(a.high, b.high))};
}
inline unsigned below(Vector<float> a, Vector<float> b) {
  const auto low = _mm256_movemask_ps(_mm256_cmp_ps(a.low, b.low, _CMP_LT_OQ));
  const auto high = _mm256_movemask_ps(_mm256_cmp_ps(a.high, b.high, _CMP_LT_OQ));
  return static_cast<unsigned>(low) | (static_cast<unsigned>(high) << 8U);
}
inline unsigned not_above(Vector<float> a, Vector<float> b) {
  const auto low = _mm256_movemask_ps(_mm256_cmp_ps(a.low, b.low, _CMP_LE_OQ));
  const auto high = _mm256_movemask_ps(_mm256_cmp_ps(a.high, b.high, _CMP_LE_OQ));
  return static_cast<unsigned>(low) | (static_cast<unsigned>(high) << 8U);
}
inline Vector<float> lesser(Vector<float> a, Vector<float> b) {
  return {_mm256_min_ps(a.low, b.low), _mm256_min_ps(a.high, b.high)};
}
inline Vector<float> unaligned(const float* from) {
  return {_mm256_loadu_ps(from), _mm256_loadu_ps(from + 8)};
}
inline Vector<double> as_doubles(const float* from) {
  return {_mm256_cvtps_pd(_mm_loadu_ps(from)), _mm256_cvtps_pd(_mm_loadu_ps(from + 4))};
}
inline void add_integers(__m256d a, std::int64_t* to) {
  const __m256i integers =
      _mm256_sub_epi64(_mm256_castpd_si256(a), _mm256_set1_epi64x(kBitsOfOneIsLast));
  auto* const place = reinterpret_cast<__m256i*>(to);
  _mm256_store_si256(place, _mm256_add_epi64(_mm256_load_si256(place), integers));
}
inline void add_integers(Vector<double> a, std::int64_t* to) {
  add_integers(a.low, to);
  add_integers(a.high, to + 4);
}
inline Vector<float> to_sixteen(Vector<float> a, std::int16_t* out) {
  const __m256i low = _mm256_cvtps_epi32(a.low);
  const __m256i high = _mm256_cvtps_epi32(a.high);
  const __m256i mixed = _mm256_packs_epi32(low, high);
  _mm256_storeu_si256(reinterpret_cast<__m256i*>(out), _mm256_permute4x64_epi64(mixed, 0xD8));
  return {_mm256_cvtepi32_ps(low), _mm256_cvtepi32_ps(high)};
}
#elif defined(SOMATO_NEON)
constexpr std::size_t kBlocksAtOnce = 1;
constexpr std::size_t kSamplesAtOnce = 3;
constexpr std::size_t kMixedAtOnce = 4;
struct IntegerSums {
  int32x4_t parts[4];
  static IntegerSums zero() {
    const int32x4_t part = vdupq_n_s32(0);
    return {{part, part, part, part}};
  }
  Vector<float> to_floats() const {
    return {{vcvtq_f32_s32(parts[0]), vcvtq_f32_s32(parts[1]), vcvtq_f32_s32(parts[2]),
             vcvtq_f32_s32(parts[3])}};
  }
};
// The first and the second integers of the pairs of eight lanes each.
struct Pairs {
  int16x8_t first[2], second[2];
  static Pairs load(const std::int16_t* from) {
    const int16x8x2_t low = vld2q_s16(from);
    const int16x8x2_t high = vld2q_s16(from + 16);
    return {{low.val[0], high.val[0]}, {low.val[1], high.val[1]}};
  }
  static int16x4_t all(std::int32_t pair) { return vreinterpret_s16_s32(vdup_n_s32(pair)); }
};
inline IntegerSums add_products(IntegerSums sums, const Pairs& a, int16x4_t both) {
#pragma GCC unroll 2
  for (int i = 0; i < 2; ++i) {
    int32x4_t& low = sums.parts[2 * i];
    int32x4_t& high = sums.parts[2 * i + 1];
    low = vmlal_lane_s16(low, vget_low_s16(a.first[i]), both, 0);
    low = vmlal_lane_s16(low, vget_low_s16(a.second[i]), both, 1);
    high = vmlal_high_lane_s16(high, a.first[i], both, 0);
    high = vmlal_high_lane_s16(high, a.second[i], both, 1);
  }
  return sums;
}
// A bit a lane.
inline unsigned bits_of(uint32x4_t a, uint32x4_t b, uint32x4_t c, uint32x4_t d) {
  constexpr std::uint8_t kBits[] = {1, 2, 4, 8, 16, 32, 64, 128, 1, 2, 4, 8, 16, 32, 64, 128};
  const auto low = vuzp1q_u16(vreinterpretq_u16_u32(a), vreinterpretq_u16_u32(b));
  const auto high = vuzp1q_u16(vreinterpretq_u16_u32(c), vreinterpretq_u16_u32(d));
  const auto lanes = vuzp1q_u8(vreinterpretq_u8_u16(low), vreinterpretq_u8_u16(high));
  const auto bits = vandq_u8(lanes, vld1q_u8(kBits));
  return vaddv_u8(vget_low_u8(bits)) | (unsigned{vaddv_u8(vget_high_u8(bits))} << 8U);
}
inline unsigned below(const Vector<float>& a, const Vector<float>& b) {
  const auto mask = [&](int i) { return vcltq_f32(a.parts[i], b.parts[i]); };
  return bits_of(mask(0), mask(1), mask(2), mask(3));
}
inline unsigned not_above(const Vector<float>& a, const Vector<float>& b) {
  const auto mask = [&](int i) { return vcleq_f32(a.parts[i], b.parts[i]); };
  return bits_of(mask(0), mask(1), mask(2), mask(3));
}
inline Vector<float> lesser(const Vector<float>& a, const Vector<float>& b) {
  return by_parts([](auto x, auto y) { return vbslq_f32(vcltq_f32(x, y), x, y); }, a, b);
}
inline Vector<float> unaligned(const float* from) {
  return Vector<float>::load(from);
}
inline Vector<double> as_doubles(const float* from) {
  return widened(vld1q_f32(from), vld1q_f32(from + 4));
}
inline void add_integers(const Vector<double>& a, std::int64_t* to) {
  const int64x2_t bits = vdupq_n_s64(kBitsOfOneIsLast);
  for (const float64x2_t part : a.parts) {
    vst1q_s64(to, vld1q_s64(to) + (vreinterpretq_s64_f64(part) - bits));
    to += 2;
  }
}
inline Vector<float> to_sixteen(const Vector<float>& a, std::int16_t* out) {
  a.store_rounded(out);
  return by_parts([](auto x) { return vrndnq_f32(x); }, a);
}
#else
constexpr std::size_t kBlocksAtOnce = 1;
constexpr std::size_t kSamplesAtOnce = 3;
constexpr std::size_t kMixedAtOnce = 4;
struct IntegerSums {
  std::int32_t lanes[kBlockNeurons];
  static IntegerSums zero() { return {}; }
  Vector<float> to_floats() const {
    Vector<float> floats{};
    for (std::size_t i = 0; i < kBlockNeurons; ++i) floats.lanes[i] = static_cast<float>(lanes[i]);
    return floats;
  }
};
struct Pairs {
  std::int16_t values[2 * kBlockNeurons];
  static Pairs load(const std::int16_t* from) {
    Pairs pairs;
    std::memcpy(pairs.values, from, sizeof pairs.values);
    return pairs;
  }
  static Pairs all(std::int32_t pair) {
    Pairs pairs;
    for (std::size_t i = 0; i < kBlockNeurons; ++i) {
      std::memcpy(pairs.values + 2 * i, &pair, sizeof pair);
    }
    return pairs;
  }
};
inline IntegerSums add_products(IntegerSums sums, const Pairs& a, const Pairs& b) {
  for (std::size_t i = 0; i < kBlockNeurons; ++i) {
    sums.lanes[i] += a.values[2 * i] * b.values[2 * i] + a.values[2 * i + 1] * b.values[2 * i + 1];
  }
  return sums;
}
inline unsigned below(const Vector<float>& a, const Vector<float>& b) {
  unsigned mask = 0;
  for (std::size_t i = 0; i < kBlockNeurons; ++i) {
    mask |= static_cast<unsigned>(a.lanes[i] < b.lanes[i]) << i;
  }
  return mask;
}
inline unsigned not_above(const Vector<float>& a, const Vector<float>& b) {
  unsigned mask = 0;
  for (std::size_t i = 0; i < kBlockNeurons; ++i) {
    mask |= static_cast<unsigned>(a.lanes[i] <= b.lanes[i]) << i;
  }
  return mask;
}
inline Vector<float> lesser(Vector<float> a, const Vector<float>& b) {
  for (std::size_t i = 0; i < kBlockNeurons; ++i) {
    a.lanes[i] = a.lanes[i] < b.lanes[i] ? a.lanes[i] : b.lanes[i];
  }
  return a;
}
inline Vector<float> unaligned(const float* from) {
  return Vector<float>::load(from);
}
inline Vector<double> as_doubles(const float* from) {
  Vector<double> wide{};
  for (std::size_t i = 0; i < 8; ++i) wide.lanes[i] = static_cast<double>(from[i]);
  return wide;
}
inline void add_integers(const Vector<double>& a, std::int64_t* to) {
  for (std::size_t i = 0; i < 8; ++i) {
    to[i] += __builtin_bit_cast(std::int64_t, a.lanes[i]) - kBitsOfOneIsLast;
  }
}
// To the nearest, ties to even, by adding a number whose last digit is worth 1.
inline std::int16_t rounded(float value) {
  constexpr float kDigits = 12582912.0F;
  return static_cast<std::int16_t>((value + kDigits) - kDigits);
}
inline Vector<float> to_sixteen(Vector<float> a, std::int16_t* out) {
  for (std::size_t i = 0; i < kBlockNeurons; ++i) {
    out[i] = rounded(a.lanes[i]);
    a.lanes[i] = static_cast<float>(out[i]);
  }
  return a;
}
#endif

inline std::int32_t pair_at(const std::int16_t* from) {
  std::int32_t both = 0;
  std::memcpy(&both, from, sizeof both);
  return both;
}

inline void lower(Candidates& candidates, float score, bool two) {
  if (score < candidates.least) {
    candidates.second_least = candidates.least;
    candidates.least = score;
  } else if (score < candidates.second_least) {
    candidates.second_least = score;
  } else {
    return;
  }
  const float limit = (two ? candidates.second_least : candidates.least) + candidates.margin;
  if (limit < candidates.threshold) candidates.threshold = limit;
}

inline void keep(Candidates& candidates, CandidateNeuron candidate) {
  if (candidates.count == kMostCandidates) {
    std::uint32_t left = 0;
    for (std::uint32_t i = 0; i < candidates.count; ++i) {
      const CandidateNeuron one = candidates.kept[i];
      if (one.score < candidates.threshold) candidates.kept[left++] = one;
    }
    candidates.count = left;
  }
  if (candidates.count == kMostCandidates) {
    candidates.overflown = true;
  } else {
    candidates.kept[candidates.count++] = candidate;
  }
}

// Apart from the loop over columns, which has no register to spare.
__attribute__((noinline)) void keep_candidates(const Vector<float>& scores, unsigned mask,
                                               std::size_t block, bool two,
                                               Candidates& candidates) {
  alignas(64) float values[kBlockNeurons];
  scores.store(values);
  for (std::uint32_t lane = 0; lane < kBlockNeurons; ++lane) {
    if ((mask >> lane & 1U) == 0 || !(values[lane] < candidates.threshold)) continue;
    lower(candidates, values[lane], two);
    keep(candidates, {values[lane], static_cast<std::uint32_t>(block * kBlockNeurons) + lane});
  }
}

// The products of Count blocks with kSamplesAtOnce samples. The sums leave through memory: with
// nothing else in sight of them g++ keeps them in registers.
template <std::size_t Count>
inline void multiply(const ScreenedNeurons& neurons, const std::uint32_t* blocks,
                     const std::int16_t* rows, IntegerSums* out) {
  const std::size_t pairs = neurons.pairs;
  const std::int16_t* at[Count];
  IntegerSums sums[Count * kSamplesAtOnce];
#pragma GCC unroll 4
  for (std::size_t b = 0; b < Count; ++b) {
    at[b] = neurons.values + blocks[b] * pairs * 2 * kBlockNeurons;
  }
#pragma GCC unroll 24
  for (std::size_t i = 0; i < Count * kSamplesAtOnce; ++i) sums[i] = IntegerSums::zero();
  for (std::size_t pair = 0; pair < pairs; ++pair) {
    Pairs weights[Count];
#pragma GCC unroll 4
    for (std::size_t b = 0; b < Count; ++b) {
      weights[b] = Pairs::load(at[b] + pair * 2 * kBlockNeurons);
    }
#pragma GCC unroll 6
    for (std::size_t s = 0; s < kSamplesAtOnce; ++s) {
      const auto both = Pairs::all(pair_at(rows + 2 * (s * pairs + pair)));
#pragma GCC unroll 4
      for (std::size_t b = 0; b < Count; ++b) {
        sums[s * Count + b] = add_products(sums[s * Count + b], weights[b], both);
      }
    }
  }
#pragma GCC unroll 24
  for (std::size_t i = 0; i < Count * kSamplesAtOnce; ++i) out[i] = sums[i];
}

// Calls take(b, s, scores) for each of Count blocks and sample s of the tile.
template <std::size_t Count, typename Take>
inline void score_blocks(const ScreenedNeurons& neurons, const std::uint32_t* blocks,
                         const ScreenedTile& tile, const Take& take) {
  IntegerSums sums[Count * kTileSamples];
  for (std::size_t s = 0; s < kTileSamples; s += kSamplesAtOnce) {
    multiply<Count>(neurons, blocks, tile.rows + s * 2 * neurons.pairs, sums + s * Count);
  }
  for (std::size_t b = 0; b < Count; ++b) {
    const auto offsets = Vector<float>::load(neurons.offsets + blocks[b] * kBlockNeurons);
    for (std::size_t s = 0; s < kTileSamples; ++s) {
      const auto factor = Vector<float>::all(tile.factors[s]);
      take(blocks[b], s, offsets - sums[s * Count + b].to_floats() * factor);
    }
  }
}

template <typename Take>
inline void score_list(const ScreenedNeurons& neurons, const std::uint32_t* blocks,
                       std::size_t count, const ScreenedTile& tile, const Take& take) {
  std::size_t i = 0;
  for (; i + kBlocksAtOnce <= count; i += kBlocksAtOnce) {
    score_blocks<kBlocksAtOnce>(neurons, blocks + i, tile, take);
  }
  for (; i < count; ++i) score_blocks<1>(neurons, blocks + i, tile, take);
}

void screen(const ScreenedNeurons& neurons, const std::uint32_t* blocks, std::size_t count,
            const ScreenedTile& tile) {
  score_list(neurons, blocks, count, tile,
             [&](std::size_t block, std::size_t s, const Vector<float>& scores) {
               Candidates& candidates = tile.candidates[s];
               const unsigned mask = below(scores, Vector<float>::all(candidates.threshold));
               if (mask != 0) keep_candidates(scores, mask, block, tile.two, candidates);
             });
}

void score(const ScreenedNeurons& neurons, std::size_t blocks, const ScreenedTile& tile,
           float* out) {
  std::uint32_t list[kBlocksAtOnce];
  for (std::size_t first = 0; first < blocks; first += kBlocksAtOnce) {
    const std::size_t count = blocks - first < kBlocksAtOnce ? blocks - first : kBlocksAtOnce;
    for (std::size_t i = 0; i < count; ++i) list[i] = static_cast<std::uint32_t>(first + i);
    score_list(neurons, list, count, tile,
               [&](std::size_t block, std::size_t s, const Vector<float>& scores) {
                 scores.store(out + (s * blocks + block) * kBlockNeurons);
               });
  }
}

float least(const float* values, std::size_t blocks) {
  auto lanes = Vector<float>::load(values);
  for (std::size_t block = 1; block < blocks; ++block) {
    lanes = lesser(lanes, Vector<float>::load(values + block * kBlockNeurons));
  }
  alignas(64) float each[kBlockNeurons];
  lanes.store(each);
  float found = each[0];
  for (const float one : each) found = one < found ? one : found;
  return found;
}

std::size_t places_up_to(const float* values, std::size_t blocks, float limit,
                         std::uint32_t* places) {
  std::size_t count = 0;
  for (std::size_t block = 0; block < blocks; ++block) {
    const auto lanes = Vector<float>::load(values + block * kBlockNeurons);
    unsigned mask = not_above(lanes, Vector<float>::all(limit));
    for (; mask != 0; mask &= mask - 1) {
      const auto lane = static_cast<std::uint32_t>(__builtin_ctz(mask));
      places[count++] = static_cast<std::uint32_t>(block * kBlockNeurons) + lane;
    }
  }
  return count;
}

// Writes sixteen integers and adds the squares of what was rounded off.
inline Vector<float> sixteen_to_integers(const float* x, const float* centre, float factor,
                                         std::int16_t* out, Vector<float> squares) {
  const auto exact = (unaligned(x) - unaligned(centre)) * Vector<float>::all(factor);
  const auto rest = exact - to_sixteen(exact, out);
  return multiply_add(rest, rest, squares);
}

float to_integers(const float* x, const float* centre, float factor, std::size_t count,
                  std::int16_t* out) {
  auto squares = Vector<float>::all(0);
  std::size_t i = 0;
  for (; i + kBlockNeurons <= count; i += kBlockNeurons) {
    squares = sixteen_to_integers(x + i, centre + i, factor, out + i, squares);
  }
  if (i < count) {
    float rest[kBlockNeurons] = {};
    float centre_of_rest[kBlockNeurons] = {};
    std::int16_t integers[kBlockNeurons];
    std::memcpy(rest, x + i, (count - i) * sizeof(float));
    std::memcpy(centre_of_rest, centre + i, (count - i) * sizeof(float));
    squares = sixteen_to_integers(rest, centre_of_rest, factor, integers, squares);
    std::memcpy(out + i, integers, (count - i) * sizeof(std::int16_t));
  }
  alignas(64) float sums[kBlockNeurons];
  squares.store(sums);
  float total = 0.0F;
  for (const float sum : sums) total += sum;
  return total;
}

float squared_length(const float* a, const float* b, std::size_t count) {
  auto squares = Vector<float>::all(0);
  std::size_t i = 0;
  for (; i + kBlockNeurons <= count; i += kBlockNeurons) {
    const auto difference = unaligned(a + i) - unaligned(b + i);
    squares = multiply_add(difference, difference, squares);
  }
  alignas(64) float sums[kBlockNeurons];
  squares.store(sums);
  float total = 0.0F;
  for (; i < count; ++i) total += (a[i] - b[i]) * (a[i] - b[i]);
  for (const float sum : sums) total += sum;
  return total;
}

// Sixteen sums of every sixteenth term, then their sum.
template <typename Add>
inline double sum_in_sixteen(std::size_t count, const Add& add) {
  constexpr std::size_t kHalf = 8;
  Vector<double> low = Vector<double>::all(0);
  Vector<double> high = Vector<double>::all(0);
  std::size_t i = 0;
  for (; i + 2 * kHalf <= count; i += 2 * kHalf) {
    low = add.vectors(i, low);
    high = add.vectors(i + kHalf, high);
  }
  alignas(64) double sums[2 * kHalf];
  low.store(sums);
  high.store(sums + kHalf);
  for (; i < count; ++i) sums[i % (2 * kHalf)] = add.one(i, sums[i % (2 * kHalf)]);
  double total = 0.0;
  for (const double sum : sums) total += sum;
  return total;
}

struct AddSquares {
  const float* a;
  const float* b;
  Vector<double> vectors(std::size_t i, Vector<double> sum) const {
    const auto difference = as_doubles(a + i) - as_doubles(b + i);
    return multiply_add(difference, difference, sum);
  }
  double one(std::size_t i, double sum) const {
    const double difference = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    return __builtin_fma(difference, difference, sum);
  }
};

struct AddProducts {
  const float* a;
  const float* b;
  Vector<double> vectors(std::size_t i, Vector<double> sum) const {
    return multiply_add(as_doubles(a + i), as_doubles(b + i), sum);
  }
  double one(std::size_t i, double sum) const {
    return __builtin_fma(static_cast<double>(a[i]), static_cast<double>(b[i]), sum);
  }
};

struct AddMagnitudes {
  const float* a;
  const float* b;
  Vector<double> vectors(std::size_t i, Vector<double> sum) const {
    return sum + magnitude(as_doubles(a + i) - as_doubles(b + i));
  }
  double one(std::size_t i, double sum) const {
    return sum + __builtin_fabs(static_cast<double>(a[i]) - static_cast<double>(b[i]));
  }
};

double absolute_distance_in_double(const float* a, const float* b, std::size_t count) {
  return sum_in_sixteen(count, AddMagnitudes{a, b});
}

double greatest_difference_in_double(const float* a, const float* b, std::size_t count) {
  double most = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double apart = __builtin_fabs(static_cast<double>(a[i]) - static_cast<double>(b[i]));
    most = apart > most ? apart : most;
  }
  return most;
}

double squared_distance_in_double(const float* a, const float* b, std::size_t count) {
  return sum_in_sixteen(count, AddSquares{a, b});
}

double inner_product_in_double(const float* a, const float* b, std::size_t count) {
  return sum_in_sixteen(count, AddProducts{a, b});
}

// Plain, for the compiler to vectorize: the blocks do not depend on each other.
void mark_near(const float* __restrict scores, const float* __restrict radii, std::size_t count,
               float reach, float shift, std::int32_t* __restrict marks) {
  for (std::size_t i = 0; i < count; ++i) {
    const float distance = reach + radii[i];
    marks[i] |= 2.0F * scores[i] + shift <= distance * distance ? 1 : 0;
  }
}

void add_by_winner(const float* values, std::size_t stride, const double* scales,
                   const std::size_t* winners, std::size_t count, std::int64_t* sums) {
  const auto scale = Vector<double>::load(scales);
  const auto one_is_last = Vector<double>::all(kOneIsLast);
  for (std::size_t i = 0; i < count; ++i, values += stride) {
    add_integers(as_doubles(values) * scale + one_is_last, sums + winners[i] * 8);
  }
}

template <std::size_t Count>
inline void mix_to(const double* factors, const double* in, std::size_t places, double* out) {
  constexpr std::size_t kLanes = 8;
  Vector<double> sums[Count];
#pragma GCC unroll 8
  for (std::size_t u = 0; u < Count; ++u) sums[u] = Vector<double>::load(out + u * kLanes);
  for (std::size_t v = 0; v < places; ++v) {
    const auto value = Vector<double>::load(in + v * kLanes);
#pragma GCC unroll 8
    for (std::size_t u = 0; u < Count; ++u) {
      sums[u] = multiply_add(Vector<double>::all(factors[u * places + v]), value, sums[u]);
    }
  }
#pragma GCC unroll 8
  for (std::size_t u = 0; u < Count; ++u) sums[u].store(out + u * kLanes);
}

void mix(const double* factors, const double* in, std::size_t places, double* out,
         std::size_t outputs) {
  constexpr std::size_t kLanes = 8;
  std::size_t u = 0;
  for (; u + kMixedAtOnce <= outputs; u += kMixedAtOnce) {
    mix_to<kMixedAtOnce>(factors + u * places, in, places, out + u * kLanes);
  }
  for (; u < outputs; ++u) mix_to<1>(factors + u * places, in, places, out + u * kLanes);
}

}  // namespace

// NOLINTBEGIN(misc-definitions-in-headers): each source that includes this has its own namespace
extern const BatchTable kBatchTable = {screen,
                                       score,
                                       least,
                                       places_up_to,
                                       mark_near,
                                       to_integers,
                                       squared_length,
                                       squared_distance_in_double,
                                       inner_product_in_double,
                                       absolute_distance_in_double,
                                       greatest_difference_in_double,
                                       add_by_winner,
                                       mix};
// NOLINTEND(misc-definitions-in-headers)

}  // namespace somato::kernels::SOMATO_KERNELS
