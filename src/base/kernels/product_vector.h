#pragma once

// Vector operations of training by products that vector.h does not provide: words of a random
// number generator, minimum, lanes picked by a condition. Include only from product_kernels_body.h,
// inside the namespace of one instruction set.

#if defined(__AVX512F__)

// Eight words in 64 bits each, of which the upper half is left to chance.
struct Words {
  __m512i lanes;
  static Words all(std::uint32_t word) { return {_mm512_set1_epi64(word)}; }
  static Words load(const std::uint64_t* from) { return {_mm512_loadu_si512(from)}; }
};
inline Words product_of(Words a, Words b) {
  return {_mm512_maskz_mul_epu32(0xFF, a.lanes, b.lanes)};
}
inline Words exclusive_or(Words a, Words b) {
  return {_mm512_xor_si512(a.lanes, b.lanes)};
}
// The upper half of `product`, with b and c.
inline Words upper_with(Words product, Words b, Words c) {
  const __m512i upper =
      _mm512_maskz_srli_epi64(0xFF, product.lanes, 32);  // masked: see square_root() in vector.h
  return {_mm512_ternarylogic_epi64(upper, b.lanes, c.lanes, 0x96)};
}
// The upper 24 bits of each word as a number in [0, 1): even lanes, odd lanes.
inline Vector<float> uniform_of(Words even, Words odd) {
  const __m512i words = _mm512_mask_shuffle_epi32(even.lanes, 0xAAAA, odd.lanes, _MM_PERM_CCAA);
  const __m512i upper = _mm512_maskz_srli_epi32(0xFFFF, words, 8);
  return {_mm512_mul_ps(_mm512_maskz_cvtepi32_ps(0xFFFF, upper), _mm512_set1_ps(0x1p-24F))};
}

inline Vector<double> minimum(Vector<double> a, Vector<double> b) {
  return {_mm512_maskz_min_pd(0xFF, a.lanes, b.lanes)};
}
// A bit a lane.
inline unsigned equal_lanes(Vector<double> a, Vector<double> b) {
  return _mm512_cmp_pd_mask(a.lanes, b.lanes, _CMP_EQ_OQ);
}
// a where `condition` is above 0, else b.
inline Vector<double> where_positive(Vector<double> condition, Vector<double> a, Vector<double> b) {
  const auto positive = _mm512_cmp_pd_mask(condition.lanes, _mm512_setzero_pd(), _CMP_GT_OQ);
  return {_mm512_mask_blend_pd(positive, b.lanes, a.lanes)};
}
// 2 to the power of each `exponent`, a whole number from -1022 to 1023.
inline Vector<double> power_of_two(Vector<double> exponent) {
  const __m512d biased = _mm512_add_pd(exponent.lanes, _mm512_set1_pd(0x1.8p52 + 1023.0));
  return {_mm512_castsi512_pd(_mm512_maskz_slli_epi64(0xFF, _mm512_castpd_si512(biased), 52))};
}
inline Vector<double> floor_of(Vector<double> a) {
  return {_mm512_maskz_roundscale_pd(0xFF, a.lanes, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC)};
}

#elif defined(__AVX2__) && defined(__FMA__)

struct Words {
  __m256i low, high;
  static Words all(std::uint32_t word) {
    return {_mm256_set1_epi64x(word), _mm256_set1_epi64x(word)};
  }
  static Words load(const std::uint64_t* from) {
    const auto* lines = reinterpret_cast<const __m256i*>(from);
    return {_mm256_loadu_si256(lines), _mm256_loadu_si256(lines + 1)};
  }
};
inline Words product_of(Words a, Words b) {
  return {_mm256_mul_epu32(a.low, b.low), _mm256_mul_epu32(a.high, b.high)};
}
inline Words exclusive_or(Words a, Words b) {
  return {_mm256_xor_si256(a.low, b.low), _mm256_xor_si256(a.high, b.high)};
}
inline Words upper_with(Words product, Words b, Words c) {
  const Words upper{_mm256_srli_epi64(product.low, 32), _mm256_srli_epi64(product.high, 32)};
  return exclusive_or(upper, exclusive_or(b, c));
}
inline __m256 uniform_of(__m256i even, __m256i odd) {
  const __m256i words = _mm256_blend_epi32(even, _mm256_slli_epi64(odd, 32), 0xAA);
  return _mm256_mul_ps(_mm256_cvtepi32_ps(_mm256_srli_epi32(words, 8)), _mm256_set1_ps(0x1p-24F));
}
inline Vector<float> uniform_of(Words even, Words odd) {
  return {uniform_of(even.low, odd.low), uniform_of(even.high, odd.high)};
}

