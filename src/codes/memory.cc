#include "somato/codes/memory.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "somato/core/check.h"

namespace somato {
namespace {

std::size_t size_of(const std::vector<std::size_t>& shape) {
  constexpr std::size_t kMostIndices = std::numeric_limits<std::uint32_t>::max();
  std::size_t size = 1;
  for (const std::size_t axis : shape) {
    require(axis == 0 || size <= kMostIndices / axis,
            "a memory can have at most 2^32 - 1 elements");
    size *= axis;
  }
  return size;
}

}  // namespace

const Declarations<MemoryParameters>& MemoryParameters::declarations() {
  using P = MemoryParameters;
  static const Declarations<P> kAll = Declarations<P>().add(
      "leak", &P::leak, "", Range::between(0, 1),
      "Share of what is held that a frame makes forgotten; 0: the sum of all frames, as in the "
      "papers. Above 0 not given in the paper.");
  return kAll;
}

Memory::Memory(std::vector<std::size_t> shape, const MemoryParameters& parameters)
    : shape_(std::move(shape)), size_(size_of(shape_)), keep_(1.0 - parameters.leak) {
  require(parameters.leak >= 0.0 && parameters.leak <= 1.0, "a memory leaks a share from 0 to 1");
}

void Memory::reset() {
  dense_ = false;
  sums_.clear();
  indices_.clear();
  places_.clear();
}

void Memory::add(const SignalView& frame) {
  require(frame.size == size_, "a frame has another size than the memory it is added to");
  if (!frame.sparse && !dense_) become_dense();
  if (keep_ != 1.0) {
    for (double& sum : sums_) sum *= keep_;
  }
  if (frame.sparse) return add_sparse(frame);
  for (std::size_t i = 0; i < size_; ++i) sums_[i] += double{frame.values[i]};
}

void Memory::add_sparse(const SignalView& frame) {
  for (std::size_t i = 0; i < frame.indices.size(); ++i) {
    std::size_t place = frame.indices[i];
    if (!dense_) {
      const auto [entry, is_new] = places_.try_emplace(frame.indices[i], sums_.size());
      place = entry->second;
      if (is_new) {
        indices_.push_back(frame.indices[i]);
        sums_.push_back(0.0);
      }
    }
    sums_[place] += double{frame.values[i]};
  }
}

void Memory::become_dense() {
  std::vector<double> all(size_, 0.0);
  for (std::size_t i = 0; i < sums_.size(); ++i) all[indices_[i]] = sums_[i];
  reset();
  sums_ = std::move(all);
  dense_ = true;
}

Signal Memory::value() const {
  SignalBuffer held;
  write(held);
  const SignalView view = held.view();
  if (dense_) return Signal::dense(shape_, std::move(held.values()));
  return Signal::sparse(shape_, {view.indices.begin(), view.indices.end()},
                        std::move(held.values()));
}

void Memory::write(SignalBuffer& out) const {
  if (!dense_) return write_sparse(out);
  std::ranges::transform(sums_, out.begin_dense(size_).begin(),
                         [](double sum) { return static_cast<float>(sum); });
}

void Memory::write_sparse(SignalBuffer& out) const {
  std::vector<std::uint32_t> indices = indices_;
  std::ranges::sort(indices);
  out.begin_sparse(size_);
  for (const std::uint32_t index : indices) {
    out.add(index, static_cast<float>(sums_[places_.at(index)]));
  }
}

}  // namespace somato
