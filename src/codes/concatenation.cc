#include "somato/codes/concatenation.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "somato/core/check.h"

namespace somato {
namespace {

constexpr std::size_t kMostElements = std::numeric_limits<std::uint32_t>::max();

std::size_t total_size(std::span<const Signal> inputs) {
  std::size_t total = 0;
  for (const Signal& input : inputs) {
    require(input.size() <= kMostElements - total,
            "a concatenation can have at most 2^32 - 1 elements");
    total += input.size();
  }
  return total;
}

Signal sparse_concatenation(std::span<const Signal> inputs, std::size_t size) {
  std::vector<std::uint32_t> indices;
  std::vector<float> values;
  std::size_t start = 0;
  for (const Signal& input : inputs) {
    for (const std::uint32_t index : input.indices()) {
      indices.push_back(static_cast<std::uint32_t>(start + index));
    }
    values.insert(values.end(), input.values().begin(), input.values().end());
    start += input.size();
  }
  return Signal::sparse({size}, std::move(indices), std::move(values));
}

Signal dense_concatenation(std::span<const Signal> inputs, std::size_t size) {
  std::vector<float> values(size);
  std::span<float> rest = values;
  for (const Signal& input : inputs) {
    write_dense(input.view(), rest.first(input.size()));
    rest = rest.subspan(input.size());
  }
  return Signal::dense(std::move(values));
}

}  // namespace

Signal concatenation(std::span<const Signal> inputs) {
  require(!inputs.empty(), "a concatenation needs at least one signal");
  const std::size_t size = total_size(inputs);
  const bool sparse = std::all_of(inputs.begin(), inputs.end(),
                                  [](const Signal& input) { return input.is_sparse(); });
  return sparse ? sparse_concatenation(inputs, size) : dense_concatenation(inputs, size);
}

}  // namespace somato
