#include "studies/folds/prediction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "somato/core/check.h"
#include "somato/graph/system_model.h"
#include "studies/folds/fold_run.h"
#include "studies/folds/senses.h"
#include "studies/results/metric_table.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;
using Values = std::vector<float>;

Values dense(const SignalView& signal) {
  Values values(signal.size);
  write_dense(signal, values);
  return values;
}

std::size_t strongest(const Values& values) {
  return static_cast<std::size_t>(std::max_element(values.begin(), values.end()) - values.begin());
}

double mean_square(const Values& a, const Values& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = double{a[i]} - double{b[i]};
    sum += difference * difference;
  }
  return sum / static_cast<double>(a.size());
}

// Compares the values of one fold, one exploration after the other.
class Comparison {
 public:
  Comparison(const System& system, const Prediction& prediction, const Fold& fold,
             Activations& activations)
      : system_(system),
        prediction_(prediction),
        fold_(fold),
        activations_(activations),
        of_predicted_(target_size(), 0.0),
        of_target_(target_size(), 0.0) {}

  PredictionOutcome compare() {
    find_mean();
    for (std::size_t test = 0; test < fold_.test.size(); ++test) compare_exploration(test);
    if (!prediction_.vectors.empty()) compare_nearest();
    add_chance();
    return outcome_;
  }

 private:
  std::size_t target_size() const { return system_.modules()[prediction_.target].output.size(); }
  const Samples& targets(std::size_t exploration) const {
    return activations_.find(prediction_.target, exploration)->values;
  }
  double distance(std::size_t a, std::size_t b) const {
    return prediction_.grid ? std::sqrt(prediction_.grid->squared_distance(a, b)) : 0.0;
  }

  void find_mean() {
    std::vector<double> sum(target_size(), 0.0);
    std::size_t count = 0;
    for (const std::size_t exploration : fold_.training) {
      const Samples& values = targets(exploration);
      for (std::size_t i = 0; i < values.count(); ++i, ++count) {
        const Values target = dense(values[i]);
        for (std::size_t d = 0; d < sum.size(); ++d) sum[d] += double{target[d]};
      }
    }
    mean_.resize(sum.size());
    for (std::size_t d = 0; d < sum.size(); ++d) {
      mean_[d] = static_cast<float>(sum[d] / static_cast<double>(std::max<std::size_t>(count, 1)));
    }
  }

  void add(const Values& found, const Values& target, Agreement& sums) const {
    sums.squared += mean_square(found, target);
    const std::size_t a = strongest(found);
    const std::size_t b = strongest(target);
    sums.right += a == b ? 1.0 : 0.0;
    sums.distance += distance(a, b);
  }

  void compare_exploration(std::size_t test) {
    const std::size_t exploration = fold_.test[test];
    const Samples& predicted = activations_.find(prediction_.module, exploration)->values;
    const Samples& target = targets(exploration);
    const bool frames = prediction_.rate == Rate::kFrame;
    bool right_so_far = true;
    outcome_.explorations += 1.0;
    for (std::size_t i = frames ? 1 : 0; i < target.count(); ++i) {
      const Values wanted = dense(target[i]);
      const Values found = dense(predicted[i]);
      outcome_.values += 1.0;
      add(found, wanted, outcome_.predicted);
      add(mean_, wanted, outcome_.mean);
      if (frames) add(dense(target[i - 1]), wanted, outcome_.preceding);
      of_predicted_[strongest(found)] += 1.0;
      of_target_[strongest(wanted)] += 1.0;
      right_so_far = right_so_far && strongest(found) == strongest(wanted);
      outcome_.steps_right += right_so_far ? 1.0 : 0.0;
    }
  }

  void compare_nearest() {
    const Neighbours nearest = nearest_neighbours(values_of(activations_, prediction_.vectors),
                                                  fold_.training, {fold_.test})
                                   .front();
    for (std::size_t test = 0; test < fold_.test.size(); ++test) {
      const Values wanted = dense(targets(fold_.test[test])[0]);
      add(dense(targets(nearest.raw[test])[0]), wanted, outcome_.nearest);
      add(dense(targets(nearest.standardized[test])[0]), wanted, outcome_.nearest_standardized);
    }
  }

  // Every prediction meets every target equally often.
  void add_chance() {
    for (std::size_t a = 0; a < of_predicted_.size(); ++a) {
      if (of_predicted_[a] == 0.0) continue;
      for (std::size_t b = 0; b < of_target_.size(); ++b) {
        const double times = of_predicted_[a] * of_target_[b] / outcome_.values;
        outcome_.chance.right += a == b ? times : 0.0;
        if (times > 0.0) outcome_.chance.distance += times * distance(a, b);
      }
    }
  }

  const System& system_;
  const Prediction& prediction_;
  const Fold& fold_;
  Activations& activations_;
  Values mean_;
  std::vector<double> of_predicted_;  // how often each element is the strongest
  std::vector<double> of_target_;
  PredictionOutcome outcome_;
};

// A quantity of each seed, from the sums over its folds.
class MetricsOfPrediction {
 public:
  using Seeds = std::vector<std::vector<const PredictionOutcome*>>;
  using Part = Agreement PredictionOutcome::*;

