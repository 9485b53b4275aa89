#pragma once

#include "somato/core/samples.h"
#include "terminal/terminal.h"

namespace somato::program {

inline tl::unexpected<Error> reading_stopped() {
  return fail(ErrorKind::kInterrupted, "reading was stopped before its end");
}

/// The samples of a source, which must outlive this object, until Ctrl-C.
class StoppableRows final : public SampleSource {
 public:
  explicit StoppableRows(SampleSource& rows) : rows_(rows) {}

  std::size_t size() const override { return rows_.size(); }
  Result<void> rewind() override { return rows_.rewind(); }
  Result<SamplePart> next() override {
    if (stop_requested()) return reading_stopped();
    return rows_.next();
  }

 private:
  SampleSource& rows_;
};

}  // namespace somato::program
