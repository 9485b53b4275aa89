#include "maps/online/growing_when_required.h"

#include <gtest/gtest.h>

#include <cmath>

#include "maps/support/growing_problems.h"
#include "somato/core/check.h"

namespace somato {
namespace {

using testing::Values;

// The rules one after the other, on a table of ages, in double precision.
class SlowMap {
 public:
  SlowMap(const GrowingWhenRequiredParameters& parameters, const std::vector<Values>& start)
      : p_(parameters), w_(start), h_(2, 1.0), age_(2, std::vector<int>(2, kNone)) {}

  void learn(const Values& x) {
    std::size_t s = testing::nearest(w_, x);
    std::size_t t = testing::nearest(w_, x, s);
    set_age(s, t, 0);
    const double unit = std::sqrt(static_cast<double>(x.size()));
    const double activity = std::exp(-testing::distance(w_[s], x) / unit);
    if (activity < p_.activity_threshold && h_[s] < p_.habituation_threshold &&
        (w_.size() < p_.growth.most_neurons || replace(testing::distance(w_[s], x)))) {
      s = testing::nearest(w_, x);
      t = testing::nearest(w_, x, s);
      w_.push_back(w_[s]);
      testing::move(w_.back(), x, p_.insertion_share);
      h_.push_back(1.0);
      for (auto& row : age_) row.push_back(kNone);
      age_.emplace_back(w_.size(), kNone);
      set_age(w_.size() - 1, s, 0);
      set_age(w_.size() - 1, t, 0);
      set_age(s, t, kNone);
    } else {
      testing::move(w_[s], x, p_.winner_rate * h_[s]);
      for (std::size_t i = 0; i < w_.size(); ++i) {
        if (age_[s][i] != kNone) testing::move(w_[i], x, p_.neighbour_rate * h_[i]);
      }
    }
    h_[s] += (p_.recovery * (1.0 - h_[s]) - 1.0) / p_.winner_habituation_time;
    for (std::size_t i = 0; i < w_.size(); ++i) {
      if (age_[s][i] == kNone) continue;
      h_[i] += (p_.recovery * (1.0 - h_[i]) - 1.0) / p_.neighbour_habituation_time;
      const int older = age_[s][i] + 1;
      set_age(s, i, older > static_cast<int>(p_.oldest_edge) ? kNone : older);
    }
    for (std::size_t i = w_.size(); i-- > 0;) {
      const auto is_edge = [](int age) { return age != kNone; };
      if (std::none_of(age_[i].begin(), age_[i].end(), is_edge)) remove(i);
    }
  }

  const std::vector<Values>& weights() const { return w_; }
  std::vector<NeuronGraph::Edge> edges() const {
    std::vector<NeuronGraph::Edge> edges;
    for (std::size_t a = 0; a < w_.size(); ++a) {
      for (std::size_t b = a + 1; b < w_.size(); ++b) {
        if (age_[a][b] != kNone) edges.emplace_back(a, b);
      }
    }
    return edges;
  }
  std::size_t removed() const { return removed_; }
  std::size_t replaced() const { return replaced_; }

 private:
  static constexpr int kNone = -1;

  void set_age(std::size_t a, std::size_t b, int age) { age_[a][b] = age_[b][a] = age; }

  // All pairs; the later neuron of the nearest one is removed.
  bool replace(double limit) {
    if (!p_.replace_when_full) return false;
    std::size_t kept = 0;
    std::size_t removed = 1;
    for (std::size_t a = 0; a < w_.size(); ++a) {
      for (std::size_t b = a + 1; b < w_.size(); ++b) {
        if (testing::distance(w_[a], w_[b]) >= testing::distance(w_[kept], w_[removed])) continue;
        kept = a;
        removed = b;
      }
    }
    if (testing::distance(w_[kept], w_[removed]) >= limit) return false;
    for (std::size_t i = 0; i < w_.size(); ++i) {
      if (i != kept && age_[removed][i] != kNone && age_[kept][i] == kNone) {
        set_age(kept, i, age_[removed][i]);
      }
    }
    remove(removed);
    --removed_;
    ++replaced_;
    return true;
  }

  void remove(std::size_t i) {
    const auto at = static_cast<std::ptrdiff_t>(i);
    w_.erase(w_.begin() + at);
    h_.erase(h_.begin() + at);
    age_.erase(age_.begin() + at);
    for (auto& row : age_) row.erase(row.begin() + at);
    ++removed_;
  }

