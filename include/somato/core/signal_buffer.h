#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "somato/core/signal.h"

namespace somato {

/// Room for one flat signal after another. It grows until it holds the largest of them and is then
/// filled without any allocation.
class SignalBuffer {
 public:
  /// Begins a dense signal; its elements are what they were, or 0.
  std::vector<float>& begin_dense(std::size_t size);

  /// Begins a sparse signal without elements.
  void begin_sparse(std::size_t size);

  /// Adds an element to a sparse signal, after all others.
  void add(std::uint32_t index, float value) {
    indices_.push_back(index);
    values_.push_back(value);
  }

  /// A copy of that signal.
  void assign(const SignalView& signal);

  std::vector<float>& values() { return values_; }

  /// Valid until the buffer is filled anew.
  SignalView view() const { return {size_, sparse_, indices_, values_}; }

 private:
  std::size_t size_ = 0;
  bool sparse_ = false;
  std::vector<std::uint32_t> indices_;
  std::vector<float> values_;
};

}  // namespace somato
