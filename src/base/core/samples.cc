#include "somato/core/samples.h"

#include <algorithm>
#include <array>
#include <mutex>
#include <numeric>
#include <utility>

#include "somato/core/check.h"

namespace somato {

struct Samples::Computed {
  std::array<std::once_flag, kKinds> done;
  std::array<std::shared_ptr<const void>, kKinds> results;
};

Samples::Samples() : Samples(std::make_shared<const Values>()) {}

Samples::Samples(std::shared_ptr<const Values> values)
    : values_(std::move(values)), computed_(std::make_shared<Computed>()) {}

Samples::Samples(Matrix<float> rows)
    : Samples(std::make_shared<const Values>(
          Values{rows.columns(), false, std::move(rows), {}, {}, {}, {}})) {}

Samples Samples::view_of(std::span<const float> rows, std::size_t size) {
  require(size == 0 ? rows.empty() : rows.size() % size == 0,
          "Samples::view_of: the rows need a multiple of the size of a sample");
  return Samples(std::make_shared<const Values>(Values{size, false, {}, rows, {}, {}, {}}));
}

std::size_t Samples::Values::count() const {
  if (sparse) return row_starts.size() - 1;
  return viewed.empty() ? rows.rows() : viewed.size() / size;
}

std::span<const float> Samples::Values::row(std::size_t index) const {
  return viewed.empty() ? rows.row(index) : viewed.subspan(index * size, size);
}

Samples Samples::from_signals(const std::vector<Signal>& signals) {
  SampleCollector collected;
  for (const Signal& signal : signals) collected.add(signal.view());
  return collected.samples();
}

SampleCollector::SampleCollector() : values_(std::make_shared<Samples::Values>()) {}

std::size_t SampleCollector::count() const {
  return values_->count();
}

void SampleCollector::add(const SignalView& sample) {
  if (values_.use_count() > 1) values_ = std::make_shared<Samples::Values>(*values_);
  if (count() == 0) {
    values_->size = sample.size;
    values_->sparse = sample.sparse;
    values_->rows = Matrix<float>(0, sample.size);
    values_->row_starts.assign(sample.sparse ? 1 : 0, 0);
  }
  require(sample.size == values_->size, "all samples of a set must have the same size");
  if (values_->sparse && !sample.sparse) become_dense();
  if (!values_->sparse) return write_dense(sample, values_->rows.add_row());
  values_->indices.insert(values_->indices.end(), sample.indices.begin(), sample.indices.end());
  values_->values.insert(values_->values.end(), sample.values.begin(), sample.values.end());
  values_->row_starts.push_back(values_->indices.size());
}

void SampleCollector::become_dense() {
  const Samples sparse = samples();
  auto dense = std::make_shared<Samples::Values>();
  dense->size = sparse.size();
  dense->rows = Matrix<float>(sparse.count(), sparse.size());
  for (std::size_t i = 0; i < sparse.count(); ++i) write_dense(sparse[i], dense->rows.row(i));
  values_ = std::move(dense);
}

// The stored data take no more memory than Samples::bytes(). Nothing moves while others share them:
// add() copies shared data first, and a copy has no spare memory.
Samples SampleCollector::samples() const {
  values_->rows.shrink_to_fit();
  values_->row_starts.shrink_to_fit();
  values_->indices.shrink_to_fit();
  values_->values.shrink_to_fit();
  return Samples(std::shared_ptr<const Samples::Values>(values_));
}

std::size_t Samples::bytes() const {
  if (!is_sparse()) return count() * size() * sizeof(float);
  return values_->values.size() * sizeof(float) + values_->indices.size() * sizeof(std::uint32_t);
}

SignalView Samples::operator[](std::size_t index) const {
  const Values& all = *values_;
  if (!all.sparse) return SignalView::dense(all.row(index));
  const std::size_t start = all.row_starts[index];
  const std::size_t length = all.row_starts[index + 1] - start;
  return {
      all.size, true, {all.indices.data() + start, length}, {all.values.data() + start, length}};
}

Samples Samples::subset(const std::vector<std::size_t>& indices) const {
  Values chosen;
  chosen.size = size();
  chosen.sparse = is_sparse();
  if (is_sparse()) {
    chosen.row_starts.push_back(0);
    for (const std::size_t index : indices) {
      const SignalView sample = (*this)[index];
      chosen.indices.insert(chosen.indices.end(), sample.indices.begin(), sample.indices.end());
      chosen.values.insert(chosen.values.end(), sample.values.begin(), sample.values.end());
      chosen.row_starts.push_back(chosen.indices.size());
    }
  } else {
    chosen.rows = Matrix<float>(indices.size(), size());
    for (std::size_t i = 0; i < indices.size(); ++i) {
      write_dense((*this)[indices[i]], chosen.rows.row(i));
    }
  }
  return Samples(std::make_shared<const Values>(std::move(chosen)));
}

std::shared_ptr<const void> Samples::computed_once(
    std::size_t kind, const std::function<std::shared_ptr<const void>()>& compute) const {
  std::call_once(computed_->done.at(kind), [&] { computed_->results[kind] = compute(); });
  return computed_->results[kind];
}

Samples Samples::apart() const {
  return Samples(values_);
}

Result<void> for_each_part(SampleSource& source,
                           const std::function<Result<void>(const Samples&)>& visit) {
  SOMATO_TRY_VOID(source.rewind());
  for (;;) {
    SOMATO_TRY(const SamplePart part, source.next());
    if (!part) return {};
    SOMATO_TRY_VOID(visit(*part));
  }
}

SamplesInMemory::SamplesInMemory(const Samples& samples, std::size_t most)
    : samples_(samples), most_(most) {
  require(most > 0, "a part of samples contains at least one sample");
}

Result<void> SamplesInMemory::rewind() {
  done_ = 0;
  return {};
}

Result<SamplePart> SamplesInMemory::next() {
  const std::size_t first = done_;
  const std::size_t count = std::min(most_, samples_.count() - first);
  done_ += count;
  if (count == 0) return SamplePart();
  if (count == samples_.count()) return SamplePart(SamplePart(), &samples_);
  std::vector<std::size_t> indices(count);
  std::iota(indices.begin(), indices.end(), first);
  return std::make_shared<const Samples>(samples_.subset(indices));
}

Result<SamplePart> ChangedSamples::next() {
  return source_.next().map([&](const SamplePart& part) {
    return part ? std::make_shared<const Samples>(change_(*part)) : part;
  });
}

}  // namespace somato
