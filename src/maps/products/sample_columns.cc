#include "maps/products/sample_columns.h"

#include <numeric>

#include "maps/grid/element_set.h"

namespace somato {

SampleColumns::SampleColumns(const Samples& sparse) {
  const ElementSet set(sparse);
  elements_ = set.listed();
  starts_.resize(elements_.size() + 1);
  std::vector<std::uint32_t> columns;
  for (std::size_t s = 0; s < sparse.count(); ++s) {
    for (const std::uint32_t element : sparse[s].indices) {
      columns.push_back(static_cast<std::uint32_t>(set.place_of(element)));
      ++starts_[columns.back() + 1];
    }
  }
  std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
  samples_.resize(columns.size());
  values_.resize(columns.size());
  std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
  std::size_t read = 0;
  for (std::size_t s = 0; s < sparse.count(); ++s) {
    for (const float value : sparse[s].values) {
      const std::uint32_t at = next[columns[read++]]++;
      samples_[at] = static_cast<std::uint32_t>(s);
      values_[at] = value;
    }
  }
}

}  // namespace somato
