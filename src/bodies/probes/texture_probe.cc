#include "bodies/probes/texture_probe.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/core/elementary.h"
#include "bodies/physics/biquad.h"
#include "bodies/physics/surface.h"
#include "bodies/probes/probe_body.h"
#include "somato/core/random.h"

namespace somato {
namespace {

constexpr int kHarmonics = 4;  // of the servo's whine, the n-th with an n-th of the amplitude
constexpr double kHarmonicSquares = 1.0 + 1.0 / 4.0 + 1.0 / 9.0 + 1.0 / 16.0;
constexpr double kMicrophoneQuality = std::numbers::sqrt2 / 2.0;  // no peak at its lower end
constexpr std::size_t kAntiAliasingSections = 4;
constexpr double kAntiAliasingCutoff = 0.4;  // of the sample rate

double tick_rate(const TextureProbeParameters& parameters) {
  return parameters.sample_rate * static_cast<double>(parameters.oversampling);
}

// The share of a surface's height that moves the edge; the rest is pressed into the material.
double grip(const Material& material, const TextureProbeParameters& parameters) {
  return material.stiffness / (material.stiffness + parameters.edge_stiffness);
}

detail::Biquad make_edge(const Material& material, const TextureProbeParameters& parameters) {
  const double rise = 1.0 + parameters.resonance_rise * grip(material, parameters);
  const double damping = parameters.edge_damping + 0.5 * material.loss;
  return detail::Biquad::low_pass(parameters.edge_resonance * std::sqrt(rise), 0.5 / damping,
                                  tick_rate(parameters));
}

// The edge on the surface, led along an arc.
class Edge {
 public:
  Edge(const Material& material, const TextureProbeParameters& parameters, std::uint64_t world_seed,
       Random& random)
      : surface_(material, parameters.edge_width, world_seed),
        resonance_(make_edge(material, parameters)),
        gain_(1e-3 * material.friction * grip(material, parameters) * tick_rate(parameters)),
        mm_per_degree_(parameters.lever_radius * std::numbers::pi / 180.0),
        start_(parameters.placement_noise * random.normal()),
        across_(parameters.placement_noise * random.normal()),
        height_(height_at(0.0)) {}

  // The velocity of the edge, mm/s, one tick after the last call.
  double move_to(double degrees) {
    const double before = height_;
    height_ = height_at(degrees);
    return resonance_(gain_ * (height_ - before));
  }

 private:
  double height_at(double degrees) {
    return surface_.height(start_ + mm_per_degree_ * degrees, across_);
  }

  detail::Surface surface_;
  detail::Biquad resonance_;
  double gain_;  // from um a tick to mm/s
  double mm_per_degree_;
  double start_;
  double across_;
  double height_;
};

// The sound of the servo in motion.
class Whine {
 public:
  Whine(const TextureProbeParameters& parameters, Random& random)
      : amplitude_(parameters.servo_noise * std::sqrt(2.0 / kHarmonicSquares)),
        turns_per_tick_(parameters.servo_tone *
                        (1.0 + parameters.servo_tone_spread * random.normal()) /
                        tick_rate(parameters)),
        turns_(random.uniform()) {}

  // mV, of the next tick.
  double next() {
    turns_ += turns_per_tick_;
    turns_ -= std::floor(turns_);
    double sum = 0.0;
    for (int n = 1; n <= kHarmonics; ++n) sum += cosine_of_turns(n * turns_) / n;
    return amplitude_ * sum;
  }

 private:
  double amplitude_;
  double turns_per_tick_;
  double turns_;
};

// From mV to counts.
class SoundConverter {
 public:
  explicit SoundConverter(const TextureProbeParameters& parameters)
      : most_(static_cast<double>(std::size_t{1} << (parameters.adc_bits - 1))),
        step_(parameters.adc_range / most_) {}

  float operator()(double millivolts) const {
    return static_cast<float>(std::clamp(std::round(millivolts / step_), -most_, most_ - 1.0));
  }

 private:
  double most_;
  double step_;
};

// Converts the motion of the edge to counts, one frame per given number of ticks.
class Microphone {
 public:
  Microphone(const TextureProbeParameters& parameters, Random& random)
      : sensitivity_(parameters.sensitivity),
        noise_(parameters.microphone_noise),
        ticks_per_frame_(parameters.oversampling),
        low_end_(detail::Biquad::high_pass(parameters.microphone_low, kMicrophoneQuality,
                                           tick_rate(parameters))),
        anti_aliasing_(detail::butterworth_low_pass(kAntiAliasingCutoff * parameters.sample_rate,
                                                    kAntiAliasingSections, tick_rate(parameters))),
        convert_(parameters),
        random_(random) {}

  void record(double edge, double whine, std::vector<float>& frames) {
    double signal = low_end_(sensitivity_ * edge + whine);
    for (detail::Biquad& section : anti_aliasing_) signal = section(signal);
    if (++ticks_ < ticks_per_frame_) return;
    ticks_ = 0;
    frames.push_back(convert_(signal + noise_ * random_.normal()));
  }

 private:
  double sensitivity_;
  double noise_;
  std::size_t ticks_per_frame_;
  std::size_t ticks_ = 0;
  detail::Biquad low_end_;
  std::vector<detail::Biquad> anti_aliasing_;
  SoundConverter convert_;
  Random& random_;
};

class TextureProbe : public detail::ProbeBody {
 public:
  TextureProbe(const Material& material, const TextureProbeParameters& parameters,
               const ProbeSeeds& seeds)
      : ProbeBody("texture_probe", {"lever", "deg", 0.0, parameters.stroke, parameters.lever_speed},
                  {"sound", "counts", {}, {}, parameters.sample_rate, true}, tick_rate(parameters)),
        random_(seeds.exploration, Stream::kTextureProbe),
        edge_(material, parameters, seeds.world, random_),
        whine_(parameters, random_),
        microphone_(parameters, random_) {}

 protected:
  void tick() override {
    const bool moves = is_driven();
    const double edge = edge_.move_to(drive());
    microphone_.record(edge, moves ? whine_.next() : 0.0, frames_);
  }

  Matrix<float> read() override {
    const std::size_t count = frames_.size();
    return Matrix<float>(count, 1, std::exchange(frames_, {}));
  }

 private:
  Random random_;  // placement first, then the servo, then noise as it comes
  Edge edge_;
  Whine whine_;
  Microphone microphone_;
  std::vector<float> frames_;  // recorded during the current step
};

}  // namespace

Result<std::unique_ptr<Body>> make_texture_probe(const Material& material,
                                                 const TextureProbeParameters& parameters,
                                                 const ProbeSeeds& seeds) {
  SOMATO_TRY_VOID(material.validate());
  SOMATO_TRY_VOID(parameters.validate());
  return std::make_unique<TextureProbe>(material, parameters, seeds);
}

}  // namespace somato
