#include "maps/inner_product_training.h"

// Training on few samples of many elements. Every weight vector stays a combination of its start
// and of the samples,
//
//     w_j = c_j w_j(0) + sum_s A_js x_s,
//
// so it is enough to know the inner products G_js = w_j . x_s and the squared lengths n_j. One
// iteration with sample i and gain a (learning rate times neighbourhood) is
//
//     n_j <- (1-a)^2 n_j + 2 a (1-a) G_ji + a^2 K_ii,    K_st = x_s . x_t,
//     G_j <- G_j + a (K_i - G_j),    c_j <- (1-a) c_j,    A_j <- (1-a) A_j, A_ji <- A_ji + a,
//
// and a normalization divides all of them by sqrt(n_j). It costs neurons x samples whatever the
// number of elements. Weights are formed once, at the end. Everything is in double precision.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "core/lanes.h"
#include "maps/activity.h"
#include "maps/stop.h"
#include "somato/core/check.h"
#include "somato/core/lane_matrix.h"
#include "somato/core/threads.h"
#include "somato/maps/initial_weights.h"

namespace somato {
namespace {

constexpr std::uint64_t kIterationsBetweenReports = 256;
constexpr std::uint64_t kIterationsBetweenClearings = 256;

// The inner products of one vector with all samples: lanes run over dense samples.
class SampleProducts {
 public:
  explicit SampleProducts(const Samples& samples) : samples_(samples) {
    if (samples.is_sparse()) return;
    lanes_ = LaneMatrix<double>(samples.count(), samples.size());
    for (std::size_t s = 0; s < samples.count(); ++s) {
      const SignalView sample = samples[s];
      for (std::size_t d = 0; d < sample.size; ++d) lanes_(s, d) = double{sample.values[d]};
    }
  }

  // `x` holds samples.size() values; writes samples.count() products.
  void write(std::span<const float> x, std::span<double> out) const {
    if (samples_.is_sparse()) {
      for (std::size_t s = 0; s < samples_.count(); ++s) {
        out[s] = inner_product(samples_[s], SignalView::dense(x));
      }
      return;
    }
    const AlignedVector<double> wide(x.begin(), x.end());
    AlignedVector<double> products(lanes_.padded_rows());
    kernels::table<double>().inner_products(kernels::lanes(lanes_), wide.data(), products.data());
    std::copy_n(products.begin(), samples_.count(), out.begin());
  }

 private:
  const Samples& samples_;
  LaneMatrix<double> lanes_;
};

// A row of coefficients with a factor in front, so that shrinking all of them is one operation.
class Coefficients {
 public:
  Coefficients() = default;
  Coefficients(std::size_t neurons, std::size_t samples)
      : start_(neurons, 1.0), factors_(neurons, 1.0), values_(neurons, samples) {}

  void shrink_and_add(std::size_t neuron, double gain, std::size_t sample) {
    scale(neuron, 1.0 - gain);
    values_(neuron, sample) += gain / factors_[neuron];
  }

  void scale(std::size_t neuron, double factor) {
    constexpr double kSmallestFactor = 1e-100;
    start_[neuron] *= factor;
    factors_[neuron] *= factor;
    if (std::fabs(factors_[neuron]) >= kSmallestFactor) return;
    for (double& value : values_.row(neuron)) value *= factors_[neuron];
    factors_[neuron] = 1.0;
  }

  // start * w(0), then the samples in order.
  double of_start(std::size_t neuron) const { return start_[neuron]; }
  double of_sample(std::size_t neuron, std::size_t sample) const {
    return factors_[neuron] * values_(neuron, sample);
  }

 private:
  std::vector<double> start_;
  std::vector<double> factors_;
  Matrix<double> values_;
};

}  // namespace

class InnerProductTrainer {
 public:
  // Refers to what is prepared.
  InnerProductTrainer(const PreparedTraining& prepared, std::size_t threads)
      : parameters_(prepared.parameters),
        samples_(*prepared.samples),
        threads_(threads),
        grid_(parameters_.grid()),
        source_(parameters_, samples_, prepared.elements),
        sample_products_(samples_.count(), samples_.count()),
        products_(grid_.size(), samples_.count()),
        squared_lengths_(grid_.size()),
        coefficients_(grid_.size(), samples_.count()),
        neighbourhood_(grid_, parameters_.neighbourhood),
        gains_(products_.padded_rows()),
        factors_(products_.padded_rows(), 1.0) {
    compute_products();
  }

