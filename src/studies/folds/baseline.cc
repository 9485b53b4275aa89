#include "studies/folds/baseline.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "base/core/values_at.h"
#include "somato/codes/standardization.h"
#include "studies/measures/nearest_neighbour.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

constexpr std::size_t kInnerFolds = 5;

// Neighbours among the training samples, by all kinds.
class NeighbourSearch {
 public:
  NeighbourSearch(Samples raw, Numbers training)
      : raw_(std::move(raw)), training_(std::move(training)) {
    if (training_.size() < 2) return;
    const auto standardization =
        Standardization::fit(raw_.subset(training_), {ConstantColumns::kZero});
    if (standardization) standardized_ = standardization->apply(raw_);
  }

  Numbers find(const NeighbourKind& kind, const Numbers& tests) const {
    const Samples& samples = kind.standardized && standardized_ ? *standardized_ : raw_;
    return nearest_neighbours(samples, training_, tests, kind.distance);
  }

 private:
  Samples raw_;
  Numbers training_;
  std::optional<Samples> standardized_;
};

// A column that is 0 in all training samples takes a tested one as far from each of them, and is 0
// once standardized.
Samples narrowed(const Samples& samples, const Numbers& training) {
  return StoredElements::used_by(samples.subset(training)).gather(samples);
}

// Whole groups, dealt to at most kInnerFolds parts; none if there is one group only.
std::vector<Fold> folds_of_groups(const Numbers& training, const Numbers& groups) {
  const Numbers group_of = values_at(groups, training);
  const std::set<std::size_t> distinct(group_of.begin(), group_of.end());
  std::vector<Fold> folds(std::min(distinct.size(), kInnerFolds));
  if (folds.size() < 2) return {};
  for (std::size_t i = 0; i < training.size(); ++i) {
    const auto place =
        static_cast<std::size_t>(std::distance(distinct.begin(), distinct.find(group_of[i])));
    for (std::size_t f = 0; f < folds.size(); ++f) {
      (place % folds.size() == f ? folds[f].test : folds[f].training).push_back(training[i]);
    }
  }
  return folds;
}

std::vector<Fold> divided(const Numbers& training, const Classes& classes, std::uint64_t seed,
                          const InnerFolds& inner) {
  if (training.size() < 2) return {};
  if (!inner.groups.empty()) {
    std::vector<Fold> groups = folds_of_groups(training, inner.groups);
    if (!groups.empty()) return groups;
  }
  return folds_among(training, classes.of_sample, kInnerFolds, seed, inner.choice);
}

// `most` of the samples, evenly spaced in the order of their classes.
Numbers evenly(Numbers samples, const Classes& classes, std::size_t most) {
  if (samples.size() <= most) return samples;
  std::sort(samples.begin(), samples.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(classes.of_sample[a], a) < std::pair(classes.of_sample[b], b);
  });
  Numbers some;
  some.reserve(most);
  for (std::size_t i = 0; i < most; ++i) some.push_back(samples[i * samples.size() / most]);
  return some;
}

// The kind for each label that names most of the training samples rightly in inner folds.
Numbers best_kinds(const ExplorationValues& vectors, const PreparedStudy& prepared,
                   const Numbers& training, const InnerFolds& inner) {
  const auto& labels = prepared.labels;
  const Classes& classes = prepared.classes();
  const ExplorationValues own{training, vectors.samples.subset(vectors.places_of(training))};
  std::vector<std::array<std::size_t, kNeighbourKinds.size()>> right(labels.size());
  for (auto& of_label : right) of_label.fill(0);
  for (const Fold& fold : divided(training, classes, prepared.samples.seed, inner)) {
    const std::size_t most =
        (inner.most_tests * fold.test.size() + training.size() - 1) / training.size();
    const Numbers tests = evenly(fold.test, classes, most);
    const Numbers learned = own.places_of(fold.training);
    const NeighbourSearch search(narrowed(own.samples, learned), learned);
    for (std::size_t kind = 0; kind < kNeighbourKinds.size(); ++kind) {
      const Numbers nearest = search.find(kNeighbourKinds[kind], own.places_of(tests));
      for (std::size_t l = 0; l < labels.size(); ++l) {
        const Numbers& of = labels[l].classes.of_sample;
        for (std::size_t i = 0; i < tests.size(); ++i) {
          right[l][kind] += of[training[nearest[i]]] == of[tests[i]] ? 1 : 0;
        }
      }
    }
  }
  Numbers best;
  best.reserve(labels.size());
  for (const auto& of_label : right) {
    const auto most = std::max_element(of_label.begin(), of_label.end());
    best.push_back(static_cast<std::size_t>(most - of_label.begin()));
  }
  return best;
}

