#include "maps/t_mpsom/t_mpsom_arbor.h"

#include <algorithm>
#include <map>

#include "base/core/elementary.h"
#include "base/kernels/kernels.h"

namespace somato {
namespace {

// Places and elements count from 1 (P06): counted from 0 the receptive fields would be shifted by
// up to one neuron.
Matrix<float> arbor_by_place(const TMpsomParameters& parameters, std::size_t input) {
  const std::size_t places = parameters.shape[parameters.axes()[input]];
  const std::size_t elements = parameters.input_sizes[input];
  const double ratio = static_cast<double>(places) / static_cast<double>(elements);
  const double twice_variance = 2.0 * parameters.arbor_sigma * parameters.arbor_sigma;
  Matrix<float> arbor(places, elements);
  for (std::size_t place = 0; place < places; ++place) {
    for (std::size_t k = 0; k < elements; ++k) {
      const double distance = static_cast<double>(place + 1) - ratio * static_cast<double>(k + 1);
      const double value = exponential(-distance * distance / twice_variance);
      const bool matters = value >= kernels::kNegligible<float>;
      arbor(place, k) = matters ? static_cast<float>(value) : 0.0F;
    }
  }
  return arbor;
}

}  // namespace

TMpsomArbor::TMpsomArbor(const TMpsomParameters& parameters, std::size_t input)
    : by_place_(arbor_by_place(parameters, input)), places_(parameters.neurons()) {
  const std::size_t axis = parameters.axes()[input];
  for (std::size_t n = 0; n < places_.size(); ++n) places_[n] = parameters.place(n, axis);
  std::map<std::vector<std::size_t>, std::size_t> known;
  for (std::size_t first = 0; first < places_.size(); first += kNeurons) {
    const auto begin = places_.begin() + static_cast<std::ptrdiff_t>(first);
    const std::size_t count = std::min(kNeurons, places_.size() - first);
    const std::vector<std::size_t> places(begin, begin + static_cast<std::ptrdiff_t>(count));
    const auto [field, is_new] = known.try_emplace(places, fields_.size());
    if (is_new) fields_.push_back(make_field(places));
    field_of_.push_back(field->second);
  }
}

TMpsomArbor::Field TMpsomArbor::make_field(std::span<const std::size_t> places) const {
  Field field{elements(), 0, {}};
  for (const std::size_t place : places) {
    for (std::size_t k = 0; k < elements(); ++k) {
      if (by_place_(place, k) == 0.0F) continue;
      field.first = std::min(field.first, k);
      field.end = std::max(field.end, k + 1);
    }
  }
  field.first = std::min(field.first, field.end);  // they may see nothing
  field.mask = LaneMatrix<float>(places.size(), field.end - field.first);
  for (std::size_t n = 0; n < places.size(); ++n) {
    const auto seen = by_place_.row(places[n]).subspan(field.first, field.end - field.first);
    field.mask.set_row(n, seen);
  }
  return field;
}

Matrix<float> TMpsomArbor::to_matrix() const {
  Matrix<float> arbor(neurons(), elements());
  for (std::size_t n = 0; n < neurons(); ++n) {
    const auto row = by_place_.row(places_[n]);
    std::copy(row.begin(), row.end(), arbor.row(n).begin());
  }
  return arbor;
}

}  // namespace somato
