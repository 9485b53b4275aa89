#include "somato/maps/som.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

#include "maps/grid/element_set.h"
#include "somato/core/check.h"

namespace somato {
namespace {

// Calls `stored(place, value)` or `other(value)` for each value of `signal` in order.
template <typename Stored, typename Other>
void split(std::span<const std::uint32_t> listed, const SignalView& signal, const Stored& stored,
           const Other& other) {
  std::size_t place = 0;
  for (std::size_t i = 0; i < signal.values.size(); ++i) {
    const std::size_t element = signal.sparse ? signal.indices[i] : i;
    while (place < listed.size() && listed[place] < element) ++place;
    if (place < listed.size() && listed[place] == element) {
      stored(place, signal.values[i]);
    } else {
      other(signal.values[i]);
    }
  }
}

}  // namespace

StoredElements::StoredElements(std::size_t size, std::vector<std::uint32_t> listed)
    : size_(size), listed_(std::move(listed)) {
  require(possible_list(size_, listed_), "stored elements must ascend and lie inside the input");
}

StoredElements StoredElements::used_by(const Samples& samples) {
  if (!samples.is_sparse()) return StoredElements(samples.size());
  return worth_storing(samples.size(), ElementSet(samples).listed());
}

StoredElements StoredElements::worth_storing(std::size_t size, std::vector<std::uint32_t> used) {
  if (used.empty()) used.push_back(0);
  if (2 * used.size() >= size) return StoredElements(size);
  return {size, std::move(used)};
}

StoredElements StoredElements::with(const SignalView& signal) const {
  require(signal.size == size_, "stored elements are selected from an input of another size");
  if (all()) return *this;
  std::vector<std::uint32_t> others;
  for (std::size_t i = 0; i < signal.values.size(); ++i) {
    const auto element = signal.sparse ? signal.indices[i] : static_cast<std::uint32_t>(i);
    if (signal.values[i] != 0.0F) others.push_back(element);
  }
  std::vector<std::uint32_t> used;
  used.reserve(listed_.size() + others.size());
  std::set_union(listed_.begin(), listed_.end(), others.begin(), others.end(),
                 std::back_inserter(used));
  return worth_storing(size_, std::move(used));
}

bool StoredElements::possible_list(std::size_t size, std::span<const std::uint32_t> listed) {
  const bool ascends =
      std::adjacent_find(listed.begin(), listed.end(), std::greater_equal<>()) == listed.end();
  return ascends && !listed.empty() && listed.back() < size;
}

std::optional<std::size_t> StoredElements::place_of(std::size_t element) const {
  require(element < size_, "an element does not exist");
  if (all()) return element;
  const auto found = std::lower_bound(listed_.begin(), listed_.end(), element);
  if (found == listed_.end() || *found != element) return {};
  return static_cast<std::size_t>(found - listed_.begin());
}

double StoredElements::gather(const SignalView& signal, std::span<float> out, double factor) const {
  require(signal.size == size_ && out.size() == count(),
          "stored elements are selected from an input of another size");
  const auto scaled = [&](float value) { return static_cast<float>(value * factor); };
  if (all()) {
    write_dense(signal, out);
    std::transform(out.begin(), out.end(), out.begin(), scaled);
    return 0.0;
  }
  double others = 0.0;
  std::fill(out.begin(), out.end(), 0.0F);
  split(
      listed_, signal, [&](std::size_t place, float value) { out[place] = scaled(value); },
      [&](float value) {
        const double other = scaled(value);
        others = std::fma(other, other, others);
      });
  return others;
}

double StoredElements::magnitude_of_others(const SignalView& signal, double factor) const {
  if (all()) return 0.0;
  double others = 0.0;
  split(
      listed_, signal, [](std::size_t /*place*/, float /*value*/) {},
      [&](float value) { others += std::fabs(double{static_cast<float>(value * factor)}); });
  return others;
}

Samples StoredElements::gather(const Samples& samples) const {
  constexpr std::size_t kEmptyEnough = 16;  // what a sparse value costs more than a dense one
  std::vector<Signal> gathered;
  gathered.reserve(samples.count());
  const bool sparse =
      samples.is_sparse() && stored_values(samples) * kEmptyEnough < samples.count() * count();
  if (sparse && all()) return samples;
  for (std::size_t i = 0; i < samples.count(); ++i) {
    gathered.push_back(sparse ? sparse_of(samples[i]) : dense_of(samples[i]));
  }
  return Samples::from_signals(gathered);
}

Signal StoredElements::dense_of(const SignalView& signal) const {
  std::vector<float> values(count());
  gather(signal, values);
  return Signal::dense(std::move(values));
}

Signal StoredElements::sparse_of(const SignalView& signal) const {
  require(!all() && signal.size == size_,
          "stored elements are selected from samples of another size");
  std::vector<std::uint32_t> places;
  std::vector<float> values;
  places.reserve(signal.values.size());
  values.reserve(signal.values.size());
  split(
      listed_, signal,
      [&](std::size_t place, float value) {
        places.push_back(static_cast<std::uint32_t>(place));
        values.push_back(value);
      },
      [](float /*other*/) {});
  return Signal::sparse({count()}, std::move(places), std::move(values));
}

}  // namespace somato
