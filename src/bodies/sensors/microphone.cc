#include "bodies/sensors/microphone.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/core/elementary.h"

namespace somato::detail {

RoomSound::RoomSound(double cutoff, double rate, std::uint64_t seed)
    : kept_(exponential(-2.0 * std::numbers::pi * cutoff / rate)),
      fresh_(std::sqrt(1.0 - kept_ * kept_)),
      random_(seed, Stream::kNoise) {
  value_ = random_.normal();
}

double RoomSound::next() {
  const double value = value_;
  value_ = kept_ * value_ + fresh_ * random_.normal();
  return value;
}

Microphone::Microphone(const TextureProbeParameters& parameters, double rate, std::uint64_t seed)
    : sensitivity_(parameters.sensitivity),
      servo_(parameters.servo_noise),
      noise_(parameters.microphone_noise),
      ambient_(parameters.ambient_sound),
      room_(parameters.ambient_cutoff, rate, seed),
      most_(static_cast<double>(std::size_t{1} << (parameters.adc_bits - 1))),
      step_(parameters.adc_range / most_) {}

float Microphone::read(const TrueSound& sound, Random& noise) {
  double millivolts = sensitivity_ * sound.edge + servo_ * sound.servo;
  if (ambient_ > 0.0) millivolts += ambient_ * room_.next();
  return counts(millivolts + noise_ * noise.normal());
}

void Microphone::skip(std::uint64_t frames, Random& noise) {
  for (std::uint64_t i = 0; i < frames; ++i) {
    static_cast<void>(noise.normal());
    if (ambient_ > 0.0) static_cast<void>(room_.next());
  }
}

float Microphone::counts(double millivolts) const {
  return static_cast<float>(std::clamp(std::round(millivolts / step_), -most_, most_ - 1.0));
}

StrokeDraws draw_stroke(Random& random) {
  StrokeDraws draws;
  draws.start = random.normal();
  draws.across = random.normal();
  draws.tone = random.normal();
  draws.turns = random.uniform();
  return draws;
}

}  // namespace somato::detail