inline Vector<double> minimum(Vector<double> a, Vector<double> b) {
  return {_mm256_min_pd(a.low, b.low), _mm256_min_pd(a.high, b.high)};
}
inline unsigned equal_lanes(Vector<double> a, Vector<double> b) {
  const int low = _mm256_movemask_pd(_mm256_cmp_pd(a.low, b.low, _CMP_EQ_OQ));
  const int high = _mm256_movemask_pd(_mm256_cmp_pd(a.high, b.high, _CMP_EQ_OQ));
  return static_cast<unsigned>(low) | (static_cast<unsigned>(high) << 4U);
}
inline __m256d where_positive(__m256d condition, __m256d a, __m256d b) {
  return _mm256_blendv_pd(b, a, _mm256_cmp_pd(condition, _mm256_setzero_pd(), _CMP_GT_OQ));
}
inline Vector<double> where_positive(Vector<double> condition, Vector<double> a, Vector<double> b) {
  return {where_positive(condition.low, a.low, b.low),
          where_positive(condition.high, a.high, b.high)};
}
inline __m256d power_of_two(__m256d exponent) {
  const __m256d biased = _mm256_add_pd(exponent, _mm256_set1_pd(0x1.8p52 + 1023.0));
  return _mm256_castsi256_pd(_mm256_slli_epi64(_mm256_castpd_si256(biased), 52));
}
inline Vector<double> power_of_two(Vector<double> exponent) {
  return {power_of_two(exponent.low), power_of_two(exponent.high)};
}
inline Vector<double> floor_of(Vector<double> a) {
  return {_mm256_floor_pd(a.low), _mm256_floor_pd(a.high)};
}

#elif defined(SOMATO_NEON)

// Apart from the other half of each product, which upper_with() is the only one to read.
struct Words {
  uint32x4_t lanes[2];
  uint32x4_t upper[2];
  static Words all(std::uint32_t word) {
    const uint32x4_t lane = vdupq_n_u32(word);
    return {{lane, lane}, {lane, lane}};
  }
  static Words of(const uint64x2_t (&numbers)[4]) {
    const auto words = [&](int i) { return vreinterpretq_u32_u64(numbers[i]); };
    return {{vuzp1q_u32(words(0), words(1)), vuzp1q_u32(words(2), words(3))},
            {vuzp2q_u32(words(0), words(1)), vuzp2q_u32(words(2), words(3))}};
  }
  static Words load(const std::uint64_t* from) {
    return of({vld1q_u64(from), vld1q_u64(from + 2), vld1q_u64(from + 4), vld1q_u64(from + 6)});
  }
};
inline Words product_of(const Words& a, const Words& b) {
  return Words::of({vmull_u32(vget_low_u32(a.lanes[0]), vget_low_u32(b.lanes[0])),
                    vmull_high_u32(a.lanes[0], b.lanes[0]),
                    vmull_u32(vget_low_u32(a.lanes[1]), vget_low_u32(b.lanes[1])),
                    vmull_high_u32(a.lanes[1], b.lanes[1])});
}
inline Words exclusive_or(Words a, const Words& b) {
  a.lanes[0] ^= b.lanes[0];
  a.lanes[1] ^= b.lanes[1];
  return a;
}
inline Words upper_with(Words product, const Words& b, const Words& c) {
  product.lanes[0] = product.upper[0] ^ b.lanes[0] ^ c.lanes[0];
  product.lanes[1] = product.upper[1] ^ b.lanes[1] ^ c.lanes[1];
  return product;
}
// The conversion divides by 2^24.
inline float32x4_t uniform_of(uint32x4_t words) {
  return vcvtq_n_f32_u32(vshrq_n_u32(words, 8), 24);
}
inline Vector<float> uniform_of(const Words& even, const Words& odd) {
  return {{uniform_of(vzip1q_u32(even.lanes[0], odd.lanes[0])),
           uniform_of(vzip2q_u32(even.lanes[0], odd.lanes[0])),
           uniform_of(vzip1q_u32(even.lanes[1], odd.lanes[1])),
           uniform_of(vzip2q_u32(even.lanes[1], odd.lanes[1]))}};
}

