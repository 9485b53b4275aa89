// Small whole trainings and searches.

#include <cstdint>
#include <string>
#include <vector>

#include "guard.h"
#include "maps/training/batch_training.h"
#include "somato/maps/som_learner.h"
#include "somato/maps/som_training.h"
#include "somato/maps/t_mpsom.h"

namespace somato::bench {
namespace {

Samples samples_of(std::size_t count, std::size_t size) {
  const auto values = noise<float>(count * size, 6);
  return Samples(Matrix<float>(count, size, std::vector<float>(values.begin(), values.end())));
}

SomParameters map_of(std::size_t side) {
  SomParameters parameters;
  parameters.rows = side;
  parameters.columns = side;
  return parameters;
}

void count_batch(Lattice lattice, const std::string& name, const Counted& counted) {
  SomParameters parameters = map_of(20);
  parameters.training = Training::kBatch;
  parameters.lattice = lattice;
  const Samples samples = samples_of(200, 64);
  Som som = untrained_som(parameters, samples).value();
  counted(
      name, [&] { batch_epoch(som, samples, 5.0, 1); }, [&] { return digest_of(som.weights()); });
}

void count_stream(const Samples& samples, const std::string& name, const Counted& counted) {
  Som som = untrained_som(map_of(15), samples).value();
  const auto learn = [&] {
    SomLearner learner(som);
    for (std::size_t i = 0; i < samples.count(); ++i) learner.learn(samples[i], 0.1, 3.0);
  };
  counted(name, learn, [&] { return digest_of(som.weights()); });
}

// One of a hundred elements is not zero.
Samples sparse_samples() {
  constexpr std::size_t kSamples = 50;
  constexpr std::uint32_t kSize = 5000;
  constexpr std::uint32_t kStep = 100;
  std::vector<Signal> signals;
  signals.reserve(kSamples);
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    std::vector<std::uint32_t> elements;
    elements.reserve(kSize / kStep);
    for (std::uint32_t e = i % kStep; e < kSize; e += kStep) elements.push_back(e);
    const auto values = noise<float>(elements.size(), i);
    signals.push_back(Signal::sparse({kSize}, elements, {values.begin(), values.end()}));
  }
  return Samples::from_signals(signals);
}

// So few that training goes by their inner products.
void count_few_samples(SomParameters parameters, const std::string& name, const Counted& counted) {
  const Samples samples = samples_of(20, 512);
  Som som;
  counted(
      name,
      [&] {
        som = train_som(parameters, samples.apart()).value();
        som.weights();
      },
      [&] { return digest_of(som.weights()); });
}

void count_all_few_samples(const Counted& counted) {
  SomParameters parameters = map_of(15);
  parameters.iterations = 100;
  count_few_samples(parameters, "few_samples_100_iterations", counted);
  parameters.training = Training::kBatch;
  parameters.epochs = 20;
  count_few_samples(parameters, "few_samples_20_epochs", counted);
}

void count_winners(const Som& som, const Samples& samples, const std::string& name,
                   const Counted& counted) {
  std::vector<std::size_t> winners;
  counted(name, [&] { winners = winners_of(som, samples, 1); }, [&] { return digest_of(winners); });
}

void count_winners_of_noise(const Counted& counted) {
  const Samples samples = samples_of(200, 64);
  count_winners(untrained_som(map_of(20), samples).value(), samples, "winners_200", counted);
}

// Rows around few points, row after row from the first point to the last.
Matrix<float> clusters(std::size_t rows, std::size_t columns, std::uint64_t seed) {
  constexpr std::size_t kClusters = 7;
  constexpr float kSpan = 10.0F;
  const auto centres = noise<float>(kClusters * columns, 10);
  const auto off = noise<float>(rows * columns, seed);
  Matrix<float> values(rows, columns);
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t d = 0; d < columns; ++d) {
      values(i, d) = kSpan * centres[i * kClusters / rows * columns + d] + off[i * columns + d];
    }
  }
  return values;
}

// Most of the map is so far from a sample that it is left out.
void count_winners_of_clusters(const Counted& counted) {
  SomParameters parameters = map_of(30);
  parameters.similarity = Similarity::kEuclidean;
  parameters.normalize_input = false;
  const Som som(parameters, clusters(parameters.grid().size(), 64, 11));
  count_winners(som, Samples(clusters(700, 64, 12)), "winners_700_of_clusters", counted);
}

void count_t_mpsom(const Counted& counted) {
  TMpsomParameters parameters;
  parameters.shape = {46, 23};
  parameters.input_sizes = {90, 45};
  TMpsom map(parameters);
  TMpsom::Workspace workspace(map);
  const auto posture = noise<float>(90, 8);
  const auto touch = noise<float>(45, 9);
  const std::vector<SignalView> frame{SignalView::dense(posture), SignalView::dense(touch)};
  counted(
      "t_mpsom_iteration", [&] { map.learn(frame, 0.1, workspace); },
      [&] { return digest_of(map.weights(1).values(), digest_of(workspace.activity())); });
}

}  // namespace

void count_cases(const Counted& counted) {
  count_batch(Lattice::kRectangular, "batch_epoch", counted);
  count_batch(Lattice::kHexagonal, "batch_epoch_hexagonal", counted);
  count_stream(samples_of(50, 256), "online_50_iterations", counted);
  count_stream(sparse_samples(), "online_50_sparse_iterations", counted);
  count_all_few_samples(counted);
  count_winners_of_noise(counted);
  count_winners_of_clusters(counted);
  count_t_mpsom(counted);
}

}  // namespace somato::bench
