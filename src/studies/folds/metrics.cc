#include "studies/folds/metrics.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <numeric>
#include <set>
#include <string>
#include <utility>

#include "base/core/values_at.h"
#include "maps/grid/areas.h"
#include "somato/maps/labels.h"
#include "somato/maps/novelty.h"
#include "studies/folds/map_reading.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

std::size_t count_equal(const Numbers& a, const Numbers& b) {
  std::size_t equal = 0;
  for (std::size_t i = 0; i < a.size(); ++i) equal += a[i] == b[i] ? 1 : 0;
  return equal;
}

// Makes the metrics of one study under one protocol.
class MetricsMaker {
 public:
  MetricsMaker(const MeasuredStudy& study, const std::vector<SeedOutcome>& seeds)
      : study_(study), seeds_(seeds) {
    for (const Fold& fold : study.folds) tested_ += fold.test.size();
  }

  std::vector<Metric> make() {
    const bool recalls = study_.prepared.recall.has_value();
    for (const StudiedLabel& label : study_.prepared.labels) {
      prefix_ = &label == &study_.prepared.labels.front() ? "" : label.name + ".";
      if (can_be_named(label.classes)) {
        add_accuracies(label, [](const FoldOutcome& o) -> const auto& { return o; });
      }
      if (!recalls) add_areas(label);
    }
    for (std::size_t i = 0; i < study_.prepared.alterations.size(); ++i) add_altered(i);
    prefix_.clear();
    if (study_.protocol == Protocol::kLeaveClassOut) {
      add_novelty();
      if (study_.study.taught_per_class > 0) add_teaching();
    }
    if (!recalls) describe_maps();
    add_predictions();
    return std::move(metrics_);
  }

  // Only that of the study's label, by the samples as they are.
  std::vector<Metric> make_best_neighbour() {
    add_best_neighbour(study_.prepared.labels.front(),
                       [](const FoldOutcome& o) -> const auto& { return o; });
    return std::move(metrics_);
  }

 private:
  template <typename Value>  // of a seed
  void add(const std::string& name, const Value& value) {
    Metric metric{prefix_ + name, {}};
    metric.values.reserve(seeds_.size());
    for (const SeedOutcome& seed : seeds_) metric.values.push_back(value(seed));
    metrics_.push_back(std::move(metric));
  }

  // A sum over the folds for each tested sample.
  template <typename Value>
  void add_sum(const std::string& name, const Value& value) {
    add(name, [&](const SeedOutcome& seed) {
      double sum = 0.0;
      for (const FoldOutcome* fold : seed.folds) sum += value(*fold);
      return sum / static_cast<double>(tested_);
    });
  }

  // A class can be named where a fold learned from it.
  bool can_be_named(const Classes& classes) const {
    return std::any_of(study_.folds.begin(), study_.folds.end(), [&](const Fold& fold) {
      const Numbers learned = values_at(classes.of_sample, fold.training);
      const std::set<std::size_t> known(learned.begin(), learned.end());
      return std::any_of(fold.test.begin(), fold.test.end(), [&](std::size_t sample) {
        return known.contains(classes.of_sample[sample]);
      });
    });
  }

  template <typename Named>  // the classes named for a fold's tested samples
  void add_share_right(const std::string& name, const Classes& classes, const Named& named) {
    add(name, [&](const SeedOutcome& seed) {
      std::size_t right = 0;
      for (std::size_t f = 0; f < seed.folds.size(); ++f) {
        right += count_equal(named(study_.folds[f], *seed.folds[f]),
                             values_at(classes.of_sample, study_.folds[f].test));
      }
      return static_cast<double>(right) / static_cast<double>(tested_);
    });
  }

  // The accuracies of the tested samples as they are, or as altered: FoldOutcome or AlteredOutcome.
  template <typename Tested>
  void add_accuracies(const StudiedLabel& label, const Tested& tested) {
    const Classes& classes = label.classes;
    add_share_right("accuracy", classes, [&](const Fold& fold, const FoldOutcome& outcome) {
      return predictions(classes, fold, outcome, tested(outcome).named_by);
    });
    if (study_.prepared.recall) add_accuracy_by_chance(classes, tested);
    const std::size_t best = metrics_.size();
    add_share_right("baseline_accuracy_raw", classes, [&](const Fold&, const FoldOutcome& outcome) {
      return values_at(classes.of_sample, tested(outcome).nearest.raw);
    });
    add_share_right("baseline_accuracy_standardized", classes,
                    [&](const Fold&, const FoldOutcome& outcome) {
                      return values_at(classes.of_sample, tested(outcome).nearest.standardized);
                    });
    // The one that is better on average over the seeds: in favour of the baseline.
    const Metric& raw = metrics_[best];
    const Metric& standardized = metrics_[best + 1];
    Metric better = raw.mean() >= standardized.mean() ? raw : standardized;
    better.name = prefix_ + "baseline_accuracy";
    metrics_.insert(metrics_.begin() + static_cast<std::ptrdiff_t>(best), std::move(better));
    add_best_neighbour(label, tested);
  }

