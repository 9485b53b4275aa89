#include "somato/maps/known_samples.h"

#include <utility>

namespace somato {

struct KnownSamples::Shared {
  Samples samples;
};

KnownSamples::KnownSamples() : KnownSamples(Samples()) {}

KnownSamples::KnownSamples(Samples samples) : shared_(std::make_shared<Shared>()) {
  shared_->samples = std::move(samples);
}

const Samples& KnownSamples::samples() const {
  return shared_->samples;
}

}  // namespace somato
