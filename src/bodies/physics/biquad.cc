#include "bodies/physics/biquad.h"

#include "base/core/elementary.h"
#include "somato/core/check.h"

namespace somato::detail {
namespace {

struct Pole {
  double cosine;
  double bandwidth;
};

Pole pole_at(double frequency, double quality, double rate) {
  SOMATO_ASSERT(frequency > 0.0 && frequency < 0.5 * rate && quality > 0.0);
  const double turns = frequency / rate;
  const double sine = cosine_of_turns(turns - 0.25);
  return {cosine_of_turns(turns), sine / (2.0 * quality)};
}

}  // namespace

Biquad Biquad::low_pass(double frequency, double quality, double rate) {
  const Pole pole = pole_at(frequency, quality, rate);
  const double scale = 1.0 / (1.0 + pole.bandwidth);
  Biquad filter;
  filter.b0_ = scale * (1.0 - pole.cosine) / 2.0;
  filter.b1_ = 2.0 * filter.b0_;
  filter.a1_ = scale * -2.0 * pole.cosine;
  filter.a2_ = scale * (1.0 - pole.bandwidth);
  return filter;
}

Biquad Biquad::high_pass(double frequency, double quality, double rate) {
  const Pole pole = pole_at(frequency, quality, rate);
  const double scale = 1.0 / (1.0 + pole.bandwidth);
  Biquad filter = low_pass(frequency, quality, rate);
  filter.b0_ = scale * (1.0 + pole.cosine) / 2.0;
  filter.b1_ = -2.0 * filter.b0_;
  return filter;
}

std::vector<Biquad> butterworth_low_pass(double frequency, std::size_t sections, double rate) {
  std::vector<Biquad> filters;
  filters.reserve(sections);
  for (std::size_t i = 0; i < sections; ++i) {
    const double turns = static_cast<double>(2 * i + 1) / static_cast<double>(8 * sections);
    filters.push_back(Biquad::low_pass(frequency, 0.5 / cosine_of_turns(turns), rate));
  }
  return filters;
}

}  // namespace somato::detail
