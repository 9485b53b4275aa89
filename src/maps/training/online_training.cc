#include "maps/training/online_training.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "maps/som/fill_from_winner.h"
#include "maps/som/som_preparation.h"
#include "maps/som/stop.h"
#include "maps/training/length_checks.h"
#include "maps/training/moments.h"
#include "somato/maps/som_learner.h"

namespace somato {
namespace {

constexpr std::uint64_t kOnlineIterationsBetweenReports = 64;
constexpr std::uint64_t kProductIterationsBetweenReports = 256;
constexpr std::uint64_t kLeastIterationsBetweenReports = 16;  // learned in one pass
constexpr std::uint64_t kWeightsBetweenReports = std::uint64_t{1} << 28;
constexpr std::size_t kManyNeurons = std::size_t{1} << 22;  // of which a step takes up to a second

// Fewer on a large map: a user who stops it does not want to wait.
std::uint64_t iterations_between_reports(const Som& som) {
  if (som.products()) return kProductIterationsBetweenReports;
  if (som.neurons() > kManyNeurons) return 1;
  const std::uint64_t weights = std::uint64_t{som.neurons()} * som.elements().count();
  return std::clamp<std::uint64_t>(kWeightsBetweenReports / weights, kLeastIterationsBetweenReports,
                                   kOnlineIterationsBetweenReports);
}

// Training with one sample after the other. The learner's map is only complete at the end.
class OnlineTraining {
 public:
  OnlineTraining(SomStart& start, const TrainingOptions& options)
      : start_(start),
        options_(options),
        parameters_(start.som.parameters()),
        interval_(iterations_between_reports(start.som)),
        stop_(options.progress, *parameters_.iterations, interval_),
        moments_(options.observer, start.som, *parameters_.iterations),
        draws_(parameters_.draws, start.training.size(), parameters_.seed),
        checks_(parameters_) {}

  Result<void> run() {
    const std::uint64_t scheduled = *parameters_.iterations;
    // Memory for a learner of so many neurons takes seconds.
    if (start_.som.neurons() > kManyNeurons && stop_.after(0)) return Stop::error();
    SomLearner learner(start_.som, options_.threads, options_.incomplete != nullptr);
    set_total(scheduled);
    SOMATO_TRY_VOID(learn_until(scheduled, learner));
    while (checks_.go_on()) {
      checks_.add(error_of(learner.look()));
      set_total(done_);
      if (checks_.go_on()) SOMATO_TRY_VOID(learn_until(done_ + between_checks(), learner));
    }
    if (options_.steps_done) *options_.steps_done = done_;
    return {};
  }

 private:
  // Missing elements do not count.
  double error_of(const Som& som) const {
    if (!options_.incomplete) {
      return mean_distance(som, start_.samples, start_.training, options_.threads);
    }
    return mean_distance(som, filled_from_winners(som, *options_.incomplete), start_.training,
                         options_.threads);
  }

  std::uint64_t between_checks() const { return start_.training.size(); }

  // The first check needs no further iterations.
  void set_total(std::uint64_t done) {
    const std::uint64_t checks = checks_.checks_left();
    const std::uint64_t first = checks_.state().checks == 0 && checks > 0 ? 1 : 0;
    total_ = done + (checks - first) * between_checks();
    stop_.set_total(total_);
  }

  Result<void> learn_until(std::uint64_t end, SomLearner& learner) {
    while (done_ < end) {
      const std::uint64_t reported = done_ - done_ % interval_ + interval_;
      const bool scheduled = done_ < *parameters_.iterations;
      learn(std::min({reported, end, scheduled ? moments_.next(done_) : end}), learner);
      const auto map = [&] { return start_.whole(learner.look()); };
      const LearningStep& last = steps_.back();
      if (stop_.after(done_) ||
          ((scheduled || done_ == end) &&
           moments_.stop_after(done_, total_, last.learning_rate, last.radius, map))) {
        return Stop::error();
      }
      if (may_diverge(parameters_)) SOMATO_TRY_VOID(check_bounded(learner.look()));
    }
    return {};
  }

  void learn(std::uint64_t end, SomLearner& learner) {
    drawn_.clear();
    steps_.clear();
    for (; done_ < end; ++done_) {
      drawn_.push_back(start_.training[draws_.next()]);
      steps_.push_back({parameters_.learning_rate().at(done_), parameters_.radius().at(done_)});
    }
    learner.learn(options_.incomplete ? *options_.incomplete : start_.samples, drawn_, steps_);
  }

  SomStart& start_;
  const TrainingOptions& options_;
  SomParameters parameters_;
  std::uint64_t interval_;
  Stop stop_;
  Moments moments_;
  DrawSequence draws_;
  LengthChecks checks_;
  std::vector<std::size_t> drawn_;
  std::vector<LearningStep> steps_;
  std::uint64_t done_ = 0;
  std::uint64_t total_ = 0;
};

}  // namespace

Result<void> train_online(SomStart& start, const TrainingOptions& options) {
  return OnlineTraining(start, options).run();
}

}  // namespace somato
