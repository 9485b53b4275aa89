#include "maps/training/som_start.h"

#include <memory>
#include <numeric>
#include <utility>

#include "maps/products/product_problem.h"
#include "maps/products/product_state.h"
#include "maps/products/product_weights.h"
#include "maps/som/initial_weights.h"
#include "maps/som/map_rows.h"
#include "maps/som/som_preparation.h"
#include "somato/core/check.h"

namespace somato {
namespace {

std::vector<std::size_t> every_one(const Samples& samples) {
  std::vector<std::size_t> numbers(samples.count());
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

// Only the stored elements: all others are 0 and remain 0.
Som initial_som(const PreparedTraining& prepared, std::size_t threads) {
  const InitialWeightsSource source(prepared.parameters, *prepared.samples, prepared.elements,
                                    threads);
  LaneMatrix<float> weights(prepared.parameters.grid().size(), prepared.samples->size());
  std::vector<float> row(prepared.samples->size());
  for (std::size_t neuron = 0; neuron < weights.rows(); ++neuron) {
    source.write(neuron, row);
    weights.set_row(neuron, row);
  }
  return Som(prepared.parameters, std::move(weights));
}

Result<SomStart> start_plain(const SomParameters& parameters, const Samples& samples,
                             std::size_t threads) {
  Samples storage;
  SOMATO_TRY(auto ready, prepare_training(parameters, samples, storage));
  return SomStart{initial_som(ready, threads), *ready.samples, every_one(samples),
                  std::move(ready.elements)};
}

// All elements are stored, because new samples may use others than those learned before.
Result<SomStart> start_from(const Som& trained, SomParameters parameters, const Samples& samples) {
  if (!trained.parameters().relevances.empty()) {
    return fail(ErrorKind::kUsage,
                "a map with relevances, which labels have refined, does not learn further", {},
                "train it anew with all samples");
  }
  parameters.arithmetic = Arithmetic::kPlain;
  Samples storage;
  SOMATO_TRY(const auto ready, prepare_training(parameters, samples, storage));
  require(
      trained.neurons() == ready.parameters.grid().size() && trained.input_size() == samples.size(),
      "training starts from a map of the same size");
  Som whole = trained;
  whole.store_all();
  Samples normalized;
  return SomStart{Som(ready.parameters, whole.weights()),
                  prepared_samples(ready.parameters, samples, normalized), every_one(samples),
                  StoredElements(samples.size())};
}

}  // namespace

Som SomStart::whole(Som trained) const {
  if (trained.products()) return trained;
  return Som(trained.parameters(), std::move(weights_to_change(trained)), elements);
}

Result<SomStart> start_som(const SomParameters& parameters, const Samples& samples,
                           const TrainingOptions& options) {
  std::vector<std::size_t> training = options.training.value_or(every_one(samples));
  if (options.start) {
    return start_from(*options.start, parameters,
                      options.training ? samples.subset(training) : samples);
  }
  SOMATO_TRY(auto problem, ProductProblem::prepare(parameters, samples, training, options.threads));
  if (problem == nullptr) {
    return start_plain(parameters, options.training ? samples.subset(training) : samples,
                       options.threads);
  }
  auto weights = std::make_shared<const ProductWeights>(
      samples, ProductState(std::move(problem), options.threads), options.threads);
  return SomStart{Som(std::move(weights)), samples, std::move(training), {}};
}

Result<Som> untrained_som(const SomParameters& parameters, const Samples& samples) {
  SOMATO_TRY(auto start, start_plain(parameters, samples, 1));
  return start.whole(std::move(start.som));
}

}  // namespace somato
