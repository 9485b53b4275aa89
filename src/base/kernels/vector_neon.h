#pragma once

// The vectors of vector.h in four registers of NEON each, written once for both types of number.
// Include only from vector.h.

inline float32x4_t load_part(const float* from) {
  return vld1q_f32(from);
}
inline float64x2_t load_part(const double* from) {
  return vld1q_f64(from);
}
inline float32x4_t load_part(const std::int16_t* from) {
  return vcvtq_f32_s32(vmovl_s16(vld1_s16(from)));
}
inline void store_part(float* to, float32x4_t a) {
  vst1q_f32(to, a);
}
inline void store_part(double* to, float64x2_t a) {
  vst1q_f64(to, a);
}
inline float32x4_t all_lanes(float value) {
  return vdupq_n_f32(value);
}
inline float64x2_t all_lanes(double value) {
  return vdupq_n_f64(value);
}
inline uint32x4_t bits_of(float32x4_t a) {
  return vreinterpretq_u32_f32(a);
}
inline uint64x2_t bits_of(float64x2_t a) {
  return vreinterpretq_u64_f64(a);
}
inline uint32x4_t without_sign(uint32x4_t bits) {
  return vshlq_n_u32(bits, 1);
}
inline uint32x4_t without_sign(uint64x2_t bits) {
  return vreinterpretq_u32_u64(vshlq_n_u64(bits, 1));
}
// The nearest integers, even ones where two are as near.
inline int16x8_t rounded(float32x4_t low, float32x4_t high) {
  return vmovn_high_s32(vmovn_s32(vcvtnq_s32_f32(low)), vcvtnq_s32_f32(high));
}

template <typename Real>
struct Vector {
  using Part = decltype(all_lanes(Real{}));
  static constexpr std::size_t kPart = sizeof(Part) / sizeof(Real);
  Part parts[4];
  template <typename From>
  static Vector load(const From* from) {
    return {{load_part(from), load_part(from + kPart), load_part(from + 2 * kPart),
             load_part(from + 3 * kPart)}};
  }
  static Vector all(Real value) {
    const Part part = all_lanes(value);
    return {{part, part, part, part}};
  }
  void store(Real* to) const {
    store_part(to, parts[0]);
    store_part(to + kPart, parts[1]);
    store_part(to + 2 * kPart, parts[2]);
    store_part(to + 3 * kPart, parts[3]);
  }
  void store_rounded(std::int16_t* to) const {
    vst1q_s16(to, rounded(parts[0], parts[1]));
    vst1q_s16(to + 8, rounded(parts[2], parts[3]));
  }
  bool is_zero() const {
    const auto low = bits_of(parts[0]) | bits_of(parts[1]);
    const auto high = bits_of(parts[2]) | bits_of(parts[3]);
    return vmaxvq_u32(without_sign(low | high)) == 0;
  }
};

// change(part of each vector...), part by part.
template <typename Real, typename Change, typename... Others>
inline Vector<Real> by_parts(const Change& change, const Vector<Real>& a, const Others&... others) {
  return {{change(a.parts[0], others.parts[0]...), change(a.parts[1], others.parts[1]...),
           change(a.parts[2], others.parts[2]...), change(a.parts[3], others.parts[3]...)}};
}

template <typename Real>
inline Vector<Real> operator+(const Vector<Real>& a, const Vector<Real>& b) {
  return by_parts([](auto x, auto y) { return x + y; }, a, b);
}
template <typename Real>
inline Vector<Real> operator-(const Vector<Real>& a, const Vector<Real>& b) {
  return by_parts([](auto x, auto y) { return x - y; }, a, b);
}
template <typename Real>
inline Vector<Real> operator*(const Vector<Real>& a, const Vector<Real>& b) {
  return by_parts([](auto x, auto y) { return x * y; }, a, b);
}
template <typename Real>
inline Vector<Real> operator/(const Vector<Real>& a, const Vector<Real>& b) {
  return by_parts([](auto x, auto y) { return x / y; }, a, b);
}

inline float32x4_t square_root(float32x4_t a) {
  return vsqrtq_f32(a);
}
inline float64x2_t square_root(float64x2_t a) {
  return vsqrtq_f64(a);
}
template <typename Real>
inline Vector<Real> square_root(const Vector<Real>& a) {
  return by_parts([](auto x) { return square_root(x); }, a);
}

inline float32x4_t multiply_add(float32x4_t a, float32x4_t b, float32x4_t c) {
  return vfmaq_f32(c, a, b);
}
inline float64x2_t multiply_add(float64x2_t a, float64x2_t b, float64x2_t c) {
  return vfmaq_f64(c, a, b);
}
template <typename Real>
inline Vector<Real> multiply_add(const Vector<Real>& a, const Vector<Real>& b,
                                 const Vector<Real>& c) {
  return by_parts([](auto x, auto y, auto z) { return multiply_add(x, y, z); }, a, b, c);
}

inline float32x4_t magnitude(float32x4_t a) {
  return vabsq_f32(a);
}
inline float64x2_t magnitude(float64x2_t a) {
  return vabsq_f64(a);
}
template <typename Real>
inline Vector<Real> magnitude(const Vector<Real>& a) {
  return by_parts([](auto x) { return magnitude(x); }, a);
}

// a without the lanes of the mask.
inline float32x4_t cleared(float32x4_t a, uint32x4_t mask) {
  return vreinterpretq_f32_u32(vbicq_u32(bits_of(a), mask));
}
inline float64x2_t cleared(float64x2_t a, uint64x2_t mask) {
  return vreinterpretq_f64_u64(vbicq_u64(bits_of(a), mask));
}
inline float32x4_t zero_below(float32x4_t a, float32x4_t limit) {
  return cleared(a, vcltq_f32(magnitude(a), limit));
}
inline float64x2_t zero_below(float64x2_t a, float64x2_t limit) {
  return cleared(a, vcltq_f64(magnitude(a), limit));
}
template <typename Real>
inline Vector<Real> zero_below(const Vector<Real>& a, const Vector<Real>& limit) {
  return by_parts([](auto x, auto y) { return zero_below(x, y); }, a, limit);
}

inline Vector<float> greatest(const Vector<float>& a, const Vector<float>& b) {
  return by_parts([](auto x, auto y) { return vmaxq_f32(x, magnitude(y)); }, a, b);
}
// Not the instruction for the maximum, which changes the sign of zeros.
inline Vector<float> rectified(const Vector<float>& a) {
  return by_parts([](auto x) { return cleared(x, vcltzq_f32(x)); }, a);
}

inline Vector<double> widened(float32x4_t low, float32x4_t high) {
  return {{vcvt_f64_f32(vget_low_f32(low)), vcvt_high_f64_f32(low),
           vcvt_f64_f32(vget_low_f32(high)), vcvt_high_f64_f32(high)}};
}
inline Vector<double> lower_half(const Vector<float>& a) {
  return widened(a.parts[0], a.parts[1]);
}
inline Vector<double> upper_half(const Vector<float>& a) {
  return widened(a.parts[2], a.parts[3]);
}
inline float32x4_t narrowed(float64x2_t low, float64x2_t high) {
  return vcvt_high_f32_f64(vcvt_f32_f64(low), high);
}
inline void store_halves(const Vector<double>& low, const Vector<double>& high, float* to) {
  const Vector<float> both{
      {narrowed(low.parts[0], low.parts[1]), narrowed(low.parts[2], low.parts[3]),
       narrowed(high.parts[0], high.parts[1]), narrowed(high.parts[2], high.parts[3])}};
  both.store(to);
}
