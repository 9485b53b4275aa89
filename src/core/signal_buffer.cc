#include "somato/core/signal_buffer.h"

namespace somato {

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
