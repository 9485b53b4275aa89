#include "studies/system_runner.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "somato/studies/wrong_groupings.h"

namespace somato {
namespace {

constexpr auto kNowAndThen = std::chrono::milliseconds(50);

std::vector<std::size_t> all_tested(const std::vector<Fold>& folds) {
  std::vector<std::size_t> tested;
  for (const Fold& fold : folds) tested.insert(tested.end(), fold.test.begin(), fold.test.end());
  std::sort(tested.begin(), tested.end());
  return tested;
}

// The one that is better on average over the seeds: in favour of the baseline.
Metric better_of(const Metric& a, const Metric& b) {
  return {"baseline_accuracy", a.mean() >= b.mean() ? a.values : b.values};
}

}  // namespace

void Tally::one_done() {
  const std::lock_guard lock(mutex_);
  ++done_;
  if (progress_ && !progress_(done_, total_)) {
    keep({ErrorKind::kInterrupted, "the study was stopped before its end", {}, {}});
  }
}

bool Tally::goes_on() {
  const std::lock_guard lock(mutex_);
  const auto now = std::chrono::steady_clock::now();
  if (stopped_ || now - asked_ < kNowAndThen) return !stopped_;
  asked_ = now;
  if (progress_ && !progress_(done_, total_)) {
    keep({ErrorKind::kInterrupted, "the study was stopped before its end", {}, {}});
  }
  return !stopped_;
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
                           Protocol protocol, std::size_t number)
    : description_(description),
      question_(question),
      protocol_(protocol),
      number_(number),
      taken_(protocol == Protocol::kTrainIsTest ? 1 : 0),
      folds_(folds(protocol, question.samples)),
      tested_(all_tested(folds_)),
      outcomes_(description.study.seeds * folds_.size()) {}

std::size_t SystemRunner::known(const Journal& journal) const {
  std::size_t known = 0;
  for (std::size_t training = taken_; training < outcomes_.size(); ++training) {
    known += journal.find(number_, training) != nullptr ? 1 : 0;
  }
  return known;
}

void SystemRunner::run(std::size_t index, Journal& journal, Tally& tally) {
  if (tally.stopped()) return;
  const std::size_t training = taken_ + index;
  if (const FoldOutcome* known = journal.find(number_, training)) {
    outcomes_[training] = *known;
    return;
  }
  const std::size_t seed_index = training / folds_.size();
  const Fold& fold = folds_[training % folds_.size()];
  const auto trained = train_fold(description_, question_, fold, seed(seed_index),
                                  [&](std::uint64_t, std::uint64_t) { return tally.goes_on(); });
  if (!trained) return tally.failed(trained.error());
  outcomes_[training] = test_fold(*trained, question_, fold, wrong_groupings_of(seed_index));
  if (auto kept = journal.add(number_, training, outcomes_[training]); !kept) {
    return tally.failed(std::move(kept.error()));
  }
  tally.one_done();
}

void SystemRunner::take(const TrainedFold& trained) {
  if (taken_ == 0) return;
  outcomes_[0] = test_fold(trained, question_, folds_[0], wrong_groupings_of(0));
}

SystemResults SystemRunner::results() const {
  SystemResults results;
  results.name = description_.study.name;
  results.protocol = choice_name(protocol_);
  results.label = description_.study.label;
  results.samples = tested_.size();
  for (std::size_t s = 0; s < description_.study.seeds; ++s) results.runs.push_back(run_of(s));
  results.metrics = metrics();
  return results;
}

Run SystemRunner::run_of(std::size_t seed_index) const {
  const std::size_t samples = tested_.size();
  Run run{seed(seed_index), std::vector<std::size_t>(samples), {}, {}};
  run.predictions.resize(samples);
  const std::vector<std::string>& names = question_.classes.names;
  for (std::size_t f = 0; f < folds_.size(); ++f) {
    const FoldOutcome& result = outcome(seed_index, f);
    for (std::size_t i = 0; i < result.winners.size(); ++i) {
      const auto place = std::lower_bound(tested_.begin(), tested_.end(), folds_[f].test[i]);
      const auto sample = static_cast<std::size_t>(place - tested_.begin());
      run.winners[sample] = result.winners[i];
      run.predictions[sample] = names[result.predictions[i]];
    }
  }
  for (const std::size_t sample : tested_) {
    run.labels.push_back(names[question_.classes.of_sample[sample]]);
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

// The share of the tested samples whose class was predicted.
Metric SystemRunner::accuracy(std::string name, Predictions predictions) const {
  Metric metric{std::move(name), {}};
  for (std::size_t s = 0; s < description_.study.seeds; ++s) {
    std::size_t right = 0;
    for (std::size_t f = 0; f < folds_.size(); ++f) {
      const std::vector<std::size_t>& predicted = outcome(s, f).*predictions;
      for (std::size_t i = 0; i < predicted.size(); ++i) {
        const std::size_t true_class = question_.classes.of_sample[folds_[f].test[i]];
        right += predicted[i] == true_class ? 1 : 0;
      }
    }
    metric.values.push_back(static_cast<double>(right) / static_cast<double>(tested_.size()));
  }
  return metric;
}

std::vector<Metric> SystemRunner::metrics() const {
  const Metric raw = accuracy("baseline_accuracy_raw", &FoldOutcome::raw_baseline);
  const Metric standardized =
      accuracy("baseline_accuracy_standardized", &FoldOutcome::standardized_baseline);
  std::vector<Metric> metrics{
      accuracy("accuracy", &FoldOutcome::predictions),
      better_of(raw, standardized),
      raw,
      standardized,
      over_folds("individuals_apart", folds_.size(),
                 [](const FoldOutcome& o) { return o.apart ? 1.0 : 0.0; }),
      over_folds("areas_connected", folds_.size(),
                 [](const FoldOutcome& o) { return o.connected ? 1.0 : 0.0; }),
      over_folds("areas_connected_wrong_groupings", folds_.size(),
                 [](const FoldOutcome& o) { return o.connected_wrong; }),
      over_folds("quantization_error", tested_.size(),
                 [](const FoldOutcome& o) { return o.summed_distance; }),
      over_folds("topographic_error", tested_.size(), [](const FoldOutcome& o) { return o.torn; }),
  };
  if (wrong_groupings_of(0).empty()) {
    // Nothing was compared, and 0 would say that luck never does this.
    std::erase_if(metrics, [](const Metric& metric) {
      return metric.name == "areas_connected_wrong_groupings";
    });
  }
  return metrics;
}

// Dealt among the explorations that the protocol looks at.
std::vector<std::vector<std::size_t>> SystemRunner::wrong_groupings_of(
    std::size_t seed_index) const {
  std::vector<std::size_t> classes = question_.classes.of_sample;
  std::vector<std::size_t> individuals = question_.individuals;
  if (protocol_ != Protocol::kTestData) {
    classes.resize(question_.samples.samples);
    individuals.resize(question_.samples.samples);
  }
  return wrong_groupings(classes, individuals, description_.study.wrong_groupings,
                         seed(seed_index));
}

}  // namespace somato
