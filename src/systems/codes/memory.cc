#include "somato/codes/memory.h"

#include <algorithm>
#include <bit>
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
      "Share of the memory that decays with each frame; 0: the sum of all frames, as in the "
      "papers. Above 0 not given in the paper.");
  return kAll;
}

Memory::Memory(std::vector<std::size_t> shape, const MemoryParameters& parameters)
    : shape_(std::move(shape)), size_(size_of(shape_)), keep_(1.0 - parameters.leak) {
  require(parameters.leak >= 0.0 && parameters.leak <= 1.0,
          "the leak of a memory must be from 0 to 1");
}

void Memory::Page::clear() {
  sums.fill(0.0);
  stored.fill(0);
}

void Memory::Page::add(std::size_t place, double value) {
  sums[place] += value;
  stored[place / 64] |= std::uint64_t{1} << (place % 64);
}

void Memory::reset() {
  dense_ = false;
  sums_.clear();
  std::fill(page_numbers_.begin(), page_numbers_.end(), 0);
  pages_used_ = 0;
}

void Memory::add(const SignalView& frame) {
  require(frame.size == size_, "the sizes of the frame and of the memory differ");
  if (!frame.sparse && !dense_) become_dense();
  if (keep_ != 1.0) decay();
  if (frame.sparse) return add_sparse(frame);
  for (std::size_t i = 0; i < size_; ++i) sums_[i] += double{frame.values[i]};
}

void Memory::decay() {
  for (double& sum : sums_) sum *= keep_;
  for (std::size_t page = 0; page < pages_used_; ++page) {
    for (double& sum : pages_[page].sums) sum *= keep_;
  }
}

void Memory::add_sparse(const SignalView& frame) {
  for (std::size_t i = 0; i < frame.indices.size(); ++i) {
    const std::uint32_t element = frame.indices[i];
    const double value{frame.values[i]};
    if (dense_) {
      sums_[element] += value;
    } else {
      page_of(element).add(element % Page::kSums, value);
    }
  }
}

// Pages of earlier explorations are used again, so that a running loop allocates nothing.
Memory::Page& Memory::page_of(std::uint32_t element) {
  if (page_numbers_.empty()) page_numbers_.resize((size_ + Page::kSums - 1) / Page::kSums, 0);
  std::uint32_t& number = page_numbers_[element / Page::kSums];
  if (number == 0) {
    if (pages_used_ == pages_.size()) pages_.emplace_back();
    number = static_cast<std::uint32_t>(++pages_used_);
    pages_[number - 1].clear();
  }
  return pages_[number - 1];
}

template <typename Visit>
void Memory::for_each_stored(const Visit& visit) const {
  for (std::size_t range = 0; range < page_numbers_.size(); ++range) {
    if (page_numbers_[range] == 0) continue;
    const Page& page = pages_[page_numbers_[range] - 1];
    for (std::size_t word = 0; word < page.stored.size(); ++word) {
      for (std::uint64_t bits = page.stored[word]; bits != 0; bits &= bits - 1) {
        const std::size_t place = word * 64 + static_cast<std::size_t>(std::countr_zero(bits));
        visit(range * Page::kSums + place, page.sums[place]);
      }
    }
  }
}

void Memory::become_dense() {
  std::vector<double> all(size_, 0.0);
  for_each_stored([&](std::size_t element, double sum) { all[element] = sum; });
  reset();
  sums_ = std::move(all);
  dense_ = true;
}

Signal Memory::value() const {
  SignalBuffer held;
  write(held);
  return Signal::copy_of(held.view(), shape_);
}

void Memory::write(SignalBuffer& out) const {
  if (!dense_) return write_sparse(out);
  std::ranges::transform(sums_, out.begin_dense(size_).begin(),
                         [](double sum) { return static_cast<float>(sum); });
}

void Memory::write_sparse(SignalBuffer& out) const {
  out.begin_sparse(size_);
  for_each_stored([&](std::size_t element, double sum) {
    out.add(static_cast<std::uint32_t>(element), static_cast<float>(sum));
  });
}

}  // namespace somato
