#include "somato/maps/som_training.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/lanes.h"
#include "maps/inner_product_training.h"
#include "maps/som_preparation.h"
#include "maps/stop.h"
#include "somato/core/check.h"
#include "somato/core/threads.h"
#include "somato/maps/initial_weights.h"

namespace somato {
namespace {

constexpr std::uint64_t kIterationsBetweenReports = 64;
constexpr std::uint64_t kWeightsBetweenReports = std::uint64_t{1} << 26;

// Fewer on a large map: whoever asks it to stop does not want to wait.
std::uint64_t iterations_between_reports(const Som& som) {
  const std::uint64_t weights = std::uint64_t{som.neurons()} * som.elements().count();
  return std::clamp<std::uint64_t>(kWeightsBetweenReports / weights, 1, kIterationsBetweenReports);
}

// Weights of elements that are mostly zero decay until they are slow to compute with; their squares
// have left the range of single precision long before.
constexpr std::uint64_t kIterationsBetweenClearings = 64;

// Of the stored elements alone: everything else is 0 and stays 0.
Som initial_som(const PreparedTraining& prepared) {
  const InitialWeightsSource source(prepared.parameters, *prepared.samples, prepared.elements);
  LaneMatrix<float> weights(prepared.parameters.grid().size(), prepared.samples->size());
  std::vector<float> row(prepared.samples->size());
  for (std::size_t neuron = 0; neuron < weights.rows(); ++neuron) {
    source.write(neuron, row);
    weights.set_row(neuron, row);
  }
  return Som(prepared.parameters, std::move(weights));
}

// A map of stored elements as one of whole inputs.
Som of_whole_inputs(Som som, const StoredElements& elements) {
  return Som(som.parameters(), std::move(som.weights()), elements);
}

// Scales every row to length 1; rows of zeros stay.
void normalize_rows(LaneMatrix<float>& weights, AlignedVector<float>& factors) {
  factors.resize(weights.padded_rows());
  const auto& kernels = kernels::table<float>();
  kernels.squared_norms(kernels::lanes(std::as_const(weights)), factors.data());
  for (float& factor : factors) factor = factor > 0.0F ? 1.0F / std::sqrt(factor) : 1.0F;
  kernels.scale_rows(kernels::lanes(weights), factors.data());
}

Result<void> train_online(Som& som, const Samples& prepared, const Progress& progress) {
  const SomParameters& p = som.parameters();
  DrawSequence draws(p.draws, prepared.count(), p.seed);
  SomLearner learner(som);
  const Stop stop(progress, *p.iterations, iterations_between_reports(som));
  for (std::uint64_t t = 0; t < *p.iterations; ++t) {
    learner.learn(prepared[draws.next()], p.learning_rate().at(t), p.radius().at(t));
    if (stop.after(t + 1)) return Stop::error();
  }
  return {};
}

Result<void> train_batch(Som& som, const Samples& prepared, const TrainingOptions& options) {
  const SomParameters& p = som.parameters();
  const Stop stop(options.progress, p.epochs, 1);
  for (std::uint64_t epoch = 0; epoch < p.epochs; ++epoch) {
    batch_epoch(som, prepared, p.radius().at(epoch), options.threads);
    if (stop.after(epoch + 1)) return Stop::error();
  }
  return {};
}

Result<void> train_in_place(Som& som, const Samples& prepared, const TrainingOptions& options) {
  return som.parameters().training == Training::kBatch
             ? train_batch(som, prepared, options)
             : train_online(som, prepared, options.progress);
}

bool has_weights_for(const Som& som, const Samples& samples) {
  if (som.elements().all()) return true;
  std::vector<float> stored(som.elements().count());
  for (std::size_t i = 0; i < samples.count(); ++i) {
    if (som.elements().gather(samples[i], stored) > 0.0) return false;
  }
  return true;
}

// Sums of the samples by winner, and how many there are: double precision, in the samples' order.
struct WinnerSums {
  Matrix<double> sums;
  std::vector<double> counts;
};

WinnerSums sum_by_winner(const Som& som, const Samples& samples,
                         const std::vector<std::size_t>& winners) {
  WinnerSums result{Matrix<double>(som.neurons(), som.elements().count()),
                    std::vector<double>(som.neurons())};
  std::vector<float> input(som.elements().count());
  for (std::size_t i = 0; i < samples.count(); ++i) {
    som.elements().gather(samples[i], input);
    const auto sum = result.sums.row(winners[i]);
    for (std::size_t d = 0; d < input.size(); ++d) sum[d] += double{input[d]};
    result.counts[winners[i]] += 1.0;
  }
  return result;
}

// The weighted mean for one neuron; the neighbourhood is symmetric, so it is taken around it.
void move_to_mean(Som& som, std::size_t neuron, const WinnerSums& sums,
                  std::span<const double> gains, std::vector<double>& mean) {
  double total = 0.0;
  std::fill(mean.begin(), mean.end(), 0.0);
  for (std::size_t winner = 0; winner < gains.size(); ++winner) {
    if (sums.counts[winner] == 0.0 || gains[winner] == 0.0) continue;
    total = std::fma(gains[winner], sums.counts[winner], total);
    kernels::table<double>().add_scaled(sums.sums.row(winner).data(), gains[winner], mean.size(),
                                        mean.data());
  }
  if (total == 0.0) return;
  for (std::size_t d = 0; d < mean.size(); ++d) {
    som.weights()(neuron, d) = static_cast<float>(mean[d] / total);
  }
}

}  // namespace

SomLearner::SomLearner(Som& som)
    : som_(som),
      neighbourhood_(som.grid(), som.parameters().neighbourhood),
      gains_(som.weights().padded_rows()) {}

std::size_t SomLearner::learn(const SignalView& input, double learning_rate, double radius) {
  std::span<const float> seen = som_.prepare(input, workspace_);
  if (workspace_.left_out_ > 0.0) {
    som_.store_all();
    seen = som_.prepare(input, workspace_);
  }
  const std::size_t winner = som_.winner_of(seen, workspace_);
  neighbourhood_.around(winner, radius, gains_);
  const auto rate = static_cast<float>(learning_rate);
  for (float& gain : gains_) gain *= rate;
  kernels::table<float>().move_towards(kernels::lanes(som_.weights()), seen.data(), gains_.data());
  if (som_.parameters().similarity == Similarity::kDotProduct) {
    normalize_rows(som_.weights(), factors_);
  }
  if (++learned_ % kIterationsBetweenClearings == 0) {
    kernels::table<float>().clear_negligible(kernels::lanes(som_.weights()));
  }
  return winner;
}

std::vector<std::size_t> winners_of(const Som& som, const Samples& samples, std::size_t threads) {
  std::vector<std::size_t> winners(samples.count());
  for_each_range(samples.count(), threads, [&](std::size_t begin, std::size_t end) {
    SomWorkspace workspace;
    for (std::size_t i = begin; i < end; ++i) winners[i] = som.winner(samples[i], workspace);
  });
  return winners;
}

std::vector<std::size_t> batch_epoch(Som& som, const Samples& samples, double radius,
                                     std::size_t threads) {
  if (!has_weights_for(som, samples)) som.store_all();
  Samples storage;
  const Samples& prepared = prepared_samples(som.parameters(), samples, storage);
  std::vector<std::size_t> winners = winners_of(som, prepared, threads);
  const WinnerSums sums = sum_by_winner(som, prepared, winners);
  for_each_range(som.neurons(), threads, [&](std::size_t begin, std::size_t end) {
    Neighbourhood neighbourhood(som.grid(), som.parameters().neighbourhood);
    std::vector<double> gains(som.neurons());
    std::vector<double> mean(som.elements().count());
    for (std::size_t neuron = begin; neuron < end; ++neuron) {
      neighbourhood.around(neuron, radius, gains);
      move_to_mean(som, neuron, sums, gains, mean);
    }
  });
  if (som.parameters().similarity == Similarity::kDotProduct) {
    AlignedVector<float> factors;
    normalize_rows(som.weights(), factors);
  }
  return winners;
}

Result<Som> untrained_som(const SomParameters& parameters, const Samples& samples) {
  Samples storage;
  auto ready = prepare_training(parameters, samples, storage);
  if (!ready) return fail(std::move(ready.error()));
  return of_whole_inputs(initial_som(*ready), ready->elements);
}

Result<Som> train_som(const SomParameters& parameters, const Samples& samples,
                      const TrainingOptions& options) {
  Samples storage;
  auto ready = prepare_training(parameters, samples, storage);
  if (!ready) return fail(std::move(ready.error()));
  if (ready->parameters.arithmetic == Arithmetic::kInnerProducts) {
    auto som = train_by_inner_products(*ready, options);
    if (!som) return som;
    return of_whole_inputs(std::move(*som), ready->elements);
  }
  Som som = initial_som(*ready);
  if (auto trained = train_in_place(som, *ready->samples, options); !trained) {
    return fail(std::move(trained.error()));
  }
  return of_whole_inputs(std::move(som), ready->elements);
}

Result<void> continue_som(Som& som, const Samples& samples, const TrainingOptions& options) {
  if (auto usable = check_samples(samples); !usable) return usable;
  require(samples.size() == som.input_size(),
          "the samples' size differs from the map's input size");
  Som trained = som;
  if (!has_weights_for(som, samples)) {
    auto fits = check_memory(som.parameters(), som.input_size());
    if (!fits) return fits;
    trained.store_all();
  }
  Samples storage;
  const Samples& prepared = prepared_samples(som.parameters(), samples, storage);
  if (auto fit = check_range(prepared); !fit) return fit;
  auto result = train_in_place(trained, prepared, options);
  if (result) som = std::move(trained);
  return result;
}

DrawSequence::DrawSequence(Draws draws, std::size_t samples, std::uint64_t seed)
    : draws_(draws), samples_(samples), random_(seed, Stream::kDraws) {}

std::size_t DrawSequence::next() {
  if (draws_ == Draws::kWithReplacement) return random_.below(samples_);
  if (left_.empty()) {
    left_.resize(samples_);
    std::iota(left_.begin(), left_.end(), std::size_t{0});
  }
  std::swap(left_[random_.below(left_.size())], left_.back());
  const std::size_t drawn = left_.back();
  left_.pop_back();
  return drawn;
}

}  // namespace somato
