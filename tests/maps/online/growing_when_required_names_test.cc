// growing_when_required with by_names: the share of neurons, the Manhattan distance, and what the
// unit of the data changes.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "maps/online/growing_when_required.h"
#include "maps/support/growing_problems.h"
#include "somato/core/check.h"

namespace somato {
namespace {

using testing::Values;

constexpr std::size_t kNamedSamples = 60;
constexpr std::size_t kPasses = 4;

// Clusters whose classes overlap; columns of `size` elements.
NamedSamples overlapping(std::size_t size, std::uint64_t seed) {
  NamedSamples named{testing::clustered_samples(kNamedSamples, size, seed), {}};
  Random random(seed + 90);
  for (std::size_t i = 0; i < kNamedSamples; ++i) named.classes.push_back(random.below(3));
  return named;
}

GrowingWhenRequiredParameters sharing(Similarity similarity, double share) {
  GrowingWhenRequiredParameters parameters;
  parameters.by_names = true;
  parameters.most_share = share;
  parameters.similarity = similarity;
  parameters.activity_threshold = 0.22;
  parameters.habituation_threshold = 2.0;
  parameters.insertion_share = 1.0;
  return parameters;
}

// In their order, kPasses times.
Som grown(const GrowingWhenRequiredParameters& parameters, const NamedSamples& named) {
  GrowingWhenRequired map(parameters, named);
  std::vector<float> input(named.samples.size());
  for (std::size_t t = 0; t < kPasses * named.samples.count(); ++t) {
    const std::size_t sample = t % named.samples.count();
    write_dense(named.samples[sample], input);
    map.learn_named(input, named.classes[sample]);
  }
  return map.map();
}

std::vector<std::size_t> winners_by(const Som& som, const Samples& samples) {
  std::vector<std::size_t> winners;
  std::vector<float> input(samples.size());
  for (std::size_t i = 0; i < samples.count(); ++i) {
    write_dense(samples[i], input);
    winners.push_back(som.winner(input));
  }
  return winners;
}

// The rule on lists in double precision.
class SlowNames {
 public:
  SlowNames(Similarity similarity, double share, double far)
      : similarity_(similarity), share_(share), far_(far) {}

  void start(const Values& x, std::size_t name) { add(x, name); }

  void learn(const Values& x, std::size_t name, double samples_of_class) {
    std::size_t winner = 0;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      if (distance(weights[i], x) < distance(weights[winner], x)) winner = i;
    }
    const auto kept = static_cast<double>(std::count(names.begin(), names.end(), name));
    const bool may_add = kept < std::max(1.0, std::floor(share_ * samples_of_class));
    if (may_add && (names[winner] != name || distance(weights[winner], x) > far_)) {
      add(x, name);
      return;
    }
    std::size_t own = weights.size();
    for (std::size_t i = 0; i < weights.size(); ++i) {
      if (names[i] != name) continue;
      if (own == weights.size() || distance(weights[i], x) < distance(weights[own], x)) own = i;
    }
    testing::move(weights[own], x, 1.0 / ++moved_[own]);
  }

  std::vector<Values> weights;
  std::vector<std::size_t> names;

 private:
  void add(const Values& x, std::size_t name) {
    weights.push_back(x);
    names.push_back(name);
    moved_.push_back(1.0);
  }

  double distance(const Values& a, const Values& b) const {
    if (similarity_ == Similarity::kEuclidean) return testing::distance(a, b);
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
    return sum;
  }

  Similarity similarity_;
  double share_;
  double far_;
  std::vector<double> moved_;
};

std::size_t sample_at(const NamedSamples& named, const Values& weights) {
  for (std::size_t i = 0; i < named.samples.count(); ++i) {
    if (testing::point_of(named.samples, i) == weights) return i;
  }
  ADD_FAILURE() << "no such sample";
  return 0;
}

TEST(GrowingByNames, KeepsAShareLikeTheSlowRule) {
  for (const Similarity similarity : {Similarity::kEuclidean, Similarity::kManhattan}) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      const NamedSamples named = overlapping(3, seed);
      GrowingWhenRequiredParameters parameters = sharing(similarity, 0.3);
      parameters.distance_unit = 1.2;
      parameters.growth.seed = seed;
      SlowNames slow(similarity, 0.3, -1.2 * std::log(parameters.activity_threshold));
      for (const Values& w : testing::points_of(GrowingWhenRequired(parameters, named).map())) {
        slow.start(w, named.classes[sample_at(named, w)]);
      }
      for (std::size_t t = 0; t < kPasses * kNamedSamples; ++t) {
        const std::size_t sample = t % kNamedSamples;
        const auto its_class = named.classes[sample];
        const auto samples = std::count(named.classes.begin(), named.classes.end(), its_class);
        slow.learn(testing::point_of(named.samples, sample), its_class,
                   static_cast<double>(samples));
      }
      const Som som = grown(parameters, named);
      EXPECT_LT(testing::difference(testing::points_of(som), slow.weights), 1e-4) << seed;
      EXPECT_LE(som.neurons(), kNamedSamples * 3 / 10) << seed;
      EXPECT_EQ(som.parameters().similarity, similarity);
    }
  }
}

