#include "studies/measures/teaching_measures.h"

#include <string>
#include <utility>

#include "somato/core/check.h"

namespace somato {
namespace {

double share_of_explorations(std::size_t part, std::size_t whole) {
  require(whole > 0, "a share of explorations needs at least one");
  return static_cast<double>(part) / static_cast<double>(whole);
}

void add_to(RightNames& sum, const RightNames& one) {
  sum.answered += one.answered;
  sum.nearest += one.nearest;
  sum.baseline += one.baseline;
}

// Makes the metrics of all stages.
class TeachingMetrics {
 public:
  explicit TeachingMetrics(const std::vector<TeachingOutcome>& seeds) : seeds_(seeds) {}

  std::vector<Metric> make() {
    for (std::size_t stage = 1; stage < stages(); ++stage) add_taught(stage);
    for (std::size_t stage = 0; stage < stages(); ++stage) add_known(stage);
    add("names_refused", [](const TeachingOutcome& seed) {
      return share_of_explorations(seed.refused, seed.names);
    });
    return std::move(metrics_);
  }

 private:
  std::size_t stages() const { return seeds_.front().stages.size(); }

  template <typename Value>  // of a seed
  void add(const std::string& name, const Value& value) {
    Metric metric{name, {}};
    metric.values.reserve(seeds_.size());
    for (const TeachingOutcome& seed : seeds_) metric.values.push_back(value(seed));
    metrics_.push_back(std::move(metric));
  }

  void add_taught(std::size_t stage) {
    const auto add_count = [&](const std::string& name, std::size_t RightNames::* count) {
      add(name + "_after_" + std::to_string(stage), [&](const TeachingOutcome& seed) {
        return share_of_explorations(seed.stages[stage].taught.*count, seed.taught_tested);
      });
    };
    add_count("taught_accuracy", &RightNames::answered);
    add_count("taught_accuracy_of_nearest", &RightNames::nearest);
    add_count("baseline_taught_accuracy", &RightNames::baseline);
  }

  void add_known(std::size_t stage) {
    const std::string after = "_after_" + std::to_string(stage);
    const auto add_count = [&](const std::string& name, std::size_t RightNames::* count) {
      add(name + after, [&](const TeachingOutcome& seed) {
        return share_of_explorations(seed.stages[stage].known.*count, seed.known_tested);
      });
    };
    add_count("known_accuracy", &RightNames::answered);
    add_count("known_accuracy_of_nearest", &RightNames::nearest);
    add_count("baseline_known_accuracy", &RightNames::baseline);
    if (stage == 0) return;
    add("known_changed" + after, [&](const TeachingOutcome& seed) {
      return share_of_explorations(seed.stages[stage].known_changed, seed.known_tested);
    });
  }

  const std::vector<TeachingOutcome>& seeds_;
  std::vector<Metric> metrics_;
};

}  // namespace

void TeachingOutcome::add(const TeachingOutcome& other) {
  stages.resize(other.stages.size());
  for (std::size_t i = 0; i < stages.size(); ++i) {
    add_to(stages[i].taught, other.stages[i].taught);
    add_to(stages[i].known, other.stages[i].known);
    stages[i].known_changed += other.stages[i].known_changed;
  }
  taught_tested += other.taught_tested;
  known_tested += other.known_tested;
  names += other.names;
  refused += other.refused;
}

std::vector<Metric> teaching_metrics(const std::vector<TeachingOutcome>& seeds) {
  return TeachingMetrics(seeds).make();
}

}  // namespace somato
