#include "maps/products/product_problem.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/core/threads.h"
#include "base/kernels/product_kernels.h"
#include "maps/grid/feature_ranges.h"
#include "maps/som/initial_weights.h"
#include "maps/som/som_preparation.h"
#include "somato/core/check.h"

namespace somato {
namespace {

using kernels::kRowLanes;

std::vector<std::uint32_t> all_below(std::size_t count) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0U);
  return numbers;
}

}  // namespace

Result<std::shared_ptr<const ProductProblem>> ProductProblem::prepare(
    const SomParameters& parameters, const Samples& known, std::vector<std::size_t> training,
    std::size_t threads) {
  require(std::all_of(training.begin(), training.end(),
                      [&](std::size_t sample) { return sample < known.count(); }),
          "a sample to train on does not exist");
  SOMATO_TRY_VOID(check_samples(training.size(), known.size()));
  SOMATO_TRY(auto resolved, resolve(parameters, training.size(), known.size()));
  if (resolved.arithmetic != Arithmetic::kInnerProducts) return nullptr;
  std::shared_ptr<ProductProblem> problem(new ProductProblem());
  problem->known_ = SampleProducts::of(known, *resolved.normalize_input, threads);
  problem->parameters_ = std::move(resolved);
  double longest = 0.0;
  problem->trained_.resize(known.count());
  problem->items_.resize(known.count());
  for (std::size_t item = 0; item < training.size(); ++item) {
    const std::size_t sample = training[item];
    problem->trained_[sample] = true;
    problem->items_[sample] = item;
    longest = std::max(longest, problem->known_->products()(sample, sample));
  }
  SOMATO_TRY_VOID(check_longest(std::sqrt(longest)));
  SOMATO_TRY_VOID(
      check_initial_weights(problem->parameters_, problem->known_->samples().subset(training)));
  problem->training_ = std::move(training);
  problem->elements_ = StoredElements(known.size());
  const bool zero_without = InitialWeightsSource::are_zero_without_samples(problem->parameters_);
  if (known.is_sparse() && zero_without) {
    problem->used_ = problem->used_elements();
    problem->elements_ = StoredElements::worth_storing(known.size(), problem->used_);
  }
  SOMATO_TRY_VOID(check_memory(problem->parameters_, problem->elements_.count()));
  return std::shared_ptr<const ProductProblem>(std::move(problem));
}

ProductReading ProductProblem::reading(std::size_t sample, std::span<const double> products,
                                       std::span<const double> squared_lengths) const {
  const std::size_t neurons = parameters_.grid().size();
  return {parameters_.similarity, products.first(neurons), squared_lengths.first(neurons),
          known_->products()(sample, sample)};
}

bool ProductProblem::starts_at_random() const {
  return parameters_.initial_weights == InitialWeights::kRange ||
         parameters_.initial_weights == InitialWeights::kUniform;
}

// Each weight vector of the plane is a combination of samples, because the mean and the components
// are.
Matrix<double> ProductProblem::factors_on_plane(std::size_t threads) const {
  const Samples samples = known_->samples().subset(training_);
  std::vector<float> low;
  std::vector<float> high;
  widen_ranges(samples, low, high);
  const PrincipalPlane plane = principal_plane(samples, low, high, threads);
  const std::vector<double> first = factors_of_component(plane, plane.first, samples);
  const std::vector<double> second = factors_of_component(plane, plane.second, samples);
  const Grid grid = parameters_.grid();
  Matrix<double> factors(training_.size(), padded());
  for (std::size_t neuron = 0; neuron < grid.size(); ++neuron) {
    const PlanePlace place = place_on_plane(grid, neuron);
    for (std::size_t item = 0; item < training_.size(); ++item) {
      factors(item, neuron) = 1.0 / static_cast<double>(training_.size()) +
                              place.first * first[item] + place.second * second[item];
    }
  }
  return factors;
}

std::size_t ProductProblem::padded() const {
  return (parameters_.grid().size() + kRowLanes - 1) / kRowLanes * kRowLanes;
}

