#include "somato/maps/product_som.h"

#include <algorithm>
#include <utility>

#include "maps/activity.h"
#include "maps/inner_product_training.h"
#include "maps/product_answers.h"
#include "maps/product_problem.h"
#include "maps/product_state.h"
#include "somato/core/check.h"

namespace somato {

struct ProductSom::State {
  State(KnownSamples samples, ProductState trained)
      : known(std::move(samples)),
        map(std::move(trained)),
        products(known.count() * map.problem().padded()) {
    for (std::size_t sample = 0; sample < known.count(); ++sample) {
      map.products_with(sample,
                        {&products[sample * map.problem().padded()], map.problem().padded()});
    }
  }

  const SomParameters& parameters() const { return map.problem().parameters(); }

  std::span<const double> products_with(std::size_t sample) const {
    require(sample < known.count(), "there is no such sample that the map could know");
    return {&products[sample * map.problem().padded()], map.neurons()};
  }

  // The less, the more similar.
  double score(double product, std::size_t neuron) const {
    return parameters().similarity == Similarity::kDotProduct
               ? -product
               : map.squared_lengths()[neuron] - 2.0 * product;
  }

  KnownSamples known;
  ProductState map;
  AlignedVector<double> products;  // known samples x padded neurons
};

const SomParameters& ProductSom::parameters() const {
  return state_->parameters();
}

std::size_t ProductSom::neurons() const {
  return state_->map.neurons();
}

const KnownSamples& ProductSom::known() const {
  return state_->known;
}

std::size_t ProductSom::winner(std::size_t sample) const {
  return winners(sample).first;
}

Winners ProductSom::winners(std::size_t sample) const {
  const auto products = state_->products_with(sample);
  if (products.size() == 1) return {};
  Winners winners{0, 1};
  double first = state_->score(products[0], 0);
  double second = state_->score(products[1], 1);
  if (second < first) {
    std::swap(winners.first, winners.second);
    std::swap(first, second);
  }
  for (std::size_t neuron = 2; neuron < products.size(); ++neuron) {
    const double score = state_->score(products[neuron], neuron);
    if (score < first) {
      winners = {neuron, winners.first};
      second = std::exchange(first, score);
    } else if (score < second) {
      winners.second = neuron;
      second = score;
    }
  }
  return winners;
}

std::size_t ProductSom::winner_among(std::span<const std::size_t> candidates,
                                     std::size_t sample) const {
  require(!candidates.empty(), "winner_among needs at least one candidate");
  const auto products = state_->products_with(sample);
  std::size_t best = candidates.front();
  for (const std::size_t neuron : candidates) {
    require(neuron < products.size(), "winner_among: no such neuron");
    if (state_->score(products[neuron], neuron) < state_->score(products[best], best)) {
      best = neuron;
    }
  }
  return best;
}

double ProductSom::squared_distance(std::size_t sample, std::size_t neuron) const {
  const auto products = state_->products_with(sample);
  require(neuron < products.size(), "there is no such neuron");
  return product_distance(state_->map.problem(), sample, products[neuron],
                          state_->map.squared_lengths()[neuron]);
}

void ProductSom::similarities(std::size_t sample, std::span<float> out) const {
  require(out.size() == neurons(), "similarities need room for a value a neuron");
  product_similarities(state_->map.problem(), sample, state_->products_with(sample),
                       state_->map.squared_lengths(), out);
}

void ProductSom::activity(std::size_t sample, std::span<float> out) const {
  similarities(sample, out);
  activity_of_similarities(parameters(), out);
}

Som ProductSom::form_som(std::size_t threads) const {
  return state_->map.form(threads);
}

Result<std::optional<ProductSom>> train_product_som(const SomParameters& parameters,
                                                    const KnownSamples& known,
                                                    const std::vector<std::size_t>& training,
                                                    const TrainingOptions& options) {
  require(std::all_of(training.begin(), training.end(),
                      [&](std::size_t sample) { return sample < known.count(); }),
          "there is no such sample to train on");
  auto problem = ProductProblem::prepare(parameters, known, training, options.threads);
  if (!problem) return fail(std::move(problem.error()));
  if (*problem == nullptr) return std::optional<ProductSom>();
  ProductState state(std::move(*problem), options.threads);
  if (auto trained = train_by_products(state, options.progress); !trained) {
    return fail(std::move(trained.error()));
  }
  ProductSom map;
  map.state_ = std::make_shared<const ProductSom::State>(known, std::move(state));
  return std::optional<ProductSom>(std::move(map));
}

}  // namespace somato
