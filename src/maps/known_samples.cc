#include "somato/maps/known_samples.h"

#include <array>
#include <mutex>
#include <utility>

#include "maps/known_preparation.h"
#include "somato/maps/som_training.h"

namespace somato {

struct KnownSamples::Shared {
  std::shared_ptr<const Samples> samples;
  // As they are, and scaled to length 1.
  std::array<std::once_flag, 2> computed;
  std::array<std::shared_ptr<const SampleProducts>, 2> products;
};

KnownSamples::KnownSamples() : KnownSamples(Samples()) {}

KnownSamples::KnownSamples(Samples samples) : shared_(std::make_shared<Shared>()) {
  shared_->samples = std::make_shared<const Samples>(std::move(samples));
}

const Samples& KnownSamples::samples() const {
  return *shared_->samples;
}

KnownSamples KnownPreparation::borrow(const Samples& samples) {
  KnownSamples known;
  known.shared_->samples = std::shared_ptr<const Samples>(std::shared_ptr<void>(), &samples);
  return known;
}

std::shared_ptr<const SampleProducts> KnownPreparation::products(const KnownSamples& known,
                                                                 bool normalized,
                                                                 std::size_t threads) {
  KnownSamples::Shared& shared = *known.shared_;
  const std::size_t kind = normalized ? 1 : 0;
  std::call_once(shared.computed[kind], [&] {
    std::shared_ptr<const Samples> samples = shared.samples;
    if (normalized) {
      SomParameters parameters;
      parameters.normalize_input = true;
      auto scaled = std::make_shared<Samples>();
      prepared_samples(parameters, *samples, *scaled);
      samples = std::move(scaled);
    }
    shared.products[kind] = std::make_shared<const SampleProducts>(std::move(samples), threads);
  });
  return shared.products[kind];
}

}  // namespace somato