// By sparse training samples.
std::vector<std::uint32_t> ProductProblem::used_elements() const {
  const SampleColumns& columns = known_->columns();
  std::vector<std::uint32_t> used;
  used.reserve(columns.elements().size());
  for (std::size_t c = 0; c < columns.elements().size(); ++c) {
    const auto samples = columns.samples().subspan(columns.starts()[c],
                                                   columns.starts()[c + 1] - columns.starts()[c]);
    const bool any = std::any_of(samples.begin(), samples.end(),
                                 [&](std::uint32_t sample) { return trained_[sample]; });
    if (any) used.push_back(columns.elements()[c]);
  }
  return used;
}

InitialRanges ProductProblem::ranges(const std::vector<std::uint32_t>& elements) const {
  if (!starts_at_random()) return {};
  if (parameters_.initial_weights == InitialWeights::kUniform) {
    return {std::vector<float>(elements.size(), 0.0F), std::vector<float>(elements.size(), 1.0F)};
  }
  return known_->samples().is_sparse() ? sparse_ranges(elements) : dense_ranges();
}

InitialRanges ProductProblem::dense_ranges() const {
  const auto first = known_->samples()[training_.front()].values;
  std::vector<float> low(first.begin(), first.end());
  std::vector<float> high = low;
  for (const std::size_t sample : training_) {
    const auto values = known_->samples()[sample].values;
    for (std::size_t d = 0; d < low.size(); ++d) {
      low[d] = std::min(low[d], values[d]);
      high[d] = std::max(high[d], values[d]);
    }
  }
  for (std::size_t d = 0; d < low.size(); ++d) high[d] -= low[d];
  return {std::move(low), std::move(high)};
}

// The ranges of elements that a training sample uses; zeros count.
InitialRanges ProductProblem::sparse_ranges(const std::vector<std::uint32_t>& elements) const {
  const SampleColumns& columns = known_->columns();
  const auto trained = static_cast<std::size_t>(std::count(trained_.begin(), trained_.end(), true));
  InitialRanges ranges;
  ranges.low.reserve(elements.size());
  ranges.span.reserve(elements.size());
  for (std::size_t c = 0; c < columns.elements().size(); ++c) {
    std::size_t values = 0;
    float low = 0.0F;
    float high = 0.0F;
    for (std::uint32_t k = columns.starts()[c]; k < columns.starts()[c + 1]; ++k) {
      if (!trained_[columns.samples()[k]]) continue;
      const float value = columns.values()[k];
      low = values == 0 ? value : std::min(low, value);
      high = values == 0 ? value : std::max(high, value);
      ++values;
    }
    if (values == 0) continue;
    if (values < trained) {
      low = std::min(low, 0.0F);
      high = std::max(high, 0.0F);
    }
    ranges.low.push_back(low);
    ranges.span.push_back(high - low);
  }
  return ranges;
}

WeightStrips ProductProblem::strips() const {
  const bool everywhere =
      !known_->samples().is_sparse() || parameters_.initial_weights == InitialWeights::kUniform;
  std::vector<std::uint32_t> elements = everywhere ? all_below(known_->samples().size()) : used_;
  std::vector<std::uint32_t> places = elements_.all() ? elements : all_below(elements.size());
  InitialRanges found = ranges(elements);
  return {parameters_, *known_, std::move(elements), std::move(places), std::move(found)};
}

ProductStart ProductProblem::start(std::size_t threads) const {
  const WeightStrips weights = strips();
  ProductStart start{AlignedVector<double>(known_->samples().count() * padded()),
                     AlignedVector<double>(padded())};
  for_each_range(padded() / kRowLanes, threads, [&](std::size_t begin, std::size_t end) {
    weights.add_products(begin, end, start.products, start.squared_lengths);
  });
  return start;
}

LaneMatrix<float> ProductProblem::form(std::span<const double> of_start,
                                       std::span<const double> coefficients,
                                       std::size_t threads) const {
  const WeightStrips strips = this->strips();
  LaneMatrix<float> weights(parameters_.grid().size(), elements_.count());
  for_each_range(padded() / kRowLanes, threads, [&](std::size_t begin, std::size_t end) {
    strips.form(begin, end, of_start, coefficients, weights);
  });
  return weights;
}

}  // namespace somato
