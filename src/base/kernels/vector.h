#pragma once

// One cache line of lanes, by the widest registers the including file is compiled for. Every
// operation is the same IEEE operation on each lane, so all variants give the same bits.
// Include only from kernels_body.h, inside the namespace of one instruction set.

template <typename Real>
struct Vector;

#if defined(SOMATO_NEON)

#include "base/kernels/vector_neon.h"  // NOLINT(bugprone-suspicious-include): as this file

#elif defined(__AVX512F__)

template <>
struct Vector<float> {
  __m512 lanes;
  static Vector load(const float* from) { return {_mm512_load_ps(from)}; }
  static Vector load(const std::int16_t* from) {
    const auto integers = _mm256_load_si256(reinterpret_cast<const __m256i*>(from));
    return {_mm512_maskz_cvtepi32_ps(0xFFFF, _mm512_maskz_cvtepi16_epi32(0xFFFF, integers))};
  }
  static Vector all(float value) { return {_mm512_set1_ps(value)}; }
  void store(float* to) const { _mm512_store_ps(to, lanes); }
  // The nearest integers, which must be in range; even ones where two are as near.
  void store_rounded(std::int16_t* to) const {
    const auto integers =
        _mm512_maskz_cvtepi32_epi16(0xFFFF, _mm512_maskz_cvtps_epi32(0xFFFF, lanes));
    _mm256_store_si256(reinterpret_cast<__m256i*>(to), integers);
  }
  bool is_zero() const { return _mm512_cmp_ps_mask(lanes, _mm512_setzero_ps(), _CMP_NEQ_UQ) == 0; }
};
inline Vector<float> operator+(Vector<float> a, Vector<float> b) {
  return {_mm512_add_ps(a.lanes, b.lanes)};
}
inline Vector<float> operator-(Vector<float> a, Vector<float> b) {
  return {_mm512_sub_ps(a.lanes, b.lanes)};
}
inline Vector<float> operator*(Vector<float> a, Vector<float> b) {
  return {_mm512_mul_ps(a.lanes, b.lanes)};
}
inline Vector<float> operator/(Vector<float> a, Vector<float> b) {
  return {_mm512_div_ps(a.lanes, b.lanes)};
}
// Masked, though of all lanes: g++ 12 warns of the undefined register behind the plain form.
inline Vector<float> square_root(Vector<float> a) {
  return {_mm512_maskz_sqrt_ps(0xFFFF, a.lanes)};
}
inline Vector<float> multiply_add(Vector<float> a, Vector<float> b, Vector<float> c) {
  return {_mm512_fmadd_ps(a.lanes, b.lanes, c.lanes)};
}
inline Vector<float> zero_below(Vector<float> a, Vector<float> limit) {
  const auto keep = _mm512_cmp_ps_mask(_mm512_abs_ps(a.lanes), limit.lanes, _CMP_NLT_UQ);
  return {_mm512_maskz_mov_ps(keep, a.lanes)};
}
// The greater of a and the magnitude of b.
inline Vector<float> greatest(Vector<float> a, Vector<float> b) {
  return {_mm512_maskz_max_ps(0xFFFF, a.lanes, _mm512_abs_ps(b.lanes))};
}
// Zero below zero; zeros keep their sign.
inline Vector<float> rectified(Vector<float> a) {
  return {_mm512_maskz_max_ps(0xFFFF, _mm512_setzero_ps(), a.lanes)};
}
inline Vector<float> magnitude(Vector<float> a) {
  return {_mm512_abs_ps(a.lanes)};
}

