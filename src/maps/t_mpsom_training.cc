#include "somato/maps/t_mpsom_training.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "maps/t_mpsom_learner.h"
#include "somato/core/random.h"

namespace somato {
namespace {

constexpr std::uint64_t kTMpsomIterationsBetweenReports = 100;

Result<void> check_signal(const Signal& signal, std::size_t size) {
  if (signal.size() != size) {
    return fail(ErrorKind::kData,
                fmt::format("{} elements where the map takes {}", signal.size(), size));
  }
  const auto is_finite = [](float value) { return std::isfinite(value); };
  if (!std::all_of(signal.values().begin(), signal.values().end(), is_finite)) {
    return fail(ErrorKind::kData, "a value that is not finite");
  }
  return {};
}

Result<void> check_frame(const TMpsomFrame& frame, const std::vector<std::size_t>& sizes) {
  if (frame.size() != sizes.size()) {
    return fail(ErrorKind::kData,
                fmt::format("{} inputs where the map takes {}", frame.size(), sizes.size()));
  }
  for (std::size_t a = 0; a < frame.size(); ++a) {
    Result<void> checked = check_signal(frame[a], sizes[a]);
    if (checked) continue;
    checked.error().where = fmt::format(", input {}", a);
    return checked;
  }
  return {};
}

Result<void> check_exploration(const TMpsomExploration& exploration,
                               const std::vector<std::size_t>& sizes) {
  if (exploration.empty()) return fail(ErrorKind::kData, "an exploration without frames");
  for (std::size_t i = 0; i < exploration.size(); ++i) {
    Result<void> checked = check_frame(exploration[i], sizes);
    if (checked) continue;
    checked.error().where = fmt::format(", frame {}{}", i, checked.error().where);
    return checked;
  }
  return {};
}

Result<void> check_explorations(std::span<const TMpsomExploration> explorations,
                                const std::vector<std::size_t>& sizes) {
  if (explorations.empty()) return fail(ErrorKind::kData, "no explorations to learn from");
  for (std::size_t i = 0; i < explorations.size(); ++i) {
    Result<void> checked = check_exploration(explorations[i], sizes);
    if (checked) continue;
    checked.error().where = fmt::format("exploration {}{}", i, checked.error().where);
    return checked;
  }
  return {};
}

// One training, from the first iteration to the last.
class TMpsomTraining {
 public:
  TMpsomTraining(TMpsom& map, const Progress& progress)
      : map_(map), progress_(progress), rate_(map.parameters().learning_rate()), learner_(map) {}

  bool is_over() const { return done_ == total() || interrupted_; }
  bool is_interrupted() const { return interrupted_; }
  std::uint64_t done() const { return done_; }
  std::uint64_t learned() const { return learned_; }

  void learn(const TMpsomFrame& frame) {
    inputs_.clear();
    for (const Signal& signal : frame) inputs_.push_back(signal.view());
    const double alpha = rate_.at(done_);
    learned_ += learner_.learn(inputs_, alpha) ? 1 : 0;
    ++done_;
    if (done_ % kTMpsomIterationsBetweenReports == 0 || done_ == total()) report();
  }

 private:
  std::uint64_t total() const { return map_.parameters().iterations; }
  void report() { interrupted_ = progress_ && !progress_(done_, total()); }

  TMpsom& map_;
  const Progress& progress_;
  Schedule rate_;
  TMpsomLearner learner_;
  std::vector<SignalView> inputs_;
  std::uint64_t done_ = 0;
  std::uint64_t learned_ = 0;
  bool interrupted_ = false;
};

}  // namespace

Result<std::uint64_t> train_t_mpsom(TMpsom& map, std::span<const TMpsomExploration> explorations,
                                    const Progress& progress) {
  Result<void> checked = check_explorations(explorations, map.parameters().input_sizes);
  if (!checked) return fail(std::move(checked.error()));
  Random draws(map.parameters().seed, Stream::kDraws);
  TMpsomTraining training(map, progress);
  while (!training.is_over()) {
    for (const TMpsomFrame& frame : explorations[draws.below(explorations.size())]) {
      training.learn(frame);
      if (training.is_over()) break;
    }
  }
  if (training.is_interrupted()) {
    return fail(ErrorKind::kInterrupted,
                fmt::format("training stopped after {} iterations", training.done()));
  }
  return training.learned();
}

}  // namespace somato
