#include "somato/simulation/simulation_parameters.h"

namespace somato {
namespace {

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
  d.add("potentiometer_path", &P::potentiometer_path, "mm", Range::between(0.1, 1e4),
        "Path of the stick that the bits of the potentiometer cover; automatic: the stroke. Not "
        "given in the paper.");
  d.add("potentiometer_offset", &P::potentiometer_offset, "", Range::between(0, 1),
        "Reading of the stick at 0, as a share of the range of the potentiometer. Not given in the "
        "paper.");
  d.add("press_spread", &P::press_spread, "mm", Range::between(0, 100),
        "Standard deviation, between explorations, of the difference of the potentiometer from the "
        "stick, constant during a press, as with play and dead band of a servo; 0: none. Not given "
        "in the paper.");
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

}  // namespace somato
