#include "somato/core/signal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/kernels/kernels.h"
#include "somato/core/check.h"

namespace somato {
namespace {

std::size_t element_count(const std::vector<std::size_t>& shape) {
  std::size_t count = 1;
  for (const std::size_t extent : shape) {
    require(extent == 0 || count <= std::numeric_limits<std::size_t>::max() / extent,
            "a signal's shape has too many elements");
    count *= extent;
  }
  return count;
}

bool ascends_below(const std::vector<std::uint32_t>& indices, std::size_t size) {
  const bool ascends =
      std::adjacent_find(indices.begin(), indices.end(), std::greater_equal<>()) == indices.end();
  return ascends && (indices.empty() || indices.back() < size);
}

double sparse_by_sparse(const SignalView& a, const SignalView& b) {
  double sum = 0.0;
  std::size_t i = 0;
  std::size_t j = 0;
  while (i < a.indices.size() && j < b.indices.size()) {
    if (a.indices[i] == b.indices[j]) {
      sum = std::fma(double{a.values[i++]}, double{b.values[j++]}, sum);
    } else if (a.indices[i] < b.indices[j]) {
      ++i;
    } else {
      ++j;
    }
  }
  return sum;
}

double sparse_by_dense(const SignalView& sparse, const SignalView& dense) {
  return kernels::table<float>().sparse_product(sparse.indices.data(), sparse.values.data(),
                                                sparse.indices.size(), dense.values.data());
}

double dense_by_dense(const SignalView& a, const SignalView& b) {
  return kernels::table<float>().product(a.values.data(), b.values.data(), a.size);
}

}  // namespace

Signal Signal::dense(std::vector<std::size_t> shape, std::vector<float> values) {
  Signal signal;
  signal.size_ = element_count(shape);
  require(signal.size_ == values.size(), "a dense signal needs one value for each element");
  signal.shape_ = std::move(shape);
  signal.values_ = std::move(values);
  return signal;
}

Signal Signal::dense(std::vector<float> values) {
  std::vector<std::size_t> shape{values.size()};
  return dense(std::move(shape), std::move(values));
}

Signal Signal::copy_of(const SignalView& view) {
  return copy_of(view, {view.size});
}

Signal Signal::copy_of(const SignalView& view, std::vector<std::size_t> shape) {
  std::vector<float> values(view.values.begin(), view.values.end());
  if (!view.sparse) return dense(std::move(shape), std::move(values));
  return sparse(std::move(shape), {view.indices.begin(), view.indices.end()}, std::move(values));
}

Signal Signal::sparse(std::vector<std::size_t> shape, std::vector<std::uint32_t> indices,
                      std::vector<float> values) {
  Signal signal;
  signal.size_ = element_count(shape);
  require(indices.size() == values.size(), "a sparse signal needs one value for each index");
  require(ascends_below(indices, signal.size_),
          "the indices of a sparse signal must ascend and lie inside its shape");
  signal.shape_ = std::move(shape);
  signal.sparse_ = true;
  signal.indices_ = std::move(indices);
  signal.values_ = std::move(values);
  return signal;
}

std::vector<float> Signal::to_dense() const {
  std::vector<float> all(size_);
  write_dense(view(), all);
  return all;
}

void write_dense(const SignalView& signal, std::span<float> out) {
  require(out.size() == signal.size, "write_dense: the sizes differ");
  if (!signal.sparse) {
    std::copy(signal.values.begin(), signal.values.end(), out.begin());
    return;
  }
  std::fill(out.begin(), out.end(), 0.0F);
  for (std::size_t i = 0; i < signal.indices.size(); ++i) out[signal.indices[i]] = signal.values[i];
}

double inner_product(const SignalView& a, const SignalView& b) {
  require(a.size == b.size, "inner_product: the sizes differ");
  if (a.sparse && b.sparse) return sparse_by_sparse(a, b);
  if (a.sparse) return sparse_by_dense(a, b);
  if (b.sparse) return sparse_by_dense(b, a);
  return dense_by_dense(a, b);
}

std::vector<float>& SignalBuffer::begin_dense(std::size_t size) {
  size_ = size;
  sparse_ = false;
  indices_.clear();
  values_.resize(size);
  return values_;
}

void SignalBuffer::begin_sparse(std::size_t size) {
  size_ = size;
  sparse_ = true;
  indices_.clear();
  values_.clear();
}

void SignalBuffer::assign(const SignalView& signal) {
  size_ = signal.size;
  sparse_ = signal.sparse;
  indices_.assign(signal.indices.begin(), signal.indices.end());
  values_.assign(signal.values.begin(), signal.values.end());
}

}  // namespace somato
