#include "studies/folds/tally.h"

#include <string>
#include <utility>

namespace somato {
namespace {

constexpr auto kNowAndThen = std::chrono::milliseconds(50);

}  // namespace

void Tally::one_done() {
  const std::scoped_lock lock(mutex_);
  ++done_;
  report();
}

bool Tally::should_continue() {
  const std::scoped_lock lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  if (stopped_ || now - checked_ < kNowAndThen) return !stopped_;
  checked_ = now;
  report();
  return !stopped_;
}

void Tally::failed(Error error) {
  const std::scoped_lock lock(mutex_);
  keep(std::move(error));
}

void Tally::report() {
  if (!progress_ || progress_(done_, total_)) return;
  keep({ErrorKind::kInterrupted, std::string(work_) + " was stopped before its end", {}, {}});
}

void Tally::keep(Error error) {
  if (!error_) error_ = std::move(error);
  stopped_ = true;
}

}  // namespace somato
