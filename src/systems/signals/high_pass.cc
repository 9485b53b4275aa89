#include "systems/signals/high_pass.h"

#include <cmath>

#include "somato/core/check.h"

namespace somato {
namespace {

bool is_positive(double value) {
  return std::isfinite(value) && value > 0.0;
}

}  // namespace

const Declarations<HighPassParameters>& HighPassParameters::declarations() {
  using P = HighPassParameters;
  static const Declarations<P> kAll =
      Declarations<P>()
          .add("time_constant", &P::time_constant, "s", Range::between(1e-6, 1e6),
               "Time in which a step of the input decays to 37 %; drift over longer times is "
               "removed. Not in the papers.")
          .add("rate", &P::rate, "1/s", Range::between(1e-6, 1e9),
               "Frames per second; automatic: the rate of the channel in the first exploration of "
               "the recording that the system is trained on. Not in the papers.");
  return kAll;
}

// As T f / (T f + 1), which is the same.
HighPass::HighPass(std::size_t elements, double time_constant, double rate)
    : keep_(time_constant * rate / (time_constant * rate + 1.0)),
      before_(elements, 0.0),
      passed_(elements, 0.0) {
  require(is_positive(time_constant), "the time constant of a high-pass must be positive");
  require(is_positive(rate), "the frame rate of a high-pass must be positive");
}

void HighPass::step(std::span<float> frame) {
  require(frame.size() == before_.size(), "the sizes of the frame and of the high-pass differ");
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const double value{frame[i]};
    passed_[i] = has_frame_ ? keep_ * (passed_[i] + value - before_[i]) : 0.0;
    before_[i] = value;
    frame[i] = static_cast<float>(passed_[i]);
  }
  has_frame_ = true;
}

}  // namespace somato