// Not the instruction for the minimum, which differs where a number is missing.
inline Vector<double> minimum(const Vector<double>& a, const Vector<double>& b) {
  return by_parts([](auto x, auto y) { return vbslq_f64(vcltq_f64(x, y), x, y); }, a, b);
}
inline unsigned equal_lanes(const Vector<double>& a, const Vector<double>& b) {
  constexpr std::uint16_t kBits[] = {1, 2, 4, 8, 16, 32, 64, 128};
  const auto equal = [&](int i) {
    return vreinterpretq_u32_u64(vceqq_f64(a.parts[i], b.parts[i]));
  };
  const auto low = vreinterpretq_u16_u32(vuzp1q_u32(equal(0), equal(1)));
  const auto high = vreinterpretq_u16_u32(vuzp1q_u32(equal(2), equal(3)));
  return vaddvq_u16(vandq_u16(vuzp1q_u16(low, high), vld1q_u16(kBits)));
}
inline Vector<double> where_positive(const Vector<double>& condition, const Vector<double>& a,
                                     const Vector<double>& b) {
  return by_parts([](auto x, auto y, auto z) { return vbslq_f64(vcgtzq_f64(x), y, z); }, condition,
                  a, b);
}
inline float64x2_t power_of_two(float64x2_t exponent) {
  const uint64x2_t biased = bits_of(exponent + vdupq_n_f64(0x1.8p52 + 1023.0));
  return vreinterpretq_f64_u64(vshlq_n_u64(biased, 52));
}
inline Vector<double> power_of_two(const Vector<double>& exponent) {
  return by_parts([](auto x) { return power_of_two(x); }, exponent);
}
inline Vector<double> floor_of(const Vector<double>& a) {
  return by_parts([](auto x) { return vrndmq_f64(x); }, a);
}

#else

struct Words {
  std::uint64_t lanes[8];
  static Words all(std::uint32_t word) {
    Words words;
    for (std::uint64_t& lane : words.lanes) lane = word;
    return words;
  }
  static Words load(const std::uint64_t* from) {
    Words words;
    for (std::size_t i = 0; i < 8; ++i) words.lanes[i] = from[i];
    return words;
  }
};
inline Words product_of(Words a, const Words& b) {
  for (std::size_t i = 0; i < 8; ++i) {
    a.lanes[i] = (a.lanes[i] & 0xFFFFFFFFU) * (b.lanes[i] & 0xFFFFFFFFU);
  }
  return a;
}
inline Words exclusive_or(Words a, const Words& b) {
  for (std::size_t i = 0; i < 8; ++i) a.lanes[i] ^= b.lanes[i];
  return a;
}
inline Words upper_with(Words product, const Words& b, const Words& c) {
  for (std::size_t i = 0; i < 8; ++i) {
    product.lanes[i] = (product.lanes[i] >> 32U) ^ b.lanes[i] ^ c.lanes[i];
  }
  return product;
}
inline float uniform_of(std::uint64_t word) {
  return static_cast<float>(static_cast<std::uint32_t>(word) >> 8U) * 0x1p-24F;
}
inline Vector<float> uniform_of(const Words& even, const Words& odd) {
  Vector<float> numbers;
  for (std::size_t i = 0; i < 8; ++i) {
    numbers.lanes[2 * i] = uniform_of(even.lanes[i]);
    numbers.lanes[2 * i + 1] = uniform_of(odd.lanes[i]);
  }
  return numbers;
}

inline Vector<double> minimum(Vector<double> a, const Vector<double>& b) {
  for (std::size_t i = 0; i < 8; ++i)
    a.lanes[i] = a.lanes[i] < b.lanes[i] ? a.lanes[i] : b.lanes[i];
  return a;
}
inline unsigned equal_lanes(const Vector<double>& a, const Vector<double>& b) {
  unsigned equal = 0;
  for (unsigned i = 0; i < 8; ++i) equal |= static_cast<unsigned>(a.lanes[i] == b.lanes[i]) << i;
  return equal;
}
inline Vector<double> where_positive(const Vector<double>& condition, Vector<double> a,
                                     const Vector<double>& b) {
  for (std::size_t i = 0; i < 8; ++i) {
    if (!(condition.lanes[i] > 0.0)) a.lanes[i] = b.lanes[i];
  }
  return a;
}
inline Vector<double> power_of_two(Vector<double> exponent) {
  for (double& lane : exponent.lanes) lane = __builtin_ldexp(1.0, static_cast<int>(lane));
  return exponent;
}
inline Vector<double> floor_of(Vector<double> a) {
  for (double& lane : a.lanes) lane = __builtin_floor(lane);
  return a;
}

#endif