template <>
struct Vector<double> {
  __m512d lanes;
  static Vector load(const double* from) { return {_mm512_load_pd(from)}; }
  static Vector all(double value) { return {_mm512_set1_pd(value)}; }
  void store(double* to) const { _mm512_store_pd(to, lanes); }
  bool is_zero() const { return _mm512_cmp_pd_mask(lanes, _mm512_setzero_pd(), _CMP_NEQ_UQ) == 0; }
};
// The halves of a vector of floats, and one of what has been computed from them.
template <int Half>
inline Vector<double> half_of(Vector<float> a) {
  const __m512d halves = _mm512_castps_pd(a.lanes);
  const __m256d half = _mm512_maskz_extractf64x4_pd(0xF, halves, Half);
  return {_mm512_maskz_cvtps_pd(0xFF, _mm256_castpd_ps(half))};
}
inline Vector<double> lower_half(Vector<float> a) {
  return half_of<0>(a);
}
inline Vector<double> upper_half(Vector<float> a) {
  return half_of<1>(a);
}
inline void store_halves(Vector<double> low, Vector<double> high, float* to) {
  _mm256_store_ps(to, _mm512_maskz_cvtpd_ps(0xFF, low.lanes));
  _mm256_store_ps(to + 8, _mm512_maskz_cvtpd_ps(0xFF, high.lanes));
}
inline Vector<double> operator+(Vector<double> a, Vector<double> b) {
  return {_mm512_add_pd(a.lanes, b.lanes)};
}
inline Vector<double> operator-(Vector<double> a, Vector<double> b) {
  return {_mm512_sub_pd(a.lanes, b.lanes)};
}
inline Vector<double> operator*(Vector<double> a, Vector<double> b) {
  return {_mm512_mul_pd(a.lanes, b.lanes)};
}
inline Vector<double> operator/(Vector<double> a, Vector<double> b) {
  return {_mm512_div_pd(a.lanes, b.lanes)};
}
inline Vector<double> square_root(Vector<double> a) {
  return {_mm512_maskz_sqrt_pd(0xFF, a.lanes)};
}
inline Vector<double> magnitude(Vector<double> a) {
  return {_mm512_abs_pd(a.lanes)};
}
inline Vector<double> multiply_add(Vector<double> a, Vector<double> b, Vector<double> c) {
  return {_mm512_fmadd_pd(a.lanes, b.lanes, c.lanes)};
}
inline Vector<double> zero_below(Vector<double> a, Vector<double> limit) {
  const auto keep = _mm512_cmp_pd_mask(_mm512_abs_pd(a.lanes), limit.lanes, _CMP_NLT_UQ);
  return {_mm512_maskz_mov_pd(keep, a.lanes)};
}

#elif defined(__AVX2__) && defined(__FMA__)

template <>
struct Vector<float> {
  __m256 low, high;
  static Vector load(const float* from) { return {_mm256_load_ps(from), _mm256_load_ps(from + 8)}; }
  static __m256 load_half(const std::int16_t* from) {
    const auto integers = _mm_load_si128(reinterpret_cast<const __m128i*>(from));
    return _mm256_cvtepi32_ps(_mm256_cvtepi16_epi32(integers));
  }
  static Vector load(const std::int16_t* from) { return {load_half(from), load_half(from + 8)}; }
  static Vector all(float value) { return {_mm256_set1_ps(value), _mm256_set1_ps(value)}; }
  void store(float* to) const {
    _mm256_store_ps(to, low);
    _mm256_store_ps(to + 8, high);
  }
  void store_rounded(std::int16_t* to) const {
    constexpr int kInOrder = 0xD8;
    const auto mixed = _mm256_packs_epi32(_mm256_cvtps_epi32(low), _mm256_cvtps_epi32(high));
    _mm256_store_si256(reinterpret_cast<__m256i*>(to), _mm256_permute4x64_epi64(mixed, kInOrder));
  }
  bool is_zero() const {
    const __m256 zero = _mm256_setzero_ps();
    return _mm256_movemask_ps(_mm256_or_ps(_mm256_cmp_ps(low, zero, _CMP_NEQ_UQ),
                                           _mm256_cmp_ps(high, zero, _CMP_NEQ_UQ))) == 0;
  }
};
inline Vector<float> operator+(Vector<float> a, Vector<float> b) {
  return {_mm256_add_ps(a.low, b.low), _mm256_add_ps(a.high, b.high)};
}
inline Vector<float> operator-(Vector<float> a, Vector<float> b) {
  return {_mm256_sub_ps(a.low, b.low), _mm256_sub_ps(a.high, b.high)};
}
inline Vector<float> operator*(Vector<float> a, Vector<float> b) {
  return {_mm256_mul_ps(a.low, b.low), _mm256_mul_ps(a.high, b.high)};
}
inline Vector<float> operator/(Vector<float> a, Vector<float> b) {
  return {_mm256_div_ps(a.low, b.low), _mm256_div_ps(a.high, b.high)};
}
inline Vector<float> square_root(Vector<float> a) {
  return {_mm256_sqrt_ps(a.low), _mm256_sqrt_ps(a.high)};
}
inline Vector<float> multiply_add(Vector<float> a, Vector<float> b, Vector<float> c) {
  return {_mm256_fmadd_ps(a.low, b.low, c.low), _mm256_fmadd_ps(a.high, b.high, c.high)};
}
inline __m256 zero_below(__m256 a, __m256 limit) {
  const __m256 magnitude = _mm256_andnot_ps(_mm256_set1_ps(-0.0F), a);
  return _mm256_and_ps(a, _mm256_cmp_ps(magnitude, limit, _CMP_NLT_UQ));
}
inline Vector<float> zero_below(Vector<float> a, Vector<float> limit) {
  return {zero_below(a.low, limit.low), zero_below(a.high, limit.high)};
}
inline __m256 greatest(__m256 a, __m256 b) {
  return _mm256_max_ps(a, _mm256_andnot_ps(_mm256_set1_ps(-0.0F), b));
}
inline Vector<float> greatest(Vector<float> a, Vector<float> b) {
  return {greatest(a.low, b.low), greatest(a.high, b.high)};
}
inline Vector<float> rectified(Vector<float> a) {
  const __m256 zero = _mm256_setzero_ps();
  return {_mm256_max_ps(zero, a.low), _mm256_max_ps(zero, a.high)};
}
inline Vector<float> magnitude(Vector<float> a) {
  const __m256 sign = _mm256_set1_ps(-0.0F);
  return {_mm256_andnot_ps(sign, a.low), _mm256_andnot_ps(sign, a.high)};
}

