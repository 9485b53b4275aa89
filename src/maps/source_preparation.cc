#include "maps/source_preparation.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "maps/initial_weights.h"
#include "maps/som_preparation.h"

namespace somato {
namespace {

// Two samples that have the ranges of all.
Samples ends_of_ranges(const SampleSurvey& survey) {
  Matrix<float> ends(2, survey.low.size());
  std::copy(survey.low.begin(), survey.low.end(), ends.row(0).begin());
  std::copy(survey.high.begin(), survey.high.end(), ends.row(1).begin());
  return Samples(std::move(ends));
}

LaneMatrix<float> weights_in_ranges(const SomParameters& parameters, const SampleSurvey& survey) {
  const Samples ends = ends_of_ranges(survey);
  const InitialWeightsSource source(parameters, ends);
  LaneMatrix<float> weights(parameters.grid().size(), ends.size());
  std::vector<float> row(ends.size());
  for (std::size_t neuron = 0; neuron < weights.rows(); ++neuron) {
    source.write(neuron, row);
    weights.set_row(neuron, row);
  }
  return weights;
}

// Gives neurons the samples they start at, as these come by.
class WeightsAtSamples {
 public:
  WeightsAtSamples(const SomParameters& parameters, std::size_t count, std::size_t size)
      : normalizes_(parameters.similarity == Similarity::kDotProduct),
        sample_of_(initial_samples(parameters, count)),
        order_(sample_of_.size()),
        row_(size),
        weights_(sample_of_.size(), size) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::sort(order_.begin(), order_.end(),
              [&](std::size_t a, std::size_t b) { return sample_of_[a] < sample_of_[b]; });
  }

  void take(const Samples& part) {
    for (; done_ < order_.size(); ++done_) {
      const std::size_t neuron = order_[done_];
      if (sample_of_[neuron] >= first_ + part.count()) break;
      write_dense(part[sample_of_[neuron] - first_], row_);
      if (normalizes_) normalize_length(row_);
      weights_.set_row(neuron, row_);
    }
    first_ += part.count();
  }

  LaneMatrix<float> take_weights() { return std::move(weights_); }

 private:
  bool normalizes_;
  std::vector<std::size_t> sample_of_;
  std::vector<std::size_t> order_;  // Neurons, by the number of their sample.
  std::size_t done_ = 0;
  std::size_t first_ = 0;  // The number of the next part's first sample.
  std::vector<float> row_;
  LaneMatrix<float> weights_;
};

}  // namespace

Result<SampleSurvey> survey_samples(SampleSource& prepared) {
  SampleSurvey survey;
  return for_each_part(prepared,
                       [&](const Samples& part) -> Result<void> {
                         survey.count += part.count();
                         ++survey.parts;
                         survey.longest = std::max(survey.longest, longest_of(part));
                         widen_ranges(part, survey.low, survey.high);
                         return {};
                       })
      .map([&] { return std::move(survey); });
}

Result<Som> initial_som(const SomParameters& parameters, SampleSource& prepared,
                        const SampleSurvey& survey) {
  if (parameters.initial_weights != InitialWeights::kSamples) {
    return Som(parameters, weights_in_ranges(parameters, survey));
  }
  WeightsAtSamples weights(parameters, survey.count, prepared.size());
  return for_each_part(prepared,
                       [&](const Samples& part) -> Result<void> {
                         weights.take(part);
                         return {};
                       })
      .map([&] { return Som(parameters, weights.take_weights()); });
}

}  // namespace somato