// However small the share is, every class has a neuron.
TEST(GrowingByNames, EveryClassHasANeuron) {
  const NamedSamples named{Samples(Matrix<float>(6, 1, {0, 0.5F, 1, 9, 10, 30})),
                           {0, 0, 0, 1, 1, 2}};
  const Som som = grown(sharing(Similarity::kEuclidean, 0.0), named);
  std::vector<std::size_t> winners = winners_by(som, named.samples);
  EXPECT_NE(winners[0], winners[4]);
  EXPECT_NE(winners[4], winners[5]);
  EXPECT_LE(som.neurons(), 4U);  // of the two first neurons both may be of one class
}

// The share counts what is learned later as well.
// 0.29 times 100 is below 29 in double precision.
TEST(GrowingByNames, AShareThatIsAWholeNumberIsReached) {
  Random random(29);
  Matrix<float> rows(200, 2);
  for (float& value : rows.values()) value = static_cast<float>(random.normal());
  NamedSamples named{Samples(std::move(rows)), {}};
  for (std::size_t i = 0; i < 200; ++i) named.classes.push_back(i % 2);
  EXPECT_EQ(grown(sharing(Similarity::kEuclidean, 0.29), named).neurons(), 58U);
}

TEST(GrowingByNames, TheShareGrowsWithWhatIsSeen) {
  NamedSamples named = overlapping(2, 7);
  std::fill(named.classes.begin(), named.classes.end(), std::size_t{0});
  GrowingWhenRequiredParameters parameters = sharing(Similarity::kEuclidean, 0.1);
  parameters.activity_threshold = 1.0;  // every input that differs is far
  GrowingWhenRequired map(parameters, named);
  std::vector<float> input(2);
  const auto learn_all = [&] {
    for (std::size_t i = 0; i < kNamedSamples; ++i) {
      write_dense(named.samples[i], input);
      map.learn_named(input, 0);
    }
    return map.neurons();
  };
  EXPECT_EQ(learn_all(), 6U);
  EXPECT_EQ(learn_all(), 6U);
  map.see(named);
  EXPECT_EQ(learn_all(), 12U);
}

Samples changed(const Samples& samples, double factor, const std::vector<std::size_t>& columns,
                std::size_t constants) {
  Matrix<float> rows(samples.count(), columns.size() + constants);
  for (std::size_t i = 0; i < samples.count(); ++i) {
    const Values values = testing::point_of(samples, i);
    for (std::size_t d = 0; d < columns.size(); ++d) {
      rows(i, d) = static_cast<float>(factor * values[columns[d]]);
    }
    for (std::size_t d = columns.size(); d < rows.columns(); ++d) rows(i, d) = 1e6F;
  }
  return Samples(std::move(rows));
}

// Doubling is exact, so that every step has the same bits.
TEST(GrowingByNames, APowerOfTwoChangesNoBits) {
  for (const bool by_names : {false, true}) {
    for (const Similarity similarity : {Similarity::kEuclidean, Similarity::kManhattan}) {
      const NamedSamples named = overlapping(3, 11);
      GrowingWhenRequiredParameters parameters = sharing(similarity, 0.3);
      parameters.by_names = by_names;
      const Som som = grown(parameters, named);
      const Som large =
          grown(parameters, {changed(named.samples, 1024.0, {0, 1, 2}, 0), named.classes});
      EXPECT_EQ(large.grid(), som.grid());
      Matrix<float> scaled = som.weights().to_matrix();
      for (float& value : scaled.values()) value *= 1024.0F;
      EXPECT_EQ(large.weights().to_matrix(), scaled);
    }
  }
}

// Other factors, constant elements and another order of elements round differently: the same
// neurons win.
TEST(GrowingByNames, UnitsConstantsAndOrderChangeNoWinner) {
  struct Change {
    double factor;
    std::vector<std::size_t> columns;
    std::size_t constants;
  };
  for (const Similarity similarity : {Similarity::kEuclidean, Similarity::kManhattan}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const NamedSamples named = overlapping(3, seed);
      const GrowingWhenRequiredParameters parameters = sharing(similarity, 0.3);
      const Som som = grown(parameters, named);
      for (const Change& change : {Change{1000.0, {0, 1, 2}, 0}, Change{1e-3, {0, 1, 2}, 0},
                                   Change{1.0, {0, 1, 2}, 1}, Change{1.0, {2, 0, 1}, 0}}) {
        const Samples samples =
            changed(named.samples, change.factor, change.columns, change.constants);
        const Som other = grown(parameters, {samples, named.classes});
        EXPECT_EQ(other.grid(), som.grid()) << change.factor;
        EXPECT_EQ(winners_by(other, samples), winners_by(som, named.samples)) << change.factor;
      }
    }
  }
}

TEST(GrowingByNames, OnlyAMapThatLearnsNamesIsRefinedByThem) {
  const NamedSamples named = overlapping(2, 3);
  GrowingWhenRequired map(sharing(Similarity::kEuclidean, 0.3), named);
  const Som two = map.map();
  EXPECT_THROW(map.refine(two, {0}), InvalidArgument);
  map.refine(two, {5, 5});
  map.learn_named(std::vector<float>{0, 0}, 5);
  EXPECT_EQ(map.neurons(), 2U);  // its own class is full
  GrowingWhenRequired without({}, named);
  EXPECT_THROW(without.refine(without.map(), {0, 1}), InvalidArgument);
}

}  // namespace
}  // namespace somato