  GrowingWhenRequiredParameters p_;
  std::vector<Values> w_;
  std::vector<double> h_;
  std::vector<std::vector<int>> age_;
  std::size_t removed_ = 0;
  std::size_t replaced_ = 0;
};

GrowingWhenRequiredParameters eager() {
  GrowingWhenRequiredParameters parameters;
  parameters.growth.most_neurons = 40;
  parameters.activity_threshold = 0.6;
  parameters.oldest_edge = 6;
  return parameters;
}

TEST(GrowingWhenRequired, IsTheSlowMap) {
  std::size_t grown = 0;
  std::size_t removed = 0;
  std::size_t replaced = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Samples samples = testing::clustered_samples(60, 1 + seed % 4, seed);
    GrowingWhenRequiredParameters parameters = eager();
    parameters.growth.seed = seed;
    parameters.distance_unit = std::sqrt(static_cast<double>(samples.size()));
    parameters.insertion_share = seed % 2 == 0 ? 0.5 : 1.0;
    if (seed > 4) {
      parameters.replace_when_full = true;
      parameters.growth.most_neurons = 3 + seed;
    }
    GrowingWhenRequired map(parameters, {samples});
    SlowMap slow(parameters, testing::points_of(map.map()));
    Random random(seed);
    std::vector<float> input(samples.size());
    for (int t = 0; t < 400; ++t) {
      const std::size_t sample = random.below(samples.count());
      write_dense(samples[sample], input);
      map.learn(input);
      slow.learn(testing::point_of(samples, sample));
    }
    const Som som = map.map();
    EXPECT_LT(testing::difference(testing::points_of(som), slow.weights()), 1e-4) << seed;
    EXPECT_EQ(som.grid().graph()->edges(), slow.edges()) << seed;
    grown += som.neurons();
    removed += slow.removed();
    replaced += slow.replaced();
    EXPECT_LE(som.neurons(), parameters.growth.most_neurons);
  }
  EXPECT_GT(grown, 8U * 10U);  // otherwise nothing was compared
  EXPECT_GT(removed, 0U);
  EXPECT_GT(replaced, 8U);
}

// Two neurons at 0 and 10; 4 is exp(-4) from 0, below the threshold. A new neuron allows no
// insertion with a habituation threshold of 0.3, and every one with 2.
TEST(GrowingWhenRequired, InsertsBetweenTheInputAndTheWinner) {
  const Samples samples(Matrix<float>(2, 1, {0, 10}));
  GrowingWhenRequiredParameters parameters = eager();
  parameters.distance_unit = 1.0;
  parameters.habituation_threshold = 2.0;
  GrowingWhenRequired map(parameters, {samples});
  map.learn(std::vector<float>{4});
  const Som som = map.map();
  ASSERT_EQ(som.neurons(), 3U);
  EXPECT_EQ(som.weight(2, 0), 2.0F);
  const std::size_t winner = som.weight(0, 0) == 0.0F ? 0 : 1;
  EXPECT_EQ(som.grid().graph()->edges(), (std::vector<NeuronGraph::Edge>{{0, 2}, {1, 2}}));
  EXPECT_EQ(som.weight(winner, 0), 0.0F);  // it did not move

  parameters.habituation_threshold = 0.3;
  GrowingWhenRequired waiting(parameters, {samples});
  waiting.learn(std::vector<float>{4});
  EXPECT_EQ(waiting.neurons(), 2U);
}

// Neurons stay where they are, however much the map learns elsewhere.
TEST(GrowingWhenRequired, ForgetsNothingFarAway) {
  GrowingWhenRequiredParameters parameters = eager();
  parameters.habituation_threshold = 2.0;
  GrowingWhenRequired map(parameters, {Samples(Matrix<float>(2, 1, {0, 1}))});
  const auto learn = [&](float centre) {
    for (int i = 0; i < 200; ++i) map.learn(std::vector<float>{centre + static_cast<float>(i % 2)});
  };
  learn(0.0F);
  const double before = testing::distance(
      {0.0}, testing::points_of(map.map())[testing::nearest(testing::points_of(map.map()), {0.0})]);
  learn(100.0F);
  const std::vector<Values> after = testing::points_of(map.map());
  EXPECT_LT(testing::distance({0.0}, after[testing::nearest(after, {0.0})]), before + 0.3);
  EXPECT_LT(testing::distance({100.0}, after[testing::nearest(after, {100.0})]), 0.6);
}

// The map after it has learned the samples one after the other, three times.
Som learned_from(const GrowingWhenRequiredParameters& parameters, const NamedSamples& named) {
  GrowingWhenRequired map(parameters, named);
  std::vector<float> input(named.samples.size());
  for (std::size_t t = 0; t < 3 * named.samples.count(); ++t) {
    const std::size_t sample = t % named.samples.count();
    write_dense(named.samples[sample], input);
    map.learn_named(input, named.classes.empty() ? 0 : named.classes[sample]);
  }
  return map.map();
}

Samples changed(const Samples& samples, float factor, std::size_t constants) {
  Matrix<float> rows(samples.count(), samples.size() + constants, 3.0F);
  for (std::size_t i = 0; i < samples.count(); ++i) {
    write_dense(samples[i], rows.row(i).first(samples.size()));
    for (std::size_t d = 0; d < samples.size(); ++d) rows(i, d) *= factor;
  }
  return Samples(std::move(rows));
}

// All products with 1024 are exact, those with 1000 are not.
TEST(GrowingWhenRequired, TheAutomaticUnitFollowsTheInputs) {
  const Samples samples = testing::clustered_samples(40, 3, 2);
  GrowingWhenRequiredParameters parameters = eager();
  parameters.activity_threshold = 0.2;
  parameters.habituation_threshold = 2.0;
  const Som before = learned_from(parameters, {samples});
  EXPECT_GT(before.neurons(), 5U);
  EXPECT_LT(before.neurons(), 40U);
  for (const float factor : {1024.0F, 1000.0F, 0.001F}) {
    EXPECT_EQ(learned_from(parameters, {changed(samples, factor, 0)}).grid(), before.grid());
  }
  EXPECT_EQ(learned_from(parameters, {changed(samples, 1.0F, 2)}).grid(), before.grid());
  EXPECT_EQ(learned_from(parameters, {changed(samples, 1024.0F, 0)}).weight(4, 1),
            1024.0F * before.weight(4, 1));
}

// Nothing differs at first, so that nothing gives distances a unit.
TEST(GrowingWhenRequired, WithoutAUnitEveryOtherInputIsFar) {
  GrowingWhenRequiredParameters parameters = eager();
  parameters.habituation_threshold = 2.0;
  parameters.insertion_share = 1.0;
  GrowingWhenRequired map(parameters, {Samples(Matrix<float>(2, 1, {5, 5}))});
  map.learn(std::vector<float>{5});
  EXPECT_EQ(map.neurons(), 2U);
  map.learn(std::vector<float>{5.25F});
  EXPECT_EQ(map.neurons(), 3U);
}

struct NamedRows {
  std::vector<Values> weights;
  std::vector<std::size_t> names;
};

// The rule of names, one line after the other, for a distance above which an input is far.
NamedRows slow_names(const NamedSamples& named, NamedRows rows, double far) {
  std::vector<double> won(rows.names.size(), 1.0);
  for (std::size_t t = 0; t < 3 * named.samples.count(); ++t) {
    const std::size_t sample = t % named.samples.count();
    const Values x = testing::point_of(named.samples, sample);
    const std::size_t s = testing::nearest(rows.weights, x);
    if (rows.names[s] != named.classes[sample] || testing::distance(rows.weights[s], x) > far) {
      rows.weights.push_back(x);
      rows.names.push_back(named.classes[sample]);
      won.push_back(1.0);
    } else {
      won[s] += 1.0;
      testing::move(rows.weights[s], x, 1.0 / won[s]);
    }
  }
  return rows;
}

NamedSamples named_samples(std::uint64_t seed) {
  NamedSamples named{testing::clustered_samples(40, 2, seed), {}};
  Random random(seed + 50);
  for (std::size_t i = 0; i < 40; ++i) named.classes.push_back(random.below(3));
  return named;
}

TEST(GrowingWhenRequired, ByNamesIsTheSlowRule) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const NamedSamples named = named_samples(seed);
    GrowingWhenRequiredParameters parameters;
    parameters.by_names = true;
    parameters.distance_unit = 1.5;
    parameters.habituation_threshold = 2.0;
    parameters.insertion_share = 1.0;
    parameters.oldest_edge = 3;
    NamedRows start{testing::points_of(GrowingWhenRequired(parameters, named).map()), {}};
    for (const Values& weights : start.weights) {
      for (std::size_t i = 0; i < named.classes.size(); ++i) {
        if (testing::point_of(named.samples, i) != weights) continue;
        start.names.push_back(named.classes[i]);
        break;
      }
    }
    const NamedRows slow = slow_names(named, start, -1.5 * std::log(parameters.activity_threshold));
    const Som som = learned_from(parameters, named);
    EXPECT_LT(testing::difference(testing::points_of(som), slow.weights), 1e-4) << seed;
  }
}

