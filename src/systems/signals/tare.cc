#include "systems/signals/tare.h"

#include "somato/core/check.h"

namespace somato {

const Declarations<TareParameters>& TareParameters::declarations() {
  using P = TareParameters;
  static const Declarations<P> kAll = Declarations<P>().add(
      "frames", &P::frames, "frames", Range::between(1, 1e9),
      "Number of frames at the start of an exploration whose mean is subtracted; before the last "
      "of them, the mean of the frames so far. Not in the papers.");
  return kAll;
}

Tare::Tare(std::size_t elements, const TareParameters& parameters)
    : most_(parameters.frames), sums_(elements, 0.0) {
  require(parameters.frames > 0, "a tare needs a frame");
}

void Tare::step(std::span<float> frame) {
  require(frame.size() == sums_.size(), "the sizes of the frame and of the tare differ");
  const bool is_counted = count_ < most_;
  if (is_counted) ++count_;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const double value{frame[i]};
    if (is_counted) sums_[i] += value;
    frame[i] = static_cast<float>(value - sums_[i] / static_cast<double>(count_));
  }
}

}  // namespace somato
