#include "maps/t_mpsom/t_mpsom_receptive_input.h"

#include <algorithm>
#include <cmath>

#include "base/kernels/kernels.h"
#include "somato/core/check.h"

namespace somato {
namespace {

// The place in the signal of its stored value number i.
std::uint32_t index_of(const SignalView& signal, std::size_t i) {
  return signal.sparse ? signal.indices[i] : static_cast<std::uint32_t>(i);
}

double length_of(std::span<const float> values, TMpsomNorm norm) {
  double squared = 0.0;
  for (const float value : values) squared += double{value} * double{value};  // exact products
  require(std::isfinite(squared), "T-MPSOM: an input contains a value that is not finite");
  return norm == TMpsomNorm::kL2 && squared > 0.0 ? std::sqrt(squared) : 1.0;
}

}  // namespace

TMpsomReceptiveInput::TMpsomReceptiveInput(std::size_t elements, std::size_t padded_neurons)
    : indices_(elements),
      values_(elements),
      normalized_(elements),
      ranks_(elements + 1),
      partial_(padded_neurons) {}

bool TMpsomReceptiveInput::is_again(const SignalView& signal) const {
  std::size_t at = 0;
  for (std::size_t i = 0; i < signal.values.size(); ++i) {
    if (signal.values[i] == 0.0F) continue;
    if (at == count_ || values_[at] != signal.values[i] || indices_[at] != index_of(signal, i)) {
      return false;
    }
    ++at;
  }
  return at == count_;
}

void TMpsomReceptiveInput::take(const SignalView& signal, TMpsomNorm norm) {
  const double length = length_of(signal.values, norm);
  state_ = 0;
  count_ = take_elements(signal);
  const double least = norm == TMpsomNorm::kL2 ? double{kernels::kNegligible<float>} : 0.0;
  double squared = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    const double value = double{values_[i]} / length;
    normalized_[i] = std::fabs(value) < least ? 0.0F : static_cast<float>(value);
    squared += double{normalized_[i]} * double{normalized_[i]};
  }
  squared_length_ = static_cast<float>(squared);
}

std::size_t TMpsomReceptiveInput::take_elements(const SignalView& signal) {
  std::size_t count = 0;
  std::size_t element = 0;
  for (std::size_t i = 0; i < signal.values.size(); ++i) {
    const std::uint32_t index = index_of(signal, i);
    for (; element <= index; ++element) ranks_[element] = static_cast<std::uint32_t>(count);
    indices_[count] = index;
    values_[count] = signal.values[i];
    count += signal.values[i] != 0.0F ? 1 : 0;
  }
  for (; element < ranks_.size(); ++element) ranks_[element] = static_cast<std::uint32_t>(count);
  return count;
}

TMpsomReceptiveInput::Elements TMpsomReceptiveInput::elements(std::size_t first,
                                                              std::size_t end) const {
  const std::size_t begin = ranks_[first];
  return {indices_.data() + begin, normalized_.data() + begin, ranks_[end] - begin};
}

void TMpsomReceptiveInput::write_dense(std::span<float> out) const {
  std::fill_n(out.begin(), size(), 0.0F);
  for (std::size_t i = 0; i < count_; ++i) out[indices_[i]] = normalized_[i];
}

}  // namespace somato
