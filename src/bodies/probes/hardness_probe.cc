#include "bodies/probes/hardness_probe.h"

#include <algorithm>
#include <cmath>

#include "base/core/elementary.h"
#include "bodies/probes/probe_body.h"
#include "bodies/sensors/potentiometer.h"
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

class HardnessProbe : public detail::ProbeBody {
 public:
  HardnessProbe(const Material& material, const HardnessProbeParameters& parameters,
                std::uint64_t exploration_seed, detail::StickTruth* truth)
      : ProbeBody("hardness_probe", {"stick", "mm", 0.0, parameters.stroke, parameters.stick_speed},
                  {"potentiometer", "counts", {}, {}, 0.0, true}, kTickRate),
        random_(exploration_seed, Stream::kHardnessProbe),
        stick_(material, parameters,
               parameters.force * (1.0 + parameters.force_noise * detail::draw_press(random_))),
        potentiometer_(parameters, exploration_seed),
        truth_(truth) {}

 protected:
  void tick() override {
    stick_.follow(drive());
    deviation_ = random_.normal();
    ++ticks_;
  }

  Matrix<float> read() override {
    if (truth_ != nullptr) *truth_ = {stick_.position(), ticks_};
    return Matrix<float>(1, 1, potentiometer_.read(stick_.position(), deviation_));
  }

 private:
  Random random_;  // force first, then noise as it comes
  Stick stick_;
  detail::Potentiometer potentiometer_;
  detail::StickTruth* truth_;
  double deviation_ = 0.0;  // of the potentiometer, as a multiple of its noise
  std::uint64_t ticks_ = 0;
};

}  // namespace

Result<std::unique_ptr<Body>> make_hardness_probe(const Material& material,
                                                  const HardnessProbeParameters& parameters,
                                                  std::uint64_t exploration_seed,
                                                  detail::StickTruth* truth) {
  SOMATO_TRY_VOID(material.validate());
  SOMATO_TRY_VOID(parameters.validate());
  return std::make_unique<HardnessProbe>(material, parameters, exploration_seed, truth);
}

}  // namespace somato
