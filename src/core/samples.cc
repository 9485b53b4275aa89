#include "somato/core/samples.h"

#include <algorithm>
#include <utility>

#include "somato/core/check.h"

namespace somato {

Samples::Samples(Matrix<float> rows) : size_(rows.columns()), rows_(std::move(rows)) {}

Samples Samples::from_signals(const std::vector<Signal>& signals) {
  Samples samples;
  if (signals.empty()) return samples;
  samples.size_ = signals.front().size();
  samples.sparse_ = std::all_of(signals.begin(), signals.end(),
                                [](const Signal& signal) { return signal.is_sparse(); });
  for (const Signal& signal : signals) {
    require(signal.size() == samples.size_, "all samples of a set must have the same size");
  }
  if (!samples.sparse_) {
    samples.rows_ = Matrix<float>(signals.size(), samples.size_);
    for (std::size_t i = 0; i < signals.size(); ++i) {
      write_dense(signals[i].view(), samples.rows_.row(i));
    }
    return samples;
  }
  samples.row_starts_.push_back(0);
  for (const Signal& signal : signals) {
    samples.indices_.insert(samples.indices_.end(), signal.indices().begin(),
                            signal.indices().end());
    samples.values_.insert(samples.values_.end(), signal.values().begin(), signal.values().end());
    samples.row_starts_.push_back(samples.indices_.size());
  }
  return samples;
}

std::size_t Samples::bytes() const {
  if (!sparse_) return rows_.rows() * size_ * sizeof(float);
  return values_.size() * sizeof(float) + indices_.size() * sizeof(std::uint32_t);
}

SignalView Samples::operator[](std::size_t index) const {
  if (!sparse_) return SignalView::dense(rows_.row(index));
  const std::size_t start = row_starts_[index];
  const std::size_t length = row_starts_[index + 1] - start;
  return {size_, true, {indices_.data() + start, length}, {values_.data() + start, length}};
}

Samples Samples::subset(const std::vector<std::size_t>& indices) const {
  Samples chosen;
  chosen.size_ = size_;
  chosen.sparse_ = sparse_;
  if (sparse_) {
    chosen.row_starts_.push_back(0);
    for (const std::size_t index : indices) {
      const SignalView sample = (*this)[index];
      chosen.indices_.insert(chosen.indices_.end(), sample.indices.begin(), sample.indices.end());
      chosen.values_.insert(chosen.values_.end(), sample.values.begin(), sample.values.end());
      chosen.row_starts_.push_back(chosen.indices_.size());
    }
    return chosen;
  }
  chosen.rows_ = Matrix<float>(indices.size(), size_);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    write_dense((*this)[indices[i]], chosen.rows_.row(i));
  }
  return chosen;
}

}  // namespace somato