  // Only where it was chosen in every fold.
  template <typename Tested>
  void add_best_neighbour(const StudiedLabel& label, const Tested& tested) {
    for (const SeedOutcome& seed : seeds_) {
      for (const FoldOutcome* fold : seed.folds) {
        if (tested(*fold).nearest.best.empty()) return;
      }
    }
    const auto number = static_cast<std::size_t>(&label - study_.prepared.labels.data());
    add_share_right(
        "best_neighbour_accuracy", label.classes, [&](const Fold&, const FoldOutcome& outcome) {
          return values_at(label.classes.of_sample, tested(outcome).nearest.best[number].nearest);
        });
  }

  void add_altered(std::size_t alteration) {
    for (const StudiedLabel& label : study_.prepared.labels) {
      if (!can_be_named(label.classes)) continue;
      prefix_ = "altered." + study_.prepared.alterations[alteration] + ".";
      if (&label != &study_.prepared.labels.front()) prefix_ += label.name + ".";
      add_accuracies(label,
                     [&](const FoldOutcome& o) -> const auto& { return o.altered[alteration]; });
    }
  }

  // The scores of all folds of a seed are pooled, since one threshold fits all systems.
  template <typename Measure>
  void add_pooled(const std::string& name, const Measure& measure) {
    add(name, [&](const SeedOutcome& seed) {
      NoveltyOutcome pooled;
      for (const FoldOutcome* fold : seed.folds) pooled.add(fold->novelty);
      return measure(pooled.known, pooled.unknown);
    });
  }

  // By one of the scores: how well it separates, and how many it notices at the false-alarm rate.
  void add_separation(const std::string& before, const std::string& after,
                      std::vector<double> NoveltyScores::* score) {
    using Scores = const NoveltyScores&;
    add_pooled(before + "unknown_auroc" + after, [&](Scores known, Scores unknown) {
      return area_under_curve(known.*score, unknown.*score);
    });
    const double rate = study_.study.false_alarm_rate;
    add_pooled(before + "unknown_noticed_at_rate" + after, [&](Scores known, Scores unknown) {
      return noticed_at(known.*score, unknown.*score, rate);
    });
  }

  void add_novelty() {
    using Scores = const NoveltyScores&;
    add_separation("", "", &NoveltyScores::novelty);
    add_pooled("unknown_noticed",
               [](Scores, Scores unknown) { return share_unknown(unknown.novelty); });
    add_pooled("unknown_false_alarms",
               [](Scores known, Scores) { return share_unknown(known.novelty); });
    add_interval("low", &FalseAlarmInterval::low);
    add_interval("high", &FalseAlarmInterval::high);
    add_separation("", "_of_distance", &NoveltyScores::distance);
    add_separation("baseline_", "", &NoveltyScores::nearest);
  }

  // The interval of the thresholds that were found in training: the mean over the trainings.
  void add_interval(const std::string& end, double FalseAlarmInterval::* limit) {
    add("unknown_false_alarms_" + end, [&](const SeedOutcome& seed) {
      double sum = 0.0;
      for (const FoldOutcome* fold : seed.folds) {
        const std::size_t scores = fold->novelty.calibrated.front();
        sum += false_alarm_interval(scores, study_.study.false_alarm_rate).*limit;
      }
      return sum / static_cast<double>(seed.folds.size());
    });
  }

  void add_teaching() {
    std::vector<TeachingOutcome> sums(seeds_.size());
    for (std::size_t s = 0; s < seeds_.size(); ++s) {
      for (const FoldOutcome* fold : seeds_[s].folds) sums[s].add(fold->teaching);
    }
    auto metrics = teaching_metrics(sums);
    std::move(metrics.begin(), metrics.end(), std::back_inserter(metrics_));
  }

