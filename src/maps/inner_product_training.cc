#include "maps/inner_product_training.h"

#include <numeric>
#include <utility>
#include <vector>

#include "maps/activity.h"
#include "maps/known_preparation.h"
#include "maps/product_answers.h"
#include "maps/product_problem.h"
#include "maps/product_state.h"
#include "maps/som_preparation.h"
#include "maps/stop.h"
#include "somato/core/check.h"

namespace somato {
namespace {

constexpr std::uint64_t kIterationsBetweenReports = 256;

std::vector<std::size_t> all_of(const Samples& samples) {
  std::vector<std::size_t> numbers(samples.count());
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

// The weights will be formed.
Result<std::shared_ptr<const ProductProblem>> problem_of(const SomParameters& parameters,
                                                         const KnownSamples& known,
                                                         std::size_t threads) {
  auto problem = ProductProblem::prepare(parameters, known, all_of(known.samples()), threads);
  if (!problem || *problem == nullptr) return problem;
  auto fits = check_memory((*problem)->parameters(), (*problem)->elements().count());
  if (!fits) return fail(std::move(fits.error()));
  return problem;
}

Result<void> train_online(ProductState& state, const Progress& progress) {
  const SomParameters& p = state.problem().parameters();
  const Schedule rate = p.learning_rate();
  const Schedule radius = p.radius();
  DrawSequence draws(p.draws, state.problem().training().size(), p.seed);
  const Stop stop(progress, *p.iterations, kIterationsBetweenReports);
  for (std::uint64_t t = 0; t < *p.iterations; ++t) {
    state.learn(draws.next(), rate.at(t), radius.at(t));
    if (stop.after(t + 1)) return Stop::error();
  }
  return {};
}

Result<void> train_batch(ProductState& state, const Progress& progress) {
  const SomParameters& p = state.problem().parameters();
  const Schedule radius = p.radius();
  const Stop stop(progress, p.epochs, 1);
  for (std::uint64_t epoch = 0; epoch < p.epochs; ++epoch) {
    state.learn_all(radius.at(epoch));
    if (stop.after(epoch + 1)) return Stop::error();
  }
  return {};
}

}  // namespace

Result<void> train_by_products(ProductState& state, const Progress& progress) {
  return state.problem().parameters().training == Training::kBatch ? train_batch(state, progress)
                                                                   : train_online(state, progress);
}

Result<std::optional<Som>> train_by_inner_products(const SomParameters& parameters,
                                                   const Samples& samples,
                                                   const TrainingOptions& options) {
  auto problem = problem_of(parameters, KnownPreparation::borrow(samples), options.threads);
  if (!problem) return fail(std::move(problem.error()));
  if (*problem == nullptr) return std::optional<Som>();
  ProductState state(std::move(*problem), options.threads);
  if (auto trained = train_by_products(state, options.progress); !trained) {
    return fail(std::move(trained.error()));
  }
  return std::optional<Som>(state.form(options.threads));
}

InnerProductLearner::InnerProductLearner(std::unique_ptr<ProductState> state)
    : state_(std::move(state)) {}

InnerProductLearner::~InnerProductLearner() = default;

Result<std::unique_ptr<InnerProductLearner>> InnerProductLearner::start(
    const SomParameters& parameters, Samples samples) {
  auto problem = problem_of(parameters, KnownSamples(std::move(samples)), 1);
  if (!problem) return fail(std::move(problem.error()));
  if (*problem == nullptr) return nullptr;
  return std::unique_ptr<InnerProductLearner>(
      new InnerProductLearner(std::make_unique<ProductState>(std::move(*problem), 1)));
}

const SomParameters& InnerProductLearner::parameters() const {
  return state_->problem().parameters();
}

std::size_t InnerProductLearner::samples() const {
  return state_->problem().training().size();
}

std::size_t InnerProductLearner::learn(std::size_t sample, double learning_rate, double radius) {
  require(sample < samples(), "there is no such sample to learn");
  return state_->learn(sample, learning_rate, radius);
}

void InnerProductLearner::activity(std::size_t sample, std::span<float> out) const {
  require(sample < samples() && out.size() == state_->neurons(),
          "an activity needs one of the samples, and room for a value a neuron");
  AlignedVector<double> products(state_->problem().padded());
  state_->products_with(sample, products);
  product_similarities(state_->problem(), sample, products, state_->squared_lengths(), out);
  activity_of_similarities(parameters(), out);
}

Som InnerProductLearner::form_som() const {
  return state_->form(1);
}

}  // namespace somato