  std::size_t learn(std::size_t sample, double learning_rate, double radius) {
    const std::size_t nearest = winner(sample);
    neighbourhood_.around(nearest, radius, gains_);
    for (double& gain : gains_) gain *= learning_rate;
    for (std::size_t neuron = 0; neuron < grid_.size(); ++neuron) {
      factors_[neuron] = 1.0;
      if (gains_[neuron] != 0.0) move_coefficients(neuron, gains_[neuron], sample);
    }
    const auto& kernels = kernels::table<double>();
    kernels.move_towards(kernels::lanes(products_), sample_products_.row(sample).data(),
                         gains_.data());
    if (dot_product()) {
      kernels.scale_rows(kernels::lanes(products_), factors_.data());
    }
    // Products with samples that are orthogonal decay until they are slow to compute with.
    if (++learned_ % kIterationsBetweenClearings == 0) {
      kernels.clear_negligible(kernels::lanes(products_));
    }
    return nearest;
  }

  void similarities(std::size_t sample, std::span<float> out) const {
    for (std::size_t neuron = 0; neuron < grid_.size(); ++neuron) {
      out[neuron] = dot_product() ? static_cast<float>(products_(neuron, sample))
                                  : similarity_at(squared_distance(neuron, sample));
    }
  }

  Som form_som() const {
    LaneMatrix<float> weights(grid_.size(), samples_.size());
    for_each_range(grid_.size(), threads_, [&](std::size_t begin, std::size_t end) {
      std::vector<float> start(samples_.size());
      std::vector<double> sum(samples_.size());
      for (std::size_t neuron = begin; neuron < end; ++neuron) {
        form_weights(neuron, start, sum);
        for (std::size_t d = 0; d < sum.size(); ++d) {
          weights(neuron, d) = static_cast<float>(sum[d]);
        }
      }
    });
    return Som(parameters_, std::move(weights));
  }

 private:
  bool dot_product() const { return parameters_.similarity == Similarity::kDotProduct; }

  void compute_products() {
    const SampleProducts with_samples(samples_);
    for_each_range(samples_.count(), threads_, [&](std::size_t begin, std::size_t end) {
      std::vector<float> x(samples_.size());
      for (std::size_t s = begin; s < end; ++s) {
        write_dense(samples_[s], x);
        with_samples.write(x, sample_products_.row(s));
      }
    });
    for_each_range(grid_.size(), threads_, [&](std::size_t begin, std::size_t end) {
      std::vector<float> w(samples_.size());
      std::vector<double> products(samples_.count());
      for (std::size_t neuron = begin; neuron < end; ++neuron) {
        source_.write(neuron, w);
        with_samples.write(w, products);
        products_.set_row(neuron, products);
        squared_lengths_[neuron] = inner_product(SignalView::dense(w), SignalView::dense(w));
      }
    });
  }

  // The first of the nearest neurons, as in Som::winner.
  std::size_t winner(std::size_t sample) const {
    std::size_t best = 0;
    double least = score(0, sample);
    for (std::size_t neuron = 1; neuron < grid_.size(); ++neuron) {
      const double value = score(neuron, sample);
      if (value < least) {
        least = value;
        best = neuron;
      }
    }
    return best;
  }

  // The squared distance without the sample's own length, or the negative inner product.
  double score(std::size_t neuron, std::size_t sample) const {
    const double product = products_(neuron, sample);
    return dot_product() ? -product : squared_lengths_[neuron] - 2.0 * product;
  }

  // Rounding may leave a difference of equals below 0.
  double squared_distance(std::size_t neuron, std::size_t sample) const {
    return std::max(0.0, sample_products_(sample, sample) + score(neuron, sample));
  }