  // The share of right classes expected if the named ones are in random order.
  template <typename Tested>
  void add_accuracy_by_chance(const Classes& classes, const Tested& tested) {
    add("accuracy_chance", [&](const SeedOutcome& seed) {
      std::vector<double> named(classes.names.size(), 0.0);
      std::vector<double> right(classes.names.size(), 0.0);
      for (std::size_t f = 0; f < seed.folds.size(); ++f) {
        const Fold& fold = study_.folds[f];
        for (const std::size_t one :
             predictions(classes, fold, *seed.folds[f], tested(*seed.folds[f]).named_by)) {
          named[one] += 1.0;
        }
        for (const std::size_t one : values_at(classes.of_sample, fold.test)) right[one] += 1.0;
      }
      const auto all = static_cast<double>(tested_);
      return std::inner_product(named.begin(), named.end(), right.begin(), 0.0) / (all * all);
    });
  }

  // A recall is no measure of these: they are about the map on its own sense.
  void describe_maps() {
    read_maps();
    add_refined("topographic_error", &RefinementOutcome::topographic_errors);
    add_refined("trustworthiness", &RefinementOutcome::trustworthiness);
    add_refined("continuity", &RefinementOutcome::continuity);
    add_sum("quantization_error", [](const FoldOutcome& o) { return o.summed_distance; });
    add_sum("topographic_error", [](const FoldOutcome& o) { return o.topographic_errors; });
  }

  // The means over the folds of a measure before and after the refinement, if all maps have it.
  void add_refined(const std::string& name, std::vector<double> RefinementOutcome::* values) {
    const auto has_it = [&](const FoldOutcome* o) { return (o->refinement.*values).size() == 2; };
    const bool all_have_it =
        std::all_of(seeds_.begin(), seeds_.end(), [&](const SeedOutcome& seed) {
          return std::all_of(seed.folds.begin(), seed.folds.end(), has_it);
        });
    if (!all_have_it) return;
    for (const std::size_t after : {std::size_t{0}, std::size_t{1}}) {
      add((after == 0 ? "unrefined_" : "refined_") + name, [&](const SeedOutcome& seed) {
        double sum = 0.0;
        for (const FoldOutcome* fold : seed.folds) sum += (fold->refinement.*values)[after];
        return sum / static_cast<double>(seed.folds.size());
      });
    }
  }

  void add_predictions() {
    for (std::size_t p = 0; p < study_.prepared.predictions.size(); ++p) {
      std::vector<std::vector<const PredictionOutcome*>> outcomes(seeds_.size());
      for (std::size_t s = 0; s < seeds_.size(); ++s) {
        for (const FoldOutcome* fold : seeds_[s].folds) {
          outcomes[s].push_back(&fold->predictions[p]);
        }
      }
      auto metrics = prediction_metrics(study_.prepared.predictions[p], outcomes);
      std::move(metrics.begin(), metrics.end(), std::back_inserter(metrics_));
    }
  }

  // The winners of all samples of a fold, learned or tested, with these samples.
  struct FoldWinners {
    Numbers samples;
    Numbers winners;
  };
  FoldWinners fold_winners(const SeedOutcome& seed, std::size_t f) const {
    const Fold& fold = study_.folds[f];
    FoldWinners all{fold.training, seed.folds[f]->training_winners};
    if (fold.training == fold.test) return all;
    all.samples.insert(all.samples.end(), fold.test.begin(), fold.test.end());
    all.winners.insert(all.winners.end(), seed.folds[f]->winners.begin(),
                       seed.folds[f]->winners.end());
    return all;
  }

  // Reassigned among the explorations of the protocol.
  std::vector<Numbers> wrong(const StudiedLabel& label, std::uint64_t seed) const {
    return wrong_classes(label, explorations_looked_at(), study_.study.wrong_groupings, seed);
  }

  std::size_t explorations_looked_at() const {
    const FoldSamples& samples = study_.prepared.samples;
    return samples.samples + (study_.protocol == Protocol::kTestData ? samples.test_samples : 0);
  }

  // A measure of the areas that classes take, made once for the winners of a fold.
  using AreaMeasure = std::function<double(const Numbers& classes)>;
  using MakeMeasure = std::function<AreaMeasure(const Grid& grid, const Numbers& winners)>;

  // Sums over the folds, one for each wrong grouping.
  static void add_chance(const std::vector<double>& sums, double folds, Metric& by_chance) {
    double sum = 0.0;
    Distribution of_each;
    for (const double of_grouping : sums) {
      sum += of_grouping;
      ++of_each[of_grouping / folds];
    }
    by_chance.values.push_back(sum / (folds * static_cast<double>(sums.size())));
    by_chance.of_each.push_back(std::move(of_each));
  }