  MetricsOfPrediction(const Prediction& prediction, const Seeds& seeds)
      : prediction_(prediction), seeds_(seeds) {}

  std::vector<Metric> make() {
    const bool frames = prediction_.rate == Rate::kFrame;
    add_all("prediction_error", &Agreement::squared);
    if (!prediction_.has_strongest) return std::move(metrics_);
    add_all("strongest_right", &Agreement::right);
    add_part("strongest_right_chance", &PredictionOutcome::chance, &Agreement::right);
    if (prediction_.grid) {
      add_all("strongest_distance", &Agreement::distance);
      add_part("strongest_distance_chance", &PredictionOutcome::chance, &Agreement::distance);
    }
    if (frames) {
      add(
          "steps_right", [](const PredictionOutcome& o) { return o.steps_right; },
          [](const PredictionOutcome& o) { return o.explorations; });
    }
    return std::move(metrics_);
  }

 private:
  using Number = std::function<double(const PredictionOutcome&)>;

  void add(const std::string& name, const Number& of, const Number& per) {
    Metric metric{prediction_.name + "." + name, {}};
    for (const auto& folds : seeds_) {
      double sum = 0.0;
      double count = 0.0;
      for (const PredictionOutcome* fold : folds) {
        sum += of(*fold);
        count += per(*fold);
      }
      metric.values.push_back(sum / std::max(count, 1.0));
    }
    metrics_.push_back(std::move(metric));
  }

  // Errors are roots of mean squares.
  void add_part(const std::string& name, Part part, double Agreement::* quantity) {
    add(
        name, [&](const PredictionOutcome& o) { return (o.*part).*quantity; },
        [](const PredictionOutcome& o) { return o.values; });
    if (quantity != &Agreement::squared) return;
    for (double& value : metrics_.back().values) value = std::sqrt(value);
  }

  // The prediction, and what it must surpass.
  void add_all(const std::string& name, double Agreement::* quantity) {
    add_part(name, &PredictionOutcome::predicted, quantity);
    if (quantity == &Agreement::squared) {
      add_part(name + "_of_mean", &PredictionOutcome::mean, quantity);
    }
    if (prediction_.rate == Rate::kFrame) {
      add_part(name + "_of_preceding", &PredictionOutcome::preceding, quantity);
    }
    if (!prediction_.vectors.empty()) add_nearest(name + "_of_nearest", quantity);
  }

  // The one that is better on average over the seeds: in favour of the baseline.
  void add_nearest(const std::string& name, double Agreement::* quantity) {
    add_part(name, &PredictionOutcome::nearest, quantity);
    Metric raw = std::move(metrics_.back());
    metrics_.pop_back();
    add_part(name, &PredictionOutcome::nearest_standardized, quantity);
    const MetricInfo* info = find_metric_info(name);
    SOMATO_ASSERT(info != nullptr);
    const double standardized = metrics_.back().mean();
    const bool raw_is_better = info->better == MetricDirection::kHigher
                                   ? raw.mean() >= standardized
                                   : raw.mean() <= standardized;
    if (raw_is_better) metrics_.back() = std::move(raw);
  }

  const Prediction& prediction_;
  const Seeds& seeds_;
  std::vector<Metric> metrics_;
};

}  // namespace

Result<std::vector<Prediction>> find_predictions(const System& system,
                                                 const std::vector<std::string>& names,
                                                 const std::string& where) {
  std::vector<Prediction> predictions;
  for (const std::string& name : names) {
    SOMATO_TRY(const auto number, system.find(name, where));
    const SystemModule& module = system.modules()[number];
    if (!is_association(module)) {
      return fail(ErrorKind::kUsage, fmt::format("'{}' is not an association", name), where,
                  "name modules of type association in 'predictions'");
    }
    Prediction prediction{name, number, module.inputs.back(), module.output.rate, false, {}, {}};
    const bool is_map = som_of(system, prediction.target) != nullptr;
    if (is_map) prediction.grid = grid_of(system, prediction.target);
    prediction.has_strongest =
        is_map || system.modules()[prediction.target].type->name == "one_hot";
    if (prediction.rate == Rate::kExploration) prediction.vectors = vectors_behind(system, number);
    predictions.push_back(std::move(prediction));
  }
  return predictions;
}

Result<PredictionOutcome> compare_prediction(const System& system, const Recording& recording,
                                             const Prediction& prediction, const Fold& fold,
                                             Activations& activations) {
  SOMATO_TRY_VOID(evaluate(system, recording, fold.test, {prediction.module}, 1, activations));
  Numbers wanted = prediction.vectors;
  wanted.push_back(prediction.target);
  for (const Numbers* part : {&fold.training, &fold.test}) {
    SOMATO_TRY_VOID(evaluate(system, recording, *part, wanted, 1, activations));
  }
  return Comparison(system, prediction, fold, activations).compare();
}

std::vector<Metric> prediction_metrics(
    const Prediction& prediction, const std::vector<std::vector<const PredictionOutcome*>>& seeds) {
  return MetricsOfPrediction(prediction, seeds).make();
}

}  // namespace somato
