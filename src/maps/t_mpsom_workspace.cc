#include <algorithm>
#include <cmath>

#include "somato/core/check.h"
#include "somato/maps/t_mpsom.h"

namespace somato {
namespace {

// The place in the signal of its stored value number i.
std::uint32_t index_of(const SignalView& signal, std::size_t i) {
  return signal.sparse ? signal.indices[i] : static_cast<std::uint32_t>(i);
}

double length_of(std::span<const float> values, TMpsomNorm norm) {
  double squared = 0.0;
  for (const float value : values) squared += double{value} * double{value};  // exact products
  require(std::isfinite(squared), "T-MPSOM: an input holds a value that is not finite");
  return norm == TMpsomNorm::kL2 && squared > 0.0 ? std::sqrt(squared) : 1.0;
}

}  // namespace

TMpsom::Workspace::Heard::Heard(std::size_t elements, std::size_t padded_neurons)
    : indices(elements),
      values(elements),
      normalized(elements),
      ranks(elements + 1),
      partial(padded_neurons) {}

// Whether no element is another than in the last signal; NaN is another than itself.
bool TMpsom::Workspace::Heard::is_again(const SignalView& signal) const {
  std::size_t at = 0;
  for (std::size_t i = 0; i < signal.values.size(); ++i) {
    if (signal.values[i] == 0.0F) continue;
    if (at == count || values[at] != signal.values[i] || indices[at] != index_of(signal, i)) {
      return false;
    }
    ++at;
  }
  return at == count;
}

void TMpsom::Workspace::Heard::take(const SignalView& signal, TMpsomNorm norm) {
  const double length = length_of(signal.values, norm);  // or throws, and nothing is changed
  state = 0;
  count = 0;
  std::size_t element = 0;
  for (std::size_t i = 0; i < signal.values.size(); ++i) {
    const std::uint32_t index = index_of(signal, i);
    for (; element <= index; ++element) ranks[element] = static_cast<std::uint32_t>(count);
    indices[count] = index;
    values[count] = signal.values[i];
    count += signal.values[i] != 0.0F ? 1 : 0;
  }
  for (; element < ranks.size(); ++element) ranks[element] = static_cast<std::uint32_t>(count);
  for (std::size_t i = 0; i < count; ++i) {
    normalized[i] = static_cast<float>(double{values[i]} / length);
  }
}

// Writes all elements, normalized, to the front of `out`.
void TMpsom::Workspace::Heard::write_dense(std::span<float> out) const {
  std::fill_n(out.begin(), values.size(), 0.0F);
  for (std::size_t i = 0; i < count; ++i) out[indices[i]] = normalized[i];
}

}  // namespace somato