template <>
struct Vector<double> {
  __m256d low, high;
  static Vector load(const double* from) {
    return {_mm256_load_pd(from), _mm256_load_pd(from + 4)};
  }
  static Vector all(double value) { return {_mm256_set1_pd(value), _mm256_set1_pd(value)}; }
  void store(double* to) const {
    _mm256_store_pd(to, low);
    _mm256_store_pd(to + 4, high);
  }
  bool is_zero() const {
    const __m256d zero = _mm256_setzero_pd();
    return _mm256_movemask_pd(_mm256_or_pd(_mm256_cmp_pd(low, zero, _CMP_NEQ_UQ),
                                           _mm256_cmp_pd(high, zero, _CMP_NEQ_UQ))) == 0;
  }
};
inline Vector<double> widened(__m256 a) {
  return {_mm256_cvtps_pd(_mm256_castps256_ps128(a)), _mm256_cvtps_pd(_mm256_extractf128_ps(a, 1))};
}
inline Vector<double> lower_half(Vector<float> a) {
  return widened(a.low);
}
inline Vector<double> upper_half(Vector<float> a) {
  return widened(a.high);
}
inline void store_halves(Vector<double> low, Vector<double> high, float* to) {
  _mm_store_ps(to, _mm256_cvtpd_ps(low.low));
  _mm_store_ps(to + 4, _mm256_cvtpd_ps(low.high));
  _mm_store_ps(to + 8, _mm256_cvtpd_ps(high.low));
  _mm_store_ps(to + 12, _mm256_cvtpd_ps(high.high));
}
inline Vector<double> operator+(Vector<double> a, Vector<double> b) {
  return {_mm256_add_pd(a.low, b.low), _mm256_add_pd(a.high, b.high)};
}
inline Vector<double> operator-(Vector<double> a, Vector<double> b) {
  return {_mm256_sub_pd(a.low, b.low), _mm256_sub_pd(a.high, b.high)};
}
inline Vector<double> operator*(Vector<double> a, Vector<double> b) {
  return {_mm256_mul_pd(a.low, b.low), _mm256_mul_pd(a.high, b.high)};
}
inline Vector<double> operator/(Vector<double> a, Vector<double> b) {
  return {_mm256_div_pd(a.low, b.low), _mm256_div_pd(a.high, b.high)};
}
inline Vector<double> square_root(Vector<double> a) {
  return {_mm256_sqrt_pd(a.low), _mm256_sqrt_pd(a.high)};
}
inline Vector<double> magnitude(Vector<double> a) {
  const __m256d sign = _mm256_set1_pd(-0.0);
  return {_mm256_andnot_pd(sign, a.low), _mm256_andnot_pd(sign, a.high)};
}
inline Vector<double> multiply_add(Vector<double> a, Vector<double> b, Vector<double> c) {
  return {_mm256_fmadd_pd(a.low, b.low, c.low), _mm256_fmadd_pd(a.high, b.high, c.high)};
}
inline __m256d zero_below(__m256d a, __m256d limit) {
  const __m256d magnitude = _mm256_andnot_pd(_mm256_set1_pd(-0.0), a);
  return _mm256_and_pd(a, _mm256_cmp_pd(magnitude, limit, _CMP_NLT_UQ));
}
inline Vector<double> zero_below(Vector<double> a, Vector<double> limit) {
  return {zero_below(a.low, limit.low), zero_below(a.high, limit.high)};
}

#else

