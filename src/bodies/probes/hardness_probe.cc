#include "bodies/probes/hardness_probe.h"

#include <algorithm>
#include <cmath>

#include "base/core/elementary.h"
#include "bodies/probes/probe_body.h"
#include "somato/core/random.h"

namespace somato {
namespace {

constexpr double kTickRate = 1000.0;  // Hz

// A stick on a servo that is too weak to hold it against the material.
class Stick {
 public:
  Stick(const Material& material, const HardnessProbeParameters& parameters, double force)
      : clearance_(parameters.clearance),
        balance_(parameters.clearance + force / material.stiffness),
        mm_per_tick_(parameters.stick_speed / kTickRate),
        // A servo slows down in proportion to its load: it approaches the balance exponentially,
        // from the full speed at first touch.
        decay_(exponential(-mm_per_tick_ * material.stiffness / force)) {}

  // Towards where the servo has been driven; mm.
  double follow(double driven) {
    const double free = std::min(position_ + mm_per_tick_, clearance_);
    const double pressing = balance_ + (position_ - balance_) * decay_;
    position_ = std::min(driven, position_ < clearance_ ? free : pressing);
    return position_;
  }

  double position() const { return position_; }

 private:
  double clearance_;
  double balance_;
  double mm_per_tick_;
  double decay_;
  double position_ = 0.0;
};

double most_counts(const HardnessProbeParameters& parameters) {
  return static_cast<double>((std::size_t{1} << parameters.potentiometer_bits) - 1);
}

// From mm to counts.
class Potentiometer {
 public:
  explicit Potentiometer(const HardnessProbeParameters& parameters)
      : most_(most_counts(parameters)), counts_per_mm_(most_ / parameters.stroke) {}

  float operator()(double position) const {
    return static_cast<float>(std::clamp(std::round(position * counts_per_mm_), 0.0, most_));
  }

 private:
  double most_;
  double counts_per_mm_;
};

class HardnessProbe : public detail::ProbeBody {
 public:
  HardnessProbe(const Material& material, const HardnessProbeParameters& parameters,
                std::uint64_t exploration_seed)
      : ProbeBody("hardness_probe", {"stick", "mm", 0.0, parameters.stroke, parameters.stick_speed},
                  {"potentiometer", "counts", {}, {}, 0.0, true}, kTickRate),
        random_(exploration_seed, Stream::kHardnessProbe),
        stick_(material, parameters,
               parameters.force * (1.0 + parameters.force_noise * random_.normal())),
        potentiometer_(parameters),
        noise_(parameters.potentiometer_noise) {}

 protected:
  void tick() override {
    stick_.follow(drive());
    deviation_ = noise_ * random_.normal();
  }

  Matrix<float> read() override {
    return Matrix<float>(1, 1, potentiometer_(stick_.position() + deviation_));
  }

 private:
  Random random_;  // force first, then noise as it comes
  Stick stick_;
  Potentiometer potentiometer_;
  double noise_;
  double deviation_ = 0.0;  // of the potentiometer, mm
};

void declare_stick(Declarations<HardnessProbeParameters>& d) {
  using P = HardnessProbeParameters;
  d.add("stroke", &P::stroke, "mm", Range::between(0.1, 1000),
        "Stroke of the stick. Not given in the paper.");
  d.add("stick_speed", &P::stick_speed, "mm/s", Range::between(0.001, 1e4),
        "Speed of the stick without load. Not given in the paper.");
  d.add("clearance", &P::clearance, "mm", Range::between(0, 1000),
        "Distance of the material from the stick at 0. Not given in the paper.");
  d.add("force", &P::force, "N", Range::between(1e-6, 1e6),
        "Force of the stick; P11 states that it is constant; the value is not given in the paper.");
  d.add(
      "force_noise", &P::force_noise, "", Range::between(0, 0.05),
      "Standard deviation of the force between explorations, as a share. Not given in the paper.");
}

void declare_potentiometer(Declarations<HardnessProbeParameters>& d) {
  using P = HardnessProbeParameters;
  d.add("potentiometer_bits", &P::potentiometer_bits, "bits", Range::between(1, 24),
        "Bits of a reading over the stroke; 18 in P11.");
  d.add("potentiometer_noise", &P::potentiometer_noise, "mm", Range::between(0, 1000),
        "Standard deviation of a reading. Not given in the paper.");
}

}  // namespace

const Declarations<HardnessProbeParameters>& HardnessProbeParameters::declarations() {
  static const Declarations<HardnessProbeParameters> kAll = [] {
    Declarations<HardnessProbeParameters> d;
    declare_stick(d);
    declare_potentiometer(d);
    return d;
  }();
  return kAll;
}

Result<void> HardnessProbeParameters::validate() const {
  SOMATO_TRY_VOID(check_ranges(*this));
  if (clearance < stroke) return {};
  return fail(ErrorKind::kUsage,
              "the stick does not reach the material, because 'clearance' is not below 'stroke'",
              {}, "lower 'clearance', or raise 'stroke'");
}

std::optional<double> stick_position(double counts, const HardnessProbeParameters& parameters) {
  const double share = counts / most_counts(parameters);
  if (share >= 0.0 && share <= 1.0) return share * parameters.stroke;
  return {};
}

Result<std::unique_ptr<Body>> make_hardness_probe(const Material& material,
                                                  const HardnessProbeParameters& parameters,
                                                  std::uint64_t exploration_seed) {
  SOMATO_TRY_VOID(material.validate());
  SOMATO_TRY_VOID(parameters.validate());
  return std::make_unique<HardnessProbe>(material, parameters, exploration_seed);
}

}  // namespace somato
