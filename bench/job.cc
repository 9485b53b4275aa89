#include "job.h"

#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "maps/reading/winner_search.h"
#include "maps/training/batch_training.h"
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
    som_ = trained(train_som(workload_.parameters, samples_.apart(), {threads_}));
    som_.weights();  // may be formed when they are first needed
    return 0.0;
  }
  Matrix<float> weights() const override { return weights_of(som_); }

 protected:
  Workload workload_;
  std::size_t threads_;
  Samples samples_;
  Som som_;
};

// The same by inner products, without forming the weights, which are not needed.
class TrainByProducts : public Train {
 public:
  using Train::Train;

  double run() override {
    const Samples anew = samples_.apart();
    som_ = trained(train_som(workload_.parameters, anew, {threads_}));
    som_.winners(anew, 0, workspace_);
    return 0.0;
  }

 private:
  SomWorkspace workspace_;
};

// Training, of which the searches of the second half of the epochs count.
class SearchLastHalf : public Train {
 public:
  SearchLastHalf(const Workload& workload, std::size_t threads, bool skip)
      : Train(workload, threads), skip_(skip) {}

  double run() override {
    som_ = trained(untrained_som(workload_.parameters, samples_));
    const SomParameters& p = som_.parameters();
    double searching = 0.0;
    for (std::uint64_t epoch = 0; epoch < p.epochs; ++epoch) {
      const double begin = now();
      if (2 * epoch >= p.epochs) {
        found_ = WinnerSearch::find_all(som_, samples_, false, threads_, skip_);
        searching += now() - begin;
      }
      batch_epoch(som_, samples_, p.radius().at(epoch), threads_);
    }
    return searching;
  }

 private:
  bool skip_;
  std::vector<Winners> found_;
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
    SomLearner learner(som_, threads_);
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
  if (name.starts_with("winners")) return std::make_unique<FindWinners>(workload, threads);
  if (name == "clustered_search") {
    return std::make_unique<SearchLastHalf>(workload, threads, true);
  }
  if (name == "clustered_search_of_all") {
    return std::make_unique<SearchLastHalf>(workload, threads, false);
  }
  if (name.starts_with("sparse_")) return std::make_unique<TrainByProducts>(workload, threads);
  return std::make_unique<Train>(workload, threads);
}

}  // namespace somato::bench
