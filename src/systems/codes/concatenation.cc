#include "somato/codes/concatenation.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "somato/core/check.h"

namespace somato {
namespace {

constexpr std::size_t kMostJoined = std::numeric_limits<std::uint32_t>::max();

std::size_t total_size(std::span<const SignalView> inputs) {
  std::size_t total = 0;
  for (const SignalView& input : inputs) {
    require(input.size <= kMostJoined - total,
            "a concatenation can have at most 2^32 - 1 elements");
    total += input.size;
  }
  return total;
}

void write_sparse(std::span<const SignalView> inputs, SignalBuffer& out) {
  std::uint32_t start = 0;
  for (const SignalView& input : inputs) {
    for (std::size_t i = 0; i < input.indices.size(); ++i) {
      out.add(start + input.indices[i], input.values[i]);
    }
    start += static_cast<std::uint32_t>(input.size);
  }
}

void write_all(std::span<const SignalView> inputs, std::span<float> out) {
  for (const SignalView& input : inputs) {
    write_dense(input, out.first(input.size));
    out = out.subspan(input.size);
  }
}

}  // namespace

void concatenation(std::span<const SignalView> inputs, SignalBuffer& out) {
  require(!inputs.empty(), "a concatenation needs at least one signal");
  const std::size_t size = total_size(inputs);
  const bool sparse = std::all_of(inputs.begin(), inputs.end(),
                                  [](const SignalView& input) { return input.sparse; });
  if (!sparse) return write_all(inputs, out.begin_dense(size));
  out.begin_sparse(size);
  write_sparse(inputs, out);
}

Signal concatenation(std::span<const Signal> inputs) {
  std::vector<SignalView> views;
  views.reserve(inputs.size());
  for (const Signal& input : inputs) views.push_back(input.view());
  SignalBuffer out;
  concatenation(views, out);
  return Signal::copy_of(out.view());
}

}  // namespace somato
