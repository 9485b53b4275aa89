#include "somato/codes/tensor_product.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "somato/core/check.h"

namespace somato {
namespace {

void require_countable(std::span<const SignalView> inputs) {
  std::uint64_t total = 1;
  for (const SignalView& input : inputs) {
    require(input.size == 0 ||
                total <= std::numeric_limits<std::uint32_t>::max() / std::uint64_t{input.size},
            "a tensor product can have at most 2^32 - 1 elements");
    total *= input.size;
  }
}

// Adds `factor` times the elements of `signal` that are not zero, the first of them at `start`.
void add_non_zeros(std::uint32_t start, float factor, const SignalView& signal, SignalBuffer& out) {
  for (std::size_t i = 0; i < signal.values.size(); ++i) {
    const float value = factor * signal.values[i];
    if (value == 0.0F) continue;
    out.add(start + (signal.sparse ? signal.indices[i] : static_cast<std::uint32_t>(i)), value);
  }
}

void sparse_product(const SignalView& left, const SignalView& right, SignalBuffer& out) {
  out.begin_sparse(left.size * right.size);
  for (std::size_t i = 0; i < left.values.size(); ++i) {
    const auto start = static_cast<std::uint32_t>(left.indices[i] * right.size);
    add_non_zeros(start, left.values[i], right, out);
  }
}

void dense_product(const SignalView& left, const SignalView& right, SignalBuffer& out) {
  float* element = out.begin_dense(left.size * right.size).data();
  for (const float x : left.values) {
    for (const float y : right.values) *element++ = x * y;
  }
}

}  // namespace

void tensor_product(std::span<const SignalView> inputs, SignalBuffer& scratch, SignalBuffer& out) {
  require(!inputs.empty(), "a tensor product needs at least one signal");
  require_countable(inputs);
  const bool sparse = std::any_of(inputs.begin(), inputs.end(),
                                  [](const SignalView& input) { return input.sparse; });
  if (sparse) {
    out.begin_sparse(inputs.front().size);
    add_non_zeros(0, 1.0F, inputs.front(), out);
  } else {
    out.assign(inputs.front());
  }
  for (const SignalView& input : inputs.subspan(1)) {
    std::swap(scratch, out);
    (sparse ? sparse_product : dense_product)(scratch.view(), input, out);
  }
}

Signal tensor_product(std::span<const Signal> inputs) {
  std::vector<SignalView> views;
  std::vector<std::size_t> shape;
  views.reserve(inputs.size());
  for (const Signal& input : inputs) {
    views.push_back(input.view());
    shape.insert(shape.end(), input.shape().begin(), input.shape().end());
  }
  SignalBuffer scratch;
  SignalBuffer out;
  tensor_product(views, scratch, out);
  return Signal::copy_of(out.view(), std::move(shape));
}

}  // namespace somato