  void add_area_measure(const std::string& name, const StudiedLabel& label,
                        const MakeMeasure& make) {
    Metric right{prefix_ + name, {}};
    Metric by_chance{prefix_ + name + "_chance", {}};
    for (const SeedOutcome& seed : seeds_) {
      const std::vector<Numbers> groupings = wrong(label, seed.seed);
      double of_right = 0.0;
      std::vector<double> of_wrong(groupings.size(), 0.0);
      for (std::size_t f = 0; f < seed.folds.size(); ++f) {
        const FoldWinners all = fold_winners(seed, f);
        const AreaMeasure measure = make(seed.folds[f]->map.grid, all.winners);
        of_right += measure(values_at(label.classes.of_sample, all.samples));
        for (std::size_t g = 0; g < groupings.size(); ++g) {
          of_wrong[g] += measure(values_at(groupings[g], all.samples));
        }
      }
      const auto folds = static_cast<double>(seed.folds.size());
      right.values.push_back(of_right / folds);
      if (!groupings.empty()) add_chance(of_wrong, folds, by_chance);
    }
    metrics_.push_back(std::move(right));
    // Without comparisons, a value of 0 would state that it never occurs by chance.
    if (!by_chance.values.empty()) metrics_.push_back(std::move(by_chance));
  }

  void add_areas(const StudiedLabel& label) {
    add_area_measure("individuals_apart", label,
                     [](const Grid&, const Numbers& winners) -> AreaMeasure {
                       return [&winners](const Numbers& classes) {
                         return individuals_apart(winners, classes) ? 1.0 : 0.0;
                       };
                     });
    const auto connected = [](const Grid& grid, const Numbers& winners) -> AreaMeasure {
      return [areas = WinnerAreas(grid, winners)](const Numbers& classes) {
        return areas.connected(classes) ? 1.0 : 0.0;
      };
    };
    add_area_measure("areas_connected", label, connected);
  }

  // The measures of one map with all samples; or of one with new objects.
  void read_maps() {
    const bool one_map = study_.protocol == Protocol::kTrainIsTest;
    if (!one_map && study_.protocol != Protocol::kTestData) return;
    std::vector<std::vector<MeasuredValue>> readings;
    readings.reserve(seeds_.size());
    for (const SeedOutcome& seed : seeds_) {
      const FoldOutcome& outcome = *seed.folds.front();
      readings.push_back(one_map ? read_map(study_.study, study_.prepared, outcome.map.grid,
                                            outcome.winners, seed.seed)
                                 : read_placed(study_.prepared, outcome, seed.seed));
    }
    for (std::size_t reading = 0; reading < readings.front().size(); ++reading) {
      Metric metric{readings.front()[reading].name, {}};
      for (const std::vector<MeasuredValue>& values : readings) {
        metric.values.push_back(values[reading].value);
        if (!values[reading].of_each.empty()) metric.of_each.push_back(values[reading].of_each);
      }
      metrics_.push_back(std::move(metric));
    }
  }

  const MeasuredStudy& study_;
  const std::vector<SeedOutcome>& seeds_;
  std::size_t tested_ = 0;
  std::string prefix_;
  std::vector<Metric> metrics_;
};

}  // namespace

std::vector<std::size_t> predictions(const Classes& classes, const Fold& fold,
                                     const FoldOutcome& outcome, const Numbers& named_by) {
  const auto last =
      std::max_element(outcome.training_winners.begin(), outcome.training_winners.end());
  const NeuronLabels labels = NeuronLabels::by_majority(
      outcome.training_winners, values_at(classes.of_sample, fold.training), *last + 1);
  Numbers named;
  named.reserve(named_by.size());
  for (const std::size_t neuron : named_by) named.push_back(*labels[neuron]);
  return named;
}

std::vector<std::size_t> predictions(const Classes& classes, const Fold& fold,
                                     const FoldOutcome& outcome) {
  return predictions(classes, fold, outcome, outcome.named_by);
}

std::vector<Metric> metrics_of(const MeasuredStudy& study, const std::vector<SeedOutcome>& seeds) {
  return MetricsMaker(study, seeds).make();
}

void add_best_neighbour(const MeasuredStudy& study, const std::vector<SeedOutcome>& seeds,
                        std::vector<Metric>& metrics) {
  auto place = std::ranges::find(metrics, "baseline_accuracy", &Metric::name);
  if (place != metrics.end()) ++place;
  auto best = MetricsMaker(study, seeds).make_best_neighbour();
  metrics.insert(place, std::make_move_iterator(best.begin()), std::make_move_iterator(best.end()));
}

}  // namespace somato
