#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <utility>

#include "somato/core/result.h"
#include "somato/core/samples.h"

namespace somato {

/// Some of the samples of a SampleSource, one or more; nothing after the last.
using SamplePart = std::shared_ptr<const Samples>;

/// Samples that come in parts, so that they need not fit into memory: the same ones in the same
/// order whenever they are gone through, however they are parted.
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

  /// Goes back to the first sample, where a source is to begin with.
  virtual Result<void> rewind() = 0;

  /// The next samples, or nothing when there are no more. After a failure the source is to be
  /// rewound.
  virtual Result<SamplePart> next() = 0;
};

/// Rewinds the source and calls `visit` with every part of it; the first failure, of the source or
/// of `visit`, ends it.
Result<void> for_each_part(SampleSource& source,
                           const std::function<Result<void>(const Samples&)>& visit);

/// Samples in memory, which must outlive this object: all at once without a copy, or copied in
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

/// The samples of another source, which must outlive this object, changed part by part by a
/// function that keeps their size.
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
