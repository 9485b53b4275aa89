#include "somato/codes/tensor_product.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "somato/core/check.h"

namespace somato {
namespace {

struct NonZeros {
  std::vector<std::uint32_t> indices;
  std::vector<float> values;

  void add(std::uint32_t index, float value) {
    if (value == 0.0F) return;
    indices.push_back(index);
    values.push_back(value);
  }
};

NonZeros non_zeros(const Signal& signal) {
  NonZeros found;
  for (std::size_t i = 0; i < signal.values().size(); ++i) {
    const std::uint32_t index =
        signal.is_sparse() ? signal.indices()[i] : static_cast<std::uint32_t>(i);
    found.add(index, signal.values()[i]);
  }
  return found;
}

NonZeros product(const NonZeros& left, const NonZeros& right, std::size_t right_size) {
  NonZeros products;
  for (std::size_t i = 0; i < left.indices.size(); ++i) {
    const auto row_start = static_cast<std::uint32_t>(left.indices[i] * right_size);
    for (std::size_t j = 0; j < right.indices.size(); ++j) {
      products.add(row_start + right.indices[j], left.values[i] * right.values[j]);
    }
  }
  return products;
}

std::vector<float> product(std::span<const float> left, std::span<const float> right) {
  std::vector<float> products;
  products.reserve(left.size() * right.size());
  for (const float x : left) {
    for (const float y : right) products.push_back(x * y);
  }
  return products;
}

std::vector<std::size_t> joined_shape(std::span<const Signal> inputs) {
  std::vector<std::size_t> shape;
  for (const Signal& input : inputs) {
    shape.insert(shape.end(), input.shape().begin(), input.shape().end());
  }
  return shape;
}

void require_countable(std::span<const Signal> inputs) {
  std::uint64_t total = 1;
  for (const Signal& input : inputs) {
    require(input.size() == 0 ||
                total <= std::numeric_limits<std::uint32_t>::max() / std::uint64_t{input.size()},
            "a tensor product can have at most 2^32 - 1 elements");
    total *= input.size();
  }
}

Signal sparse_product(std::span<const Signal> inputs) {
  NonZeros all = non_zeros(inputs.front());
  for (const Signal& input : inputs.subspan(1)) all = product(all, non_zeros(input), input.size());
  return Signal::sparse(joined_shape(inputs), std::move(all.indices), std::move(all.values));
}

Signal dense_product(std::span<const Signal> inputs) {
  std::vector<float> all(inputs.front().values().begin(), inputs.front().values().end());
  for (const Signal& input : inputs.subspan(1)) all = product(all, input.values());
  return Signal::dense(joined_shape(inputs), std::move(all));
}

}  // namespace

Signal tensor_product(std::span<const Signal> inputs) {
  require(!inputs.empty(), "a tensor product needs at least one signal");
  require_countable(inputs);
  const bool sparse = std::any_of(inputs.begin(), inputs.end(),
                                  [](const Signal& input) { return input.is_sparse(); });
  return sparse ? sparse_product(inputs) : dense_product(inputs);
}

}  // namespace somato
