#pragma once

#include <cstdint>

#include "somato/core/progress.h"
#include "somato/core/result.h"

namespace somato {

/// Reports the progress regularly, and returns whether to stop.
class Stop {
 public:
  Stop(const Progress& progress, std::uint64_t total, std::uint64_t interval)
      : progress_(progress), total_(total), interval_(interval) {}

  /// Sets another total, if it turns out to be longer or shorter.
  void set_total(std::uint64_t total) { total_ = total; }

  bool after(std::uint64_t done) const {
    if (!progress_ || (done % interval_ != 0 && done != total_)) return false;
    return !progress_(done, total_);
  }

  static tl::unexpected<Error> error() {
    return fail(ErrorKind::kInterrupted, "training was stopped before its end");
  }

 private:
  const Progress& progress_;
  std::uint64_t total_;
  std::uint64_t interval_;
};

}  // namespace somato
