#include "maps/training/source_preparation.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include "base/core/memory.h"
#include "maps/grid/feature_ranges.h"
#include "maps/som/initial_weights.h"
#include "maps/som/som_preparation.h"

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
  WeightsAtSamples(const SomParameters& parameters, const SampleSurvey& survey)
      : normalizes_(parameters.similarity == Similarity::kDotProduct),
        sample_of_(initial_samples(parameters, survey.count)),
        order_(sample_of_.size()),
        first_(survey.first),
        row_(survey.low.size()),
        weights_(sample_of_.size(), row_.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::sort(order_.begin(), order_.end(),
              [&](std::size_t a, std::size_t b) { return sample_of_[a] < sample_of_[b]; });
    while (done_ < order_.size() && sample_of_[order_[done_]] < first_) ++done_;
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
  std::size_t first_;  // The number of the next part's first sample.
  std::vector<float> row_;
  LaneMatrix<float> weights_;
};

void combine(ProcessGroup& processes, std::size_t size, SampleSurvey& survey) {
  auto count = static_cast<std::int64_t>(survey.count);
  survey.first = static_cast<std::size_t>(processes.sum_before(count));
  processes.sum({&count, 1});
  survey.count = static_cast<std::size_t>(count);
  processes.maximize({&survey.longest, 1});
  combine_ranges(processes, size, survey.low, survey.high);
}

// Every value is that of the only process that has set it; the sum of the bits keeps its sign.
void combine(ProcessGroup& processes, std::span<float> values) {
  constexpr std::size_t kAtOnce = std::size_t{1} << 20;
  std::vector<std::int64_t> bits;
  for (std::size_t first = 0; first < values.size(); first += kAtOnce) {
    const auto some = values.subspan(first, std::min(kAtOnce, values.size() - first));
    bits.resize(some.size());
    std::transform(some.begin(), some.end(), bits.begin(),
                   [](float value) { return std::int64_t{std::bit_cast<std::uint32_t>(value)}; });
    processes.sum(bits);
    std::transform(bits.begin(), bits.end(), some.begin(), [](std::int64_t value) {
      return std::bit_cast<float>(static_cast<std::uint32_t>(value));
    });
  }
}

Result<LaneMatrix<float>> weights_at_samples(const SomParameters& parameters,
                                             SampleSource& prepared, const SampleSurvey& survey,
                                             ProcessGroup* processes) {
  WeightsAtSamples at_samples(parameters, survey);
  const auto gone_through = for_each_part(prepared, [&](const Samples& part) -> Result<void> {
    at_samples.take(part);
    return {};
  });
  SOMATO_TRY_VOID(agreed(gone_through, processes));
  LaneMatrix<float> weights = at_samples.take_weights();
  if (processes) combine(*processes, {weights.data(), weights.padded_rows() * weights.columns()});
  return weights;
}

Result<void> check_samples_fit(const SampleSurvey& survey) {
  const double needed =
      static_cast<double>(survey.count) * static_cast<double>(survey.low.size()) * sizeof(float);
  if (needed <= static_cast<double>(memory_limit())) return {};
  return fail(ErrorKind::kSystem,
              fmt::format("linear initial weights of fewer samples than features need all samples "
                          "in memory, which takes {}",
                          memory_text(needed)),
              {}, "set 'initial_weights' to range or samples");
}

// The samples of all processes.
Result<Samples> all_samples(SampleSource& prepared, const SampleSurvey& survey,
                            ProcessGroup* processes) {
  SOMATO_TRY_VOID(agreed(check_samples_fit(survey), processes));
  Matrix<float> rows(survey.count, survey.low.size());
  std::size_t next = survey.first;
  const auto gone_through = for_each_part(prepared, [&](const Samples& part) -> Result<void> {
    for (std::size_t i = 0; i < part.count(); ++i) write_dense(part[i], rows.row(next++));
    return {};
  });
  SOMATO_TRY_VOID(agreed(gone_through, processes));
  if (processes) combine(*processes, rows.values());
  return Samples(std::move(rows));
}

Result<PrincipalPlane> plane_of(SampleSource& prepared, const SampleSurvey& survey,
                                ProcessGroup* processes, std::size_t threads) {
  SOMATO_TRY_VOID(agreed(check_plane(survey.count, survey.low, survey.high), processes));
  if (plane_needs_all(survey.count, survey.low, survey.high)) {
    return all_samples(prepared, survey, processes).map([&](const Samples& samples) {
      return principal_plane(samples, survey.low, survey.high, threads);
    });
  }
  CovarianceSums sums(survey.count, survey.low, survey.high, threads);
  const auto gone_through = for_each_part(prepared, [&](const Samples& part) -> Result<void> {
    sums.add(part);
    return {};
  });
  SOMATO_TRY_VOID(agreed(gone_through, processes));
  if (processes) sums.combine(*processes);
  return sums.plane();
}

LaneMatrix<float> weights_on_plane(const SomParameters& parameters, const PrincipalPlane& plane) {
  LaneMatrix<float> weights(parameters.grid().size(), plane.mean.size());
  std::vector<float> row(plane.mean.size());
  for (std::size_t neuron = 0; neuron < weights.rows(); ++neuron) {
    write_on_plane(plane, parameters, neuron, row);
    weights.set_row(neuron, row);
  }
  return weights;
}

Result<LaneMatrix<float>> initial_weights(const SomParameters& parameters, SampleSource& prepared,
                                          const SampleSurvey& survey, ProcessGroup* processes,
                                          std::size_t threads) {
  switch (parameters.initial_weights) {
    case InitialWeights::kSamples:
      return weights_at_samples(parameters, prepared, survey, processes);
    case InitialWeights::kLinear:
      return plane_of(prepared, survey, processes, threads).map([&](const PrincipalPlane& plane) {
        return weights_on_plane(parameters, plane);
      });
    case InitialWeights::kRange:
    case InitialWeights::kUniform:
      break;
  }
  return weights_in_ranges(parameters, survey);
}

}  // namespace

Result<SampleSurvey> survey_samples(SampleSource& prepared, ProcessGroup* processes) {
  SampleSurvey survey;
  const auto gone_through = for_each_part(prepared, [&](const Samples& part) -> Result<void> {
    survey.count += part.count();
    ++survey.parts;
    survey.longest = std::max(survey.longest, longest_of(part));
    widen_ranges(part, survey.low, survey.high);
    return {};
  });
  SOMATO_TRY_VOID(agreed(gone_through, processes));
  survey.parts = std::max<std::size_t>(survey.parts, 1);
  if (processes) combine(*processes, prepared.size(), survey);
  return survey;
}

Result<Som> initial_som(const SomParameters& parameters, SampleSource& prepared,
                        const SampleSurvey& survey, ProcessGroup* processes, std::size_t threads) {
  return initial_weights(parameters, prepared, survey, processes, threads)
      .map([&](LaneMatrix<float>&& weights) { return Som(parameters, std::move(weights)); });
}

}  // namespace somato