// The neighbours of `test`, as numbers of explorations.
Numbers neighbours_of(const NeighbourSearch& search, const NeighbourKind& kind,
                      const ExplorationValues& vectors, const Numbers& test) {
  return values_at(vectors.explorations, search.find(kind, vectors.places_of(test)));
}

Neighbours neighbours_of(const NeighbourSearch& search, const ExplorationValues& vectors,
                         const Numbers& test) {
  return {neighbours_of(search, kNeighbourKinds[0], vectors, test),
          neighbours_of(search, kNeighbourKinds[1], vectors, test)};
}

// Those of a kind are searched once for all labels.
void add_best(const NeighbourSearch& search, const ExplorationValues& vectors, const Numbers& kinds,
              const Numbers& test, Neighbours& nearest) {
  std::array<std::optional<Numbers>, kNeighbourKinds.size()> found;
  found[0] = nearest.raw;
  found[1] = nearest.standardized;
  for (const std::size_t kind : kinds) {
    if (!found[kind]) found[kind] = neighbours_of(search, kNeighbourKinds[kind], vectors, test);
    nearest.best.push_back({kind, *found[kind]});
  }
}

}  // namespace

std::string NeighbourKind::name() const {
  return choice_name(distance) + (standardized ? ", standardized" : ", raw");
}

InnerFolds inner_folds_for(Protocol protocol, const FoldSamples& samples, std::size_t trainings) {
  constexpr std::size_t kTestsOfAll = 5000;
  InnerFolds inner{samples.choice};
  inner.most_tests = std::clamp<std::size_t>(kTestsOfAll / trainings, 200, 1000);
  if (protocol == Protocol::kLeaveOneOut) inner.choice = FoldChoice::kInterleaved;
  if (protocol == Protocol::kLeaveGroupOut) inner.groups = samples.groups;
  return inner;
}

std::vector<Neighbours> nearest_neighbours(const ExplorationValues& vectors, const Numbers& learned,
                                           const std::vector<Numbers>& tests) {
  const Numbers training = vectors.places_of(learned);
  const NeighbourSearch search(narrowed(vectors.samples, training), training);
  std::vector<Neighbours> nearest;
  nearest.reserve(tests.size());
  for (const Numbers& test : tests) nearest.push_back(neighbours_of(search, vectors, test));
  return nearest;
}

std::vector<Neighbours> nearest_neighbours(const ExplorationValues& vectors,
                                           const PreparedStudy& prepared, const Fold& fold,
                                           const InnerFolds& inner) {
  std::vector<Numbers> tests{fold.test};
  for (std::size_t i = 0; i < prepared.alterations.size(); ++i) {
    tests.push_back(prepared.altered(fold.test, i));
  }
  const Numbers training = vectors.places_of(fold.training);
  const NeighbourSearch search(narrowed(vectors.samples, training), training);
  const Numbers kinds = best_kinds(vectors, prepared, fold.training, inner);
  std::vector<Neighbours> nearest;
  nearest.reserve(tests.size());
  for (const Numbers& test : tests) {
    nearest.push_back(neighbours_of(search, vectors, test));
    add_best(search, vectors, kinds, test, nearest.back());
  }
  return nearest;
}

}  // namespace somato
