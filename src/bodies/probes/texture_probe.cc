#include "bodies/probes/texture_probe.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/core/elementary.h"
#include "bodies/physics/biquad.h"
#include "bodies/physics/surface.h"
#include "bodies/probes/probe_body.h"
#include "bodies/sensors/microphone.h"
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
       const detail::StrokeDraws& draws)
      : surface_(material, parameters.edge_width, world_seed),
        resonance_(make_edge(material, parameters)),
        gain_(1e-3 * material.friction * grip(material, parameters) * tick_rate(parameters)),
        mm_per_degree_(parameters.lever_radius * std::numbers::pi / 180.0),
        start_(parameters.placement_noise * draws.start),
        across_(parameters.placement_noise * draws.across),
        height_(height_at(0.0)) {}

  // The velocity of the edge, mm/s, one tick after the last call.
  double move_to(double degrees) {
    const double before = height_;
    if (degrees != degrees_) height_ = height_at(degrees);
    degrees_ = degrees;
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
  double degrees_ = 0.0;
  double height_;  // at that angle
};

// The sound of the servo in motion.
class Whine {
 public:
  Whine(const TextureProbeParameters& parameters, const detail::StrokeDraws& draws)
      : turns_per_tick_(parameters.servo_tone * (1.0 + parameters.servo_tone_spread * draws.tone) /
                        tick_rate(parameters)),
        turns_(draws.turns) {}

  // The sound of the next tick, as a multiple of its root mean square.
  double next() {
    turns_ += turns_per_tick_;
    turns_ -= std::floor(turns_);
    double sum = 0.0;
    for (int n = 1; n <= kHarmonics; ++n) sum += cosine_of_turns(n * turns_) / n;
    return std::sqrt(2.0 / kHarmonicSquares) * sum;
  }

 private:
  double turns_per_tick_;
  double turns_;
};

// The part of a signal that the microphone and its filter pass.
class Band {
 public:
  explicit Band(const TextureProbeParameters& parameters)
      : low_end_(detail::Biquad::high_pass(parameters.microphone_low, kMicrophoneQuality,
                                           tick_rate(parameters))),
        anti_aliasing_(detail::butterworth_low_pass(kAntiAliasingCutoff * parameters.sample_rate,
                                                    kAntiAliasingSections, tick_rate(parameters))) {
  }

  double operator()(double signal) {
    signal = low_end_(signal);
    for (detail::Biquad& section : anti_aliasing_) signal = section(signal);
    return signal;
  }

 private:
  detail::Biquad low_end_;
  std::vector<detail::Biquad> anti_aliasing_;
};

class TextureProbe : public detail::ProbeBody {
 public:
  TextureProbe(const Material& material, const TextureProbeParameters& parameters,
               const ProbeSeeds& seeds, detail::SoundTruth* truth)
      : ProbeBody("texture_probe", {"lever", "deg", 0.0, parameters.stroke, parameters.lever_speed},
                  {"sound", "counts", {}, {}, parameters.sample_rate, true}, tick_rate(parameters)),
        random_(seeds.exploration, Stream::kTextureProbe),
        draws_(detail::draw_stroke(random_)),
        edge_(material, parameters, seeds.world, draws_),
        whine_(parameters, draws_),
        ticks_per_frame_(parameters.oversampling),
        edge_band_(parameters),
        servo_band_(parameters),
        microphone_(parameters, parameters.sample_rate, seeds.exploration),
        truth_(truth) {}

 protected:
  void tick() override {
    const bool moves = is_driven();
    const double edge = edge_.move_to(drive());
    const detail::TrueSound sound{edge_band_(edge), servo_band_(moves ? whine_.next() : 0.0)};
    if (++ticks_ < ticks_per_frame_) return;
    ticks_ = 0;
    frames_.push_back(microphone_.read(sound, random_));
    if (truth_ != nullptr) truth_->hear(sound);
  }

  Matrix<float> read() override {
    const std::size_t count = frames_.size();
    return Matrix<float>(count, 1, std::exchange(frames_, {}));
  }

 private:
  Random random_;  // placement and tone of the servo first, then noise as it comes
  detail::StrokeDraws draws_;
  Edge edge_;
  Whine whine_;
  std::size_t ticks_per_frame_;
  std::size_t ticks_ = 0;
  Band edge_band_;
  Band servo_band_;
  detail::Microphone microphone_;
  detail::SoundTruth* truth_;
  std::vector<float> frames_;  // recorded during the current step
};

}  // namespace

Result<std::unique_ptr<Body>> make_texture_probe(const Material& material,
                                                 const TextureProbeParameters& parameters,
                                                 const ProbeSeeds& seeds,
                                                 detail::SoundTruth* truth) {
  SOMATO_TRY_VOID(material.validate());
  SOMATO_TRY_VOID(parameters.validate());
  return std::make_unique<TextureProbe>(material, parameters, seeds, truth);
}

}  // namespace somato