  void move_coefficients(std::size_t neuron, double gain, std::size_t sample) {
    coefficients_.shrink_and_add(neuron, gain, sample);
    const double kept = 1.0 - gain;
    const double squared_length = kept * kept * squared_lengths_[neuron] +
                                  2.0 * gain * kept * products_(neuron, sample) +
                                  gain * gain * sample_products_(sample, sample);
    squared_lengths_[neuron] = squared_length;
    if (!dot_product() || squared_length <= 0.0) return;
    factors_[neuron] = 1.0 / std::sqrt(squared_length);
    squared_lengths_[neuron] = 1.0;
    coefficients_.scale(neuron, factors_[neuron]);
  }

  void form_weights(std::size_t neuron, std::vector<float>& start, std::vector<double>& sum) const {
    source_.write(neuron, start);
    const double of_start = coefficients_.of_start(neuron);
    for (std::size_t d = 0; d < sum.size(); ++d) sum[d] = of_start * double{start[d]};
    for (std::size_t s = 0; s < samples_.count(); ++s) {
      add_sample(coefficients_.of_sample(neuron, s), samples_[s], sum);
    }
  }

  static void add_sample(double factor, const SignalView& x, std::vector<double>& sum) {
    if (!x.sparse) {
      kernels::table<float>().add_scaled(x.values.data(), factor, sum.size(), sum.data());
      return;
    }
    for (std::size_t k = 0; k < x.values.size(); ++k) {
      double& total = sum[x.indices[k]];
      total = std::fma(factor, double{x.values[k]}, total);
    }
  }

  const SomParameters& parameters_;
  const Samples& samples_;
  std::size_t threads_;
  Grid grid_;
  InitialWeightsSource source_;
  Matrix<double> sample_products_;  // K, samples x samples
  LaneMatrix<double> products_;     // G, neurons x samples
  std::vector<double> squared_lengths_;
  Coefficients coefficients_;
  Neighbourhood neighbourhood_;
  AlignedVector<double> gains_;
  AlignedVector<double> factors_;
  std::uint64_t learned_ = 0;
};

Result<Som> train_by_inner_products(const PreparedTraining& prepared,
                                    const TrainingOptions& options) {
  const SomParameters& p = prepared.parameters;
  InnerProductTrainer trainer(prepared, options.threads);
  DrawSequence draws(p.draws, prepared.samples->count(), p.seed);
  const Stop stop(options.progress, *p.iterations, kIterationsBetweenReports);
  for (std::uint64_t t = 0; t < *p.iterations; ++t) {
    trainer.learn(draws.next(), p.learning_rate().at(t), p.radius().at(t));
    if (stop.after(t + 1)) return Stop::error();
  }
  return trainer.form_som();
}

InnerProductLearner::~InnerProductLearner() = default;

Result<std::unique_ptr<InnerProductLearner>> InnerProductLearner::start(
    const SomParameters& parameters, Samples samples) {
  std::unique_ptr<InnerProductLearner> learner(new InnerProductLearner());
  learner->samples_ = std::move(samples);
  auto prepared = prepare_training(parameters, learner->samples_, learner->storage_);
  if (!prepared) return fail(std::move(prepared.error()));
  if (prepared->parameters.arithmetic != Arithmetic::kInnerProducts) return nullptr;
  learner->prepared_ = std::move(*prepared);
  learner->trainer_ = std::make_unique<InnerProductTrainer>(learner->prepared_, 1);
  return learner;
}

std::size_t InnerProductLearner::learn(std::size_t sample, double learning_rate, double radius) {
  require(sample < samples_.count(), "there is no such sample to learn");
  return trainer_->learn(sample, learning_rate, radius);
}

void InnerProductLearner::activity(std::size_t sample, std::span<float> out) const {
  require(sample < samples_.count() && out.size() == parameters().grid().size(),
          "an activity needs one of the samples, and room for a value a neuron");
  trainer_->similarities(sample, out);
  activity_of_similarities(parameters(), out);
}

Som InnerProductLearner::form_som() const {
  Som som = trainer_->form_som();
  return Som(som.parameters(), std::move(som.weights()), prepared_.elements);
}

}  // namespace somato
