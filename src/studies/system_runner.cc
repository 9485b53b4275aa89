#include "studies/system_runner.h"

#include <algorithm>
#include <utility>

#include "somato/studies/wrong_groupings.h"

namespace somato {
namespace {

double share_right(const std::vector<PreparedFold>& folds, const Question& question,
                   std::vector<std::size_t> PreparedFold::* predictions) {
  double right = 0.0;
  for (const PreparedFold& fold : folds) {
    for (std::size_t i = 0; i < fold.fold.test.size(); ++i) {
      const std::size_t true_class = question.classes.of_sample[fold.fold.test[i]];
      right += (fold.*predictions)[i] == true_class ? 1.0 : 0.0;
    }
  }
  return right / static_cast<double>(question.classes.of_sample.size());
}

Metric accuracy(const std::vector<Run>& runs) {
  Metric metric{"accuracy", {}};
  for (const Run& run : runs) {
    double right = 0.0;
    for (std::size_t i = 0; i < run.labels.size(); ++i) {
      right += run.labels[i] == run.predictions[i] ? 1.0 : 0.0;
    }
    metric.values.push_back(right / static_cast<double>(run.labels.size()));
  }
  return metric;
}

}  // namespace

void Tally::one_done() {
  const std::lock_guard lock(mutex_);
  ++done_;
  if (progress_ && !progress_(done_, total_)) {
    keep({ErrorKind::kInterrupted, "the study was stopped before its end", {}, {}});
  }
}

void Tally::failed(Error error) {
  const std::lock_guard lock(mutex_);
  keep(std::move(error));
}

void Tally::keep(Error error) {
  if (!error_) error_ = std::move(error);
  stopped_ = true;
}

SystemRunner::SystemRunner(const StudyDescription& description, const Question& question,
                           Protocol protocol, std::vector<PreparedFold> folds)
    : description_(description),
      question_(question),
      protocol_(protocol),
      folds_(std::move(folds)),
      outcomes_(description.study.seeds * folds_.size()) {}

void SystemRunner::run(std::size_t training, Tally& tally) {
  if (tally.stopped()) return;
  const std::size_t seed_index = training / folds_.size();
  SomParameters parameters = description_.map;
  parameters.seed = seed(seed_index);
  auto outcome = run_fold(parameters, folds_[training % folds_.size()], question_.classes.of_sample,
                          wrong_groupings_of(seed_index));
  if (!outcome) return tally.failed(std::move(outcome.error()));
  outcomes_[training] = std::move(*outcome);
  tally.one_done();
}

SystemResults SystemRunner::results() const {
  SystemResults results;
  results.name = description_.study.name;
  results.protocol = choice_name(protocol_);
  results.label = description_.study.label;
  results.samples = question_.classes.of_sample.size();
  for (std::size_t s = 0; s < description_.study.seeds; ++s) results.runs.push_back(run_of(s));
  results.metrics = metrics(results.runs);
  return results;
}

Run SystemRunner::run_of(std::size_t seed_index) const {
  const std::size_t samples = question_.classes.of_sample.size();
  Run run{seed(seed_index), std::vector<std::size_t>(samples), {}, {}};
  run.predictions.resize(samples);
  for (std::size_t f = 0; f < folds_.size(); ++f) {
    const FoldOutcome& result = outcome(seed_index, f);
    for (std::size_t i = 0; i < result.winners.size(); ++i) {
      const std::size_t sample = folds_[f].fold.test[i];
      run.winners[sample] = result.winners[i];
      run.predictions[sample] = question_.classes.names[result.predictions[i]];
    }
  }
  for (const std::size_t its_class : question_.classes.of_sample) {
    run.labels.push_back(question_.classes.names[its_class]);
  }
  return run;
}

// The sum of a fold's value over the folds of a seed, divided by `count`.
template <typename Value>
Metric SystemRunner::over_folds(std::string name, std::size_t count, const Value& value) const {
  Metric metric{std::move(name), {}};
  for (std::size_t s = 0; s < description_.study.seeds; ++s) {
    double sum = 0.0;
    for (std::size_t f = 0; f < folds_.size(); ++f) sum += value(outcome(s, f));
    metric.values.push_back(sum / static_cast<double>(count));
  }
  return metric;
}

// The baseline knows no seed: the same value for each.
Metric SystemRunner::for_every_seed(std::string name, double value) const {
  return {std::move(name), std::vector<double>(description_.study.seeds, value)};
}

std::vector<Metric> SystemRunner::metrics(const std::vector<Run>& runs) const {
  const double raw = share_right(folds_, question_, &PreparedFold::raw_baseline);
  const double standardized = share_right(folds_, question_, &PreparedFold::standardized_baseline);
  const std::size_t samples = question_.classes.of_sample.size();
  std::vector<Metric> metrics{
      accuracy(runs),
      for_every_seed("baseline_accuracy", std::max(raw, standardized)),
      for_every_seed("baseline_accuracy_raw", raw),
      for_every_seed("baseline_accuracy_standardized", standardized),
      over_folds("individuals_apart", folds_.size(),
                 [](const FoldOutcome& o) { return o.apart ? 1.0 : 0.0; }),
      over_folds("areas_connected", folds_.size(),
                 [](const FoldOutcome& o) { return o.connected ? 1.0 : 0.0; }),
      over_folds("areas_connected_wrong_groupings", folds_.size(),
                 [](const FoldOutcome& o) { return o.connected_wrong; }),
      over_folds("quantization_error", samples,
                 [](const FoldOutcome& o) { return o.summed_distance; }),
      over_folds("topographic_error", samples, [](const FoldOutcome& o) { return o.torn; }),
  };
  if (wrong_groupings_of(0).empty()) {
    // Nothing was compared, and 0 would say that luck never does this.
    std::erase_if(metrics, [](const Metric& metric) {
      return metric.name == "areas_connected_wrong_groupings";
    });
  }
  return metrics;
}

std::vector<std::vector<std::size_t>> SystemRunner::wrong_groupings_of(
    std::size_t seed_index) const {
  return wrong_groupings(question_.classes.of_sample, question_.individuals,
                         description_.study.wrong_groupings, seed(seed_index));
}

}  // namespace somato
