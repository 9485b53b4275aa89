#include "maps/grid/element_set.h"

#include <algorithm>
#include <bit>

namespace somato {
namespace {

constexpr std::size_t kBits = 64;
constexpr std::size_t kBitsWorthAValue = 1024;

}  // namespace

std::size_t stored_values(const Samples& samples) {
  std::size_t values = 0;
  for (std::size_t i = 0; i < samples.count(); ++i) values += samples[i].values.size();
  return values;
}

ElementSet::ElementSet(const Samples& sparse) {
  const std::size_t values = stored_values(sparse);
  if (sparse.size() <= kBitsWorthAValue * (values + 1)) {
    mark(sparse);
  } else {
    sort(sparse, values);
  }
}

void ElementSet::mark(const Samples& sparse) {
  words_.resize(sparse.size() / kBits + 1);
  for (std::size_t i = 0; i < sparse.count(); ++i) {
    for (const std::uint32_t element : sparse[i].indices) {
      words_[element / kBits] |= std::uint64_t{1} << (element % kBits);
    }
  }
  std::size_t count = 0;
  before_.reserve(words_.size());
  for (const std::uint64_t word : words_) {
    before_.push_back(static_cast<std::uint32_t>(count));
    count += static_cast<std::size_t>(std::popcount(word));
  }
  listed_.reserve(count);
  for (std::size_t i = 0; i < words_.size(); ++i) {
    for (std::uint64_t left = words_[i]; left != 0; left &= left - 1) {
      const auto bit = static_cast<std::size_t>(std::countr_zero(left));
      listed_.push_back(static_cast<std::uint32_t>(i * kBits + bit));
    }
  }
}

void ElementSet::sort(const Samples& sparse, std::size_t values) {
  listed_.reserve(values);
  for (std::size_t i = 0; i < sparse.count(); ++i) {
    const auto indices = sparse[i].indices;
    listed_.insert(listed_.end(), indices.begin(), indices.end());
  }
  std::sort(listed_.begin(), listed_.end());
  listed_.erase(std::unique(listed_.begin(), listed_.end()), listed_.end());
}

std::size_t ElementSet::place_of(std::uint32_t element) const {
  if (words_.empty()) {
    const auto found = std::lower_bound(listed_.begin(), listed_.end(), element);
    return static_cast<std::size_t>(found - listed_.begin());
  }
  const std::uint64_t lower = (std::uint64_t{1} << (element % kBits)) - 1;
  return before_[element / kBits] +
         static_cast<std::size_t>(std::popcount(words_[element / kBits] & lower));
}

}  // namespace somato