// With names, a map of two classes at the same distance from each other has both.
TEST(GrowingWhenRequired, ByNamesSeparatesWhatIsNear) {
  const NamedSamples named{Samples(Matrix<float>(4, 1, {0, 1, 0.5F, 20})), {0, 0, 1, 0}};
  GrowingWhenRequiredParameters parameters;
  parameters.by_names = true;
  parameters.distance_unit = 1000.0;
  EXPECT_GE(learned_from(parameters, named).neurons(), 3U);
  parameters.by_names = false;
  EXPECT_EQ(learned_from(parameters, named).neurons(), 2U);
  parameters.by_names = true;
  EXPECT_THROW(GrowingWhenRequired(parameters, {named.samples}), InvalidArgument);
}

TEST(GrowingWhenRequired, IsTheSameForTheSameSeed) {
  const Samples samples = testing::clustered_samples(30, 3, 5);
  const auto grown = [&](std::uint64_t seed) {
    GrowingWhenRequiredParameters parameters = eager();
    parameters.growth.seed = seed;
    parameters.growth.iterations = 300;
    GrowingWhenRequired map(parameters, {samples});
    EXPECT_TRUE(grow(map, parameters.growth, {samples}, {}, {}));
    return map.map();
  };
  EXPECT_EQ(grown(1).weights(), grown(1).weights());
  EXPECT_EQ(grown(1).grid(), grown(1).grid());
  EXPECT_FALSE(grown(1).weights() == grown(2).weights());
}

}  // namespace
}  // namespace somato