template <typename Real>
struct Vector {
  static constexpr std::size_t kCount = 64 / sizeof(Real);
  Real lanes[kCount];
  template <typename From>
  static Vector load(const From* from) {
    Vector vector;
    for (std::size_t i = 0; i < kCount; ++i) vector.lanes[i] = from[i];
    return vector;
  }
  static Vector all(Real value) {
    Vector vector;
    for (Real& lane : vector.lanes) lane = value;
    return vector;
  }
  void store(Real* to) const {
    for (std::size_t i = 0; i < kCount; ++i) to[i] = lanes[i];
  }
  // Single precision has no places behind the point where it begins to have no halves.
  void store_rounded(std::int16_t* to) const {
    constexpr Real kNoHalves = 0x1.8p23F;
    for (std::size_t i = 0; i < kCount; ++i) {
      to[i] = static_cast<std::int16_t>((lanes[i] + kNoHalves) - kNoHalves);
    }
  }
  bool is_zero() const {
    for (const Real lane : lanes) {
      if (lane != Real{0}) return false;
    }
    return true;
  }
};
template <typename Real>
inline Vector<Real> operator+(Vector<Real> a, const Vector<Real>& b) {
  for (std::size_t i = 0; i < a.kCount; ++i) a.lanes[i] += b.lanes[i];
  return a;
}
template <typename Real>
inline Vector<Real> operator-(Vector<Real> a, const Vector<Real>& b) {
  for (std::size_t i = 0; i < a.kCount; ++i) a.lanes[i] -= b.lanes[i];
  return a;
}
template <typename Real>
inline Vector<Real> operator*(Vector<Real> a, const Vector<Real>& b) {
  for (std::size_t i = 0; i < a.kCount; ++i) a.lanes[i] *= b.lanes[i];
  return a;
}
template <typename Real>
inline Vector<Real> operator/(Vector<Real> a, const Vector<Real>& b) {
  for (std::size_t i = 0; i < a.kCount; ++i) a.lanes[i] /= b.lanes[i];
  return a;
}
inline float square_root(float value) {
  return __builtin_sqrtf(value);
}
inline double square_root(double value) {
  return __builtin_sqrt(value);
}
template <typename Real>
inline Vector<Real> square_root(Vector<Real> a) {
  for (Real& lane : a.lanes) lane = square_root(lane);
  return a;
}
// Without the instruction these are calls of the mathematics library: slower, the same bits.
inline float fused_multiply_add(float a, float b, float c) {
  return __builtin_fmaf(a, b, c);
}
inline double fused_multiply_add(double a, double b, double c) {
  return __builtin_fma(a, b, c);
}

template <typename Real>
inline Vector<Real> multiply_add(Vector<Real> a, const Vector<Real>& b, const Vector<Real>& c) {
  for (std::size_t i = 0; i < a.kCount; ++i) {
    a.lanes[i] = fused_multiply_add(a.lanes[i], b.lanes[i], c.lanes[i]);
  }
  return a;
}
template <typename Real>
inline Vector<Real> zero_below(Vector<Real> a, const Vector<Real>& limit) {
  for (std::size_t i = 0; i < a.kCount; ++i) {
    const Real magnitude = a.lanes[i] < 0 ? -a.lanes[i] : a.lanes[i];
    if (magnitude < limit.lanes[i]) a.lanes[i] = 0;
  }
  return a;
}
inline float magnitude(float value) {
  return __builtin_fabsf(value);
}
inline double magnitude(double value) {
  return __builtin_fabs(value);
}
template <typename Real>
inline Vector<Real> magnitude(Vector<Real> a) {
  for (Real& lane : a.lanes) lane = magnitude(lane);
  return a;
}
inline Vector<float> greatest(Vector<float> a, const Vector<float>& b) {
  for (std::size_t i = 0; i < Vector<float>::kCount; ++i) {
    const float magnitude = b.lanes[i] < 0 ? -b.lanes[i] : b.lanes[i];
    if (magnitude > a.lanes[i]) a.lanes[i] = magnitude;
  }
  return a;
}
inline Vector<float> rectified(Vector<float> a) {
  for (float& lane : a.lanes) lane = lane < 0 ? 0 : lane;
  return a;
}
inline Vector<double> widened(const float* from) {
  Vector<double> vector;
  for (std::size_t i = 0; i < 8; ++i) vector.lanes[i] = static_cast<double>(from[i]);
  return vector;
}
inline Vector<double> lower_half(const Vector<float>& a) {
  return widened(a.lanes);
}
inline Vector<double> upper_half(const Vector<float>& a) {
  return widened(a.lanes + 8);
}
inline void store_halves(const Vector<double>& low, const Vector<double>& high, float* to) {
  for (std::size_t i = 0; i < 8; ++i) {
    to[i] = static_cast<float>(low.lanes[i]);
    to[i + 8] = static_cast<float>(high.lanes[i]);
  }
}

#endif
