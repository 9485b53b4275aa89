#include "reproduce/sweep_progress.h"

#include <algorithm>

#include "terminal/terminal.h"

namespace somato::program {
namespace {

constexpr std::uint64_t kReportedSteps = 1'000'000;

double share_within(std::uint64_t done, std::uint64_t total, double of_next) {
  return (static_cast<double>(done) + of_next) / static_cast<double>(total);
}

}  // namespace

SweepProgress::SweepProgress(const std::string& what, std::size_t points)
    : progress_(terminal_progress(what)), points_(points) {}

void SweepProgress::end() const {
  static_cast<void>(progress_(kReportedSteps, kReportedSteps));
}

Progress SweepProgress::of_recording(std::size_t index, std::size_t count) const {
  return [this, index, count](std::uint64_t done, std::uint64_t total) {
    const double study = share_within(index, count, share_within(done, total, 0.0));
    const double point = share_within(study_.number, study_.of, study);
    const double all = share_within(done_, points_, point) * static_cast<double>(kReportedSteps);
    return progress_(std::min(static_cast<std::uint64_t>(all), kReportedSteps - 1), kReportedSteps);
  };
}

}  // namespace somato::program
