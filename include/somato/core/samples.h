#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "somato/core/matrix.h"
#include "somato/core/result.h"
#include "somato/core/signal.h"

namespace somato {

/// A set of samples of one size, all dense or all sparse, for example the training samples of a
/// map. It is immutable; copies share the values, also between threads.
class Samples {
 public:
  Samples();

  /// One dense sample per row.
  explicit Samples(Matrix<float> rows);

  /// One dense sample of `size` elements per row of `rows`, which are not copied: they must exist
  /// and stay unchanged during the lifetime of this object, of its copies, and of maps trained by
  /// inner products with them. Throws InvalidArgument unless `rows` has a multiple of `size`
  /// values.
  static Samples view_of(std::span<const float> rows, std::size_t size);

  /// One sample per signal, dense if any of them is; throws InvalidArgument if sizes differ.
  static Samples from_signals(const std::vector<Signal>& signals);

  std::size_t count() const { return values_->count(); }
  std::size_t size() const { return values_->size; }
  bool is_sparse() const { return values_->sparse; }

  /// Whether one is a copy of the other; equal values of a different origin do not count as the
  /// same.
  bool is_same_as(const Samples& other) const { return values_ == other.values_; }

  /// Memory of the elements in bytes, with their positions if they are sparse.
  std::size_t bytes() const;

  /// Sample `index`, flat; valid during the lifetime of this object or a copy.
  SignalView operator[](std::size_t index) const;

  /// The samples at `indices`, in this order.
  Samples subset(const std::vector<std::size_t>& indices) const;

  /// The result of `compute` for these samples, computed by the first copy and thread that needs it
  /// and shared by all. `kind`, below kKinds, identifies the computation. The result must not
  /// contain a copy of this object, which would never be freed; apart() returns one that may be
  /// stored.
  static constexpr std::size_t kKinds = 2;
  std::shared_ptr<const void> computed_once(
      std::size_t kind, const std::function<std::shared_ptr<const void>()>& compute) const;

  /// The same values, without derived results.
  Samples apart() const;

 private:
  friend class SampleCollector;
  struct Values {
    std::size_t size = 0;
    bool sparse = false;
    Matrix<float> rows;
    std::span<const float> viewed;  // rows of others, instead of `rows`
    std::vector<std::size_t> row_starts;
    std::vector<std::uint32_t> indices;
    std::vector<float> values;

    std::size_t count() const;
    std::span<const float> row(std::size_t index) const;
  };
  struct Computed;

  explicit Samples(std::shared_ptr<const Values> values);

  std::shared_ptr<const Values> values_;
  std::shared_ptr<Computed> computed_;
};

/// Collects samples of the same size one by one.
class SampleCollector {
 public:
  SampleCollector();

  /// Appends a sample; the set becomes dense with the first dense one. Throws InvalidArgument for a
  /// sample of another size.
  void add(const SignalView& sample);

  std::size_t count() const;

  /// The samples collected so far. They share the memory; adding a sample then copies all samples
  /// of the collector.
  Samples samples() const;

 private:
  void become_dense();

  std::shared_ptr<Samples::Values> values_;
};

/// One or more samples of a SampleSource; empty after the last.
using SamplePart = std::shared_ptr<const Samples>;

/// Samples that are provided in parts, so that they need not fit into memory: the same samples in
/// the same order in every pass, regardless of the division into parts.
class SampleSource {
 public:
  SampleSource() = default;
  SampleSource(const SampleSource&) = delete;
  SampleSource(SampleSource&&) = delete;
  SampleSource& operator=(const SampleSource&) = delete;
  SampleSource& operator=(SampleSource&&) = delete;
  virtual ~SampleSource() = default;

  /// Elements of each sample.
  virtual std::size_t size() const = 0;

  /// Returns to the first sample, where a source is initially.
  virtual Result<void> rewind() = 0;

  /// The next samples, or nothing at the end. After a failure the source must be rewound.
  virtual Result<SamplePart> next() = 0;
};

/// Rewinds the source and calls `visit` with every part; stops at the first failure, of the source
/// or of `visit`.
Result<void> for_each_part(SampleSource& source,
                           const std::function<Result<void>(const Samples&)>& visit);

/// Samples in memory, which must outlive this object: all in one part without a copy, or copied in
/// parts of at most `most` samples. Throws InvalidArgument when `most` is 0.
class SamplesInMemory final : public SampleSource {
 public:
  explicit SamplesInMemory(const Samples& samples, std::size_t most = static_cast<std::size_t>(-1));

  std::size_t size() const override { return samples_.size(); }
  Result<void> rewind() override;
  Result<SamplePart> next() override;

 private:
  const Samples& samples_;
  std::size_t most_;
  std::size_t done_ = 0;
};

/// The samples of another source, which must outlive this object, transformed part by part by a
/// function that preserves their size.
class ChangedSamples final : public SampleSource {
 public:
  using Change = std::function<Samples(const Samples&)>;

  ChangedSamples(SampleSource& source, Change change)
      : source_(source), change_(std::move(change)) {}

  std::size_t size() const override { return source_.size(); }
  Result<void> rewind() override { return source_.rewind(); }
  Result<SamplePart> next() override;

 private:
  SampleSource& source_;
  Change change_;
};

}  // namespace somato
