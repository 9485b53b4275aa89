#include "studies/measures/forgetting.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace somato {
namespace {

// Before the names of the metrics of each learner; those of the map have none.
constexpr std::array<const char*, kContinualLearners> kPrefixes{"", "plain_som_", "baseline_",
                                                                "same_memory_"};

double share(std::size_t part, std::size_t whole) {
  return static_cast<double>(part) / static_cast<double>(whole);
}

double accuracy_of(std::size_t object, std::size_t stage, const std::vector<std::size_t>& tested,
                   const LearnerTests& learner) {
  return share(learner.right[stage][object], tested[object]);
}

void add_to(LearnerTests& sum, const LearnerTests& one) {
  for (std::size_t stage = 0; stage < sum.right.size(); ++stage) {
    for (std::size_t object = 0; object <= stage; ++object) {
      sum.right[stage][object] += one.right[stage][object];
    }
  }
  sum.vectors += one.vectors;
}

template <typename Value>
Metric metric_of(const std::string& name, const std::vector<ObjectsOutcome>& seeds,
                 const Value& value) {
  Metric metric{name, {}};
  metric.values.reserve(seeds.size());
  for (const ObjectsOutcome& seed : seeds) metric.values.push_back(value(seed));
  return metric;
}

}  // namespace

double accuracy_after(std::size_t objects, const std::vector<std::size_t>& tested,
                      const LearnerTests& learner) {
  const std::vector<std::size_t>& right = learner.right[objects - 1];
  const auto end = tested.begin() + static_cast<std::ptrdiff_t>(objects);
  return share(std::accumulate(right.begin(), right.end(), std::size_t{0}),
               std::accumulate(tested.begin(), end, std::size_t{0}));
}

double forgetting(const std::vector<std::size_t>& tested, const LearnerTests& learner) {
  const std::size_t last = tested.size() - 1;
  double sum = 0.0;
  for (std::size_t object = 0; object < last; ++object) {
    double best = 0.0;
    for (std::size_t stage = object; stage < last; ++stage) {
      best = std::max(best, accuracy_of(object, stage, tested, learner));
    }
    sum += best - accuracy_of(object, last, tested, learner);
  }
  return last == 0 ? 0.0 : sum / static_cast<double>(last);
}

ObjectsOutcome sum_of(const std::vector<const ObjectsOutcome*>& folds) {
  ObjectsOutcome sum = *folds.front();
  for (std::size_t f = 1; f < folds.size(); ++f) {
    for (std::size_t object = 0; object < sum.tested.size(); ++object) {
      sum.tested[object] += folds[f]->tested[object];
    }
    for (std::size_t i = 0; i < sum.learners.size(); ++i) {
      add_to(sum.learners[i], folds[f]->learners[i]);
    }
    sum.neurons += folds[f]->neurons;
  }
  return sum;
}

std::vector<Metric> continual_metrics(
    const std::vector<std::vector<const ObjectsOutcome*>>& seeds) {
  std::vector<ObjectsOutcome> sums;
  sums.reserve(seeds.size());
  for (const auto& folds : seeds) sums.push_back(sum_of(folds));
  const auto folds = static_cast<double>(seeds.front().size());
  std::vector<Metric> metrics;
  for (std::size_t i = 0; i < kContinualLearners; ++i) {
    const std::string prefix = kPrefixes[i];
    const std::size_t objects = sums.front().tested.size();
    metrics.push_back(metric_of(prefix + "accuracy", sums, [&](const ObjectsOutcome& seed) {
      return accuracy_after(objects, seed.tested, seed.learners[i]);
    }));
    metrics.push_back(metric_of(prefix + "forgetting", sums, [&](const ObjectsOutcome& seed) {
      return forgetting(seed.tested, seed.learners[i]);
    }));
    metrics.push_back(metric_of(prefix + "values_kept", sums, [&](const ObjectsOutcome& seed) {
      return static_cast<double>(seed.learners[i].vectors) / folds *
             static_cast<double>(seed.elements);
    }));
    for (std::size_t k = 1; k < objects; ++k) {
      metrics.push_back(metric_of(prefix + "accuracy_after_" + std::to_string(k), sums,
                                  [&](const ObjectsOutcome& seed) {
                                    return accuracy_after(k, seed.tested, seed.learners[i]);
                                  }));
    }
  }
  metrics.push_back(metric_of("neurons", sums, [&](const ObjectsOutcome& seed) {
    return static_cast<double>(seed.neurons) / folds;
  }));
  return metrics;
}

}  // namespace somato
