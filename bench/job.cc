#include "job.h"

#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "somato/maps/batch_training.h"
#include "somato/maps/som_learner.h"
#include "somato/maps/som_training.h"

namespace somato::bench {
namespace {

Som trained(Result<Som> result) {
  if (result) return std::move(*result);
  throw std::runtime_error(to_string(result.error()));
}

Matrix<float> weights_of(const Som& som) {
  Matrix<float> rows(som.neurons(), som.input_size());
  for (std::size_t neuron = 0; neuron < rows.rows(); ++neuron) {
    for (std::size_t d = 0; d < rows.columns(); ++d) rows(neuron, d) = som.weight(neuron, d);
  }
  return rows;
}

// Training from the samples to the map.
class Train : public Job {
 public:
  Train(const Workload& workload, std::size_t threads)
      : workload_(workload), threads_(threads), samples_(make_samples(workload)) {}

  double run() override {
    som_ = trained(train_som(workload_.parameters, samples_, {threads_, {}}));
    return 0.0;
  }
  Matrix<float> weights() const override { return weights_of(som_); }

 protected:
  Workload workload_;
  std::size_t threads_;
  Samples samples_;
  Som som_;
};

// The same, of which the second half of the epochs counts.
class TrainLastHalf : public Train {
 public:
  using Train::Train;

  double run() override {
    double half = 0.0;
    const auto watch = [&](std::uint64_t done, std::uint64_t total) {
      if (done == total / 2) half = now();
      return true;
    };
    som_ = trained(train_som(workload_.parameters, samples_, {threads_, watch}));
    return now() - half;
  }
};

// The same, an epoch at a time: none knows what came before, so that nothing can be skipped.
class EpochsLastHalf : public Train {
 public:
  using Train::Train;

  double run() override {
    som_ = trained(untrained_som(workload_.parameters, samples_));
    const SomParameters& p = som_.parameters();
    double half = 0.0;
    for (std::uint64_t epoch = 0; epoch < p.epochs; ++epoch) {
      if (epoch == p.epochs / 2) half = now();
      batch_epoch(som_, samples_, p.radius().at(epoch), threads_);
    }
    return now() - half;
  }
};

// Samples come one at a time, and nothing is known of those to come. Making the map does not count.
class Stream : public Train {
 public:
  using Train::Train;

  double run() override {
    som_ = trained(untrained_som(workload_.parameters, samples_));
    const SomParameters& p = som_.parameters();
    DrawSequence draws(p.draws, samples_.count(), p.seed);
    const double begin = now();
    SomLearner learner(som_);
    for (std::uint64_t t = 0; t < *p.iterations; ++t) {
      learner.learn(samples_[draws.next()], p.learning_rate().at(t), p.radius().at(t));
    }
    return now() - begin;
  }
};

class FindWinners : public Train {
 public:
  FindWinners(const Workload& workload, std::size_t threads) : Train(workload, threads) {
    som_ = trained(untrained_som(workload_.parameters, samples_));
  }

  double run() override {
    winners_ = winners_of(som_, samples_, threads_);
    return 0.0;
  }

 private:
  std::vector<std::size_t> winners_;
};

}  // namespace

Matrix<float> initial_weights(const Workload& workload, const Samples& samples) {
  return weights_of(trained(untrained_som(workload.parameters, samples)));
}

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::unique_ptr<Job> make_job(const Workload& workload, std::size_t threads) {
  const std::string& name = workload.name;
  if (name.ends_with("_streaming")) return std::make_unique<Stream>(workload, threads);
  if (name == "winners") return std::make_unique<FindWinners>(workload, threads);
  if (name == "clustered_batch") return std::make_unique<TrainLastHalf>(workload, threads);
  if (name == "clustered_epochs") return std::make_unique<EpochsLastHalf>(workload, threads);
  return std::make_unique<Train>(workload, threads);
}

}  // namespace somato::bench
