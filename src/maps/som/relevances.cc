#include "maps/som/relevances.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "maps/som/map_parts.h"
#include "maps/som/map_rows.h"
#include "somato/core/check.h"
#include "somato/maps/som.h"

namespace somato {
namespace {

bool takes_relevances(const SomParameters& parameters) {
  return parameters.layers.empty() && (parameters.similarity == Similarity::kEuclidean ||
                                       parameters.similarity == Similarity::kManhattan);
}

}  // namespace

bool are_relevances(std::span<const double> relevances) {
  constexpr double kLeast = 1e-12;
  constexpr double kMost = 1e12;
  return std::all_of(relevances.begin(), relevances.end(),
                     [](double value) { return value >= kLeast && value <= kMost; });
}

std::vector<float> scales_of_relevances(const SomParameters& parameters) {
  std::vector<float> scales;
  scales.reserve(parameters.relevances.size());
  for (const double relevance : parameters.relevances) {
    const bool is_squared = parameters.similarity == Similarity::kEuclidean;
    scales.push_back(static_cast<float>(is_squared ? std::sqrt(relevance) : relevance));
  }
  return scales;
}

void scale_elements(std::span<const float> scales, std::span<float> values) {
  for (std::size_t d = 0; d < scales.size(); ++d) values[d] *= scales[d];
}

void add_relevances(Archive& archive, const std::string& name, const SomParameters& parameters) {
  if (parameters.relevances.empty()) return;
  archive.add(name, Array<double>{{parameters.relevances.size()}, parameters.relevances});
}

Result<std::vector<double>> relevances_from(const Archive& archive, const std::string& name,
                                            const SomParameters& parameters, std::size_t elements,
                                            const std::string& where) {
  if (!archive.find(name)) return std::vector<double>();
  SOMATO_TRY(const auto found, archive.get<Array<double>>(name, where));
  const Array<double>& array = *found;
  const bool is_possible = array.shape == std::vector<std::uint64_t>{elements} &&
                           are_relevances(array.values) && takes_relevances(parameters);
  if (is_possible) return array.values;
  return damaged_model("'" + name + "' are not relevances of the map's elements", where);
}

void Som::set_relevances(std::vector<double> relevances) {
  require(takes_relevances(parameters_),
          "relevances are defined for Euclidean and Manhattan maps without layers");
  require(relevances.size() == input_size() && are_relevances(relevances),
          "a map needs a relevance from 1e-12 to 1e12 for each element");
  store_all();
  LaneMatrix<float>& weights = weights_to_change(*this);
  const std::vector<float> before = std::move(input_scales_);
  parameters_.relevances = std::move(relevances);
  input_scales_ = scales_of_relevances(parameters_);
  for (std::size_t neuron = 0; neuron < neurons(); ++neuron) {
    for (std::size_t d = 0; d < input_scales_.size(); ++d) {
      const double factor = before.empty() ? 1.0 : 1.0 / double{before[d]};
      float& weight = weights(neuron, d);
      weight = static_cast<float>(double{weight} * (double{input_scales_[d]} * factor));
    }
  }
}

}  // namespace somato
