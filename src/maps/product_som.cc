#include "somato/maps/product_som.h"

#include <algorithm>
#include <utility>

#include "somato/core/check.h"

namespace somato {

struct ProductSom::State {
  KnownSamples known;
  Som som;
};

const SomParameters& ProductSom::parameters() const {
  return state_->som.parameters();
}

std::size_t ProductSom::neurons() const {
  return state_->som.neurons();
}

const KnownSamples& ProductSom::known() const {
  return state_->known;
}

std::size_t ProductSom::winner(std::size_t sample) const {
  SomWorkspace workspace;
  return state_->som.winner(state_->known.samples()[sample], workspace);
}

Winners ProductSom::winners(std::size_t sample) const {
  SomWorkspace workspace;
  return state_->som.winners(state_->known.samples()[sample], workspace);
}

std::size_t ProductSom::winner_among(std::span<const std::size_t> candidates,
                                     std::size_t sample) const {
  SomWorkspace workspace;
  return state_->som.winner_among(candidates, state_->known.samples()[sample], workspace);
}

double ProductSom::squared_distance(std::size_t sample, std::size_t neuron) const {
  SomWorkspace workspace;
  const double distance = state_->som.distance(state_->known.samples()[sample], neuron, workspace);
  return distance * distance;
}

void ProductSom::similarities(std::size_t sample, std::span<float> out) const {
  SomWorkspace workspace;
  state_->som.similarities(state_->known.samples()[sample], workspace, out);
}

void ProductSom::activity(std::size_t sample, std::span<float> out) const {
  SomWorkspace workspace;
  state_->som.activity(state_->known.samples()[sample], workspace, out);
}

Som ProductSom::form_som(std::size_t /*threads*/) const {
  return state_->som;
}

Result<std::optional<ProductSom>> train_product_som(const SomParameters& parameters,
                                                    const KnownSamples& known,
                                                    const std::vector<std::size_t>& training,
                                                    const TrainingOptions& options) {
  require(std::all_of(training.begin(), training.end(),
                      [&](std::size_t sample) { return sample < known.count(); }),
          "there is no such sample to train on");
  auto resolved = resolve(parameters, training.size(), known.size());
  if (!resolved) return fail(std::move(resolved.error()));
  if (resolved->arithmetic != Arithmetic::kInnerProducts) return std::optional<ProductSom>();
  auto som = train_som(parameters, known.samples().subset(training), options);
  if (!som) return fail(std::move(som.error()));
  ProductSom map;
  map.state_ = std::make_shared<const ProductSom::State>(ProductSom::State{known, std::move(*som)});
  return std::optional<ProductSom>(std::move(map));
}

}  // namespace somato
