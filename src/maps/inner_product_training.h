#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "maps/som_preparation.h"
#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/maps/som.h"
#include "somato/maps/som_training.h"

namespace somato {

class InnerProductTrainer;

/// Online training on inner products. Returns a map of the stored elements alone. See the source
/// for the mathematics.
Result<Som> train_by_inner_products(const PreparedTraining& prepared,
                                    const TrainingOptions& options);

/// Learns known samples one at a time by inner products, as SomLearner learns any. Its weights
/// are formed when they are asked for; what they make of a sample is known throughout.
class InnerProductLearner {
 public:
  InnerProductLearner(const InnerProductLearner&) = delete;
  InnerProductLearner(InnerProductLearner&&) = delete;
  InnerProductLearner& operator=(const InnerProductLearner&) = delete;
  InnerProductLearner& operator=(InnerProductLearner&&) = delete;
  ~InnerProductLearner();

  /// A map that has learned nothing yet, or nullptr where these parameters and samples are for
  /// plain arithmetic (see resolve()). Fails as untrained_som() does.
  static Result<std::unique_ptr<InnerProductLearner>> start(const SomParameters& parameters,
                                                            Samples samples);

  /// As the map will have them.
  const SomParameters& parameters() const { return prepared_.parameters; }

  /// As SomLearner::learn() with sample number `sample`.
  std::size_t learn(std::size_t sample, double learning_rate, double radius);

  /// As Som::activity() for sample number `sample`.
  void activity(std::size_t sample, std::span<float> out) const;

  /// The map as it is now.
  Som form_som() const;

 private:
  InnerProductLearner() = default;

  Samples samples_;
  Samples storage_;
  PreparedTraining prepared_;
  std::unique_ptr<InnerProductTrainer> trainer_;
};

}  // namespace somato
