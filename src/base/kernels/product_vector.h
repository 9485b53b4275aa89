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
