#pragma once

#include <cstddef>
#include <memory>

#include "somato/core/samples.h"

namespace somato {

/// Samples that several maps are trained on or asked about, such as those of all folds and seeds of
/// a study. What such maps would all compute, the samples' inner products with each other, is
/// computed once, by the first that needs it. Copies share it, and threads may.
class KnownSamples {
 public:
  KnownSamples();
  explicit KnownSamples(Samples samples);

  std::size_t count() const { return samples().count(); }
  std::size_t size() const { return samples().size(); }

  /// As they were given.
  const Samples& samples() const;

 private:
  friend class KnownPreparation;
  struct Shared;
  std::shared_ptr<Shared> shared_;
};

}  // namespace somato
