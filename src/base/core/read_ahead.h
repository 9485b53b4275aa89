#pragma once

#include <future>

#include "somato/core/samples.h"

namespace somato {

/// The samples of another source, which must outlive this object and is not to be used meanwhile:
/// while one part is in use, another thread fetches the next. Two parts are in memory at a time.
class ReadAhead final : public SampleSource {
 public:
  explicit ReadAhead(SampleSource& source) : source_(source) {}
  ReadAhead(const ReadAhead&) = delete;
  ReadAhead(ReadAhead&&) = delete;
  ReadAhead& operator=(const ReadAhead&) = delete;
  ReadAhead& operator=(ReadAhead&&) = delete;
  ~ReadAhead() override { forget(); }

  std::size_t size() const override { return source_.size(); }
  Result<void> rewind() override;
  Result<SamplePart> next() override;

 private:
  void fetch();
  void forget();

  SampleSource& source_;
  std::future<Result<SamplePart>> coming_;
};

}  // namespace somato
