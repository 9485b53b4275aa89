#include "maps/online/growing_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "maps/support/growing_problems.h"

namespace somato {
namespace {

using testing::Values;
using Triangle = GrowingCells::Triangle;

// The rules one after the other; neurons are never renumbered but marked as removed.
class SlowCells {
 public:
  SlowCells(const GrowingCellsParameters& parameters, const std::vector<Values>& start)
      : p_(parameters), w_(start), counter_(3, 0.0), there_(3, true), triangles_{{0, 1, 2}} {}

  void learn(const Values& x) {
    std::size_t s = 0;
    while (!there_[s]) ++s;
    for (std::size_t i = 0; i < w_.size(); ++i) {
      if (there_[i] && testing::distance(w_[i], x) < testing::distance(w_[s], x)) s = i;
    }
    testing::move(w_[s], x, p_.winner_rate);
    for (const std::size_t i : neighbours(s)) testing::move(w_[i], x, p_.neighbour_rate);
    counter_[s] += 1.0;
    for (double& counter : counter_) counter *= 1.0 - p_.counter_decay;
    if (++inputs_ % p_.insertion_interval != 0) return;
    if (size() < p_.growth.most_neurons) insert();
    if (p_.deletion_threshold > 0.0) remove();
  }

  std::size_t size() const {
    return static_cast<std::size_t>(std::count(there_.begin(), there_.end(), true));
  }
  std::vector<Values> weights() const {
    std::vector<Values> left;
    for (std::size_t i = 0; i < w_.size(); ++i) {
      if (there_[i]) left.push_back(w_[i]);
    }
    return left;
  }
  std::size_t triangles() const { return triangles_.size(); }
  std::size_t removed() const { return w_.size() - size(); }

 private:
  std::set<std::size_t> neighbours(std::size_t s) const {
    std::set<std::size_t> around;
    for (const auto& triangle : triangles_) {
      if (triangle.contains(s)) around.insert(triangle.begin(), triangle.end());
    }
    around.erase(s);
    return around;
  }

  void insert() {
    std::size_t q = 0;
    for (std::size_t i = 0; i < w_.size(); ++i) {
      if (there_[i] && (!there_[q] || counter_[i] > counter_[q])) q = i;
    }
    std::size_t f = *neighbours(q).begin();
    for (const std::size_t i : neighbours(q)) {
      if (testing::distance(w_[q], w_[i]) > testing::distance(w_[q], w_[f])) f = i;
    }
    const std::size_t r = w_.size();
    w_.push_back(testing::mean(w_[q], w_[f]));
    there_.push_back(true);
    counter_.push_back(0.0);
    std::set<std::set<std::size_t>> divided;
    for (auto triangle : triangles_) {
      if (triangle.contains(q) && triangle.contains(f)) {
        for (const std::size_t gone : {q, f}) {
          std::set<std::size_t> half = triangle;
          half.erase(gone);
          half.insert(r);
          divided.insert(half);
        }
      } else {
        divided.insert(triangle);
      }
    }
    triangles_ = divided;
    const auto around = neighbours(r);
    for (const std::size_t i : around) {
      const double given = counter_[i] / static_cast<double>(around.size());
      counter_[i] -= given;
      counter_[r] += given;
    }
  }

  void remove() {
    double sum = 0.0;
    std::vector<std::pair<double, std::size_t>> all;
    for (std::size_t i = 0; i < w_.size(); ++i) {
      if (!there_[i]) continue;
      sum += counter_[i];
      all.emplace_back(counter_[i], i);
    }
    std::sort(all.begin(), all.end());
    const double mean = sum / static_cast<double>(all.size());
    for (const auto& [counter, i] : all) {
      if (counter >= p_.deletion_threshold * mean) break;
      auto others = triangles_;
      std::erase_if(others, [gone = i](const auto& triangle) { return triangle.contains(gone); });
      if (others.empty()) break;
      triangles_ = others;
    }
    for (std::size_t i = 0; i < w_.size(); ++i) {
      there_[i] = std::any_of(triangles_.begin(), triangles_.end(),
                              [i](const auto& triangle) { return triangle.contains(i); });
      if (!there_[i]) counter_[i] = 0.0;
    }
  }

  GrowingCellsParameters p_;
  std::vector<Values> w_;
  std::vector<double> counter_;
  std::vector<bool> there_;
  std::set<std::set<std::size_t>> triangles_;
  std::uint64_t inputs_ = 0;
};

GrowingCellsParameters small_cells(double deletion_threshold) {
  GrowingCellsParameters parameters;
  parameters.growth.most_neurons = 30;
  parameters.insertion_interval = 20;
  parameters.deletion_threshold = deletion_threshold;
  return parameters;
}

// Learns `inputs` random samples.
template <typename Learn>
void learn_samples(const Samples& samples, std::uint64_t seed, int inputs, const Learn& learn) {
  Random random(seed);
  for (int t = 0; t < inputs; ++t) learn(random.below(samples.count()));
}

TEST(GrowingCells, AreTheSlowCells) {
  std::size_t removed = 0;
  for (const double threshold : {0.0, 0.3}) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const Samples samples = testing::clustered_samples(50, 1 + seed % 3, seed);
      GrowingCellsParameters parameters = small_cells(threshold);
      parameters.growth.seed = seed;
      GrowingCells map(parameters, samples);
      SlowCells slow(parameters, testing::points_of(map.map()));
      std::vector<float> input(samples.size());
      learn_samples(samples, seed, 700, [&](std::size_t sample) {
        write_dense(samples[sample], input);
        map.learn(input);
        slow.learn(testing::point_of(samples, sample));
      });
      EXPECT_LT(testing::difference(testing::points_of(map.map()), slow.weights()), 1e-4) << seed;
      EXPECT_EQ(map.triangles().size(), slow.triangles());
      removed += slow.removed();
    }
  }
  EXPECT_GT(removed, 0U);
}

TEST(GrowingCells, GrowToTheirSizeByTrianglesOnly) {
  const Samples samples = testing::clustered_samples(50, 2, 3);
  GrowingCells map(small_cells(0.0), samples);
  std::vector<float> input(samples.size());
  learn_samples(samples, 1, 1000, [&](std::size_t sample) {
    write_dense(samples[sample], input);
    map.learn(input);
  });
  EXPECT_EQ(map.neurons(), 30U);
  // Without deletion, every insertion divides one or two triangles of a connected surface.
  const Som som = map.map();
  const NeuronGraph& graph = *som.grid().graph();
  EXPECT_EQ(std::set<std::size_t>(graph.parts().begin(), graph.parts().end()).size(), 1U);
  EXPECT_EQ(graph.size() + map.triangles().size(), graph.edges().size() + 1);  // Euler: a disc
}

// A sum s of counters becomes (s + 1) (1 - decay) with each input; shares do not change it.
TEST(GrowingCells, ShareTheirCountersWithoutLoss) {
  const Samples samples = testing::clustered_samples(50, 2, 4);
  GrowingCells map(small_cells(0.0), samples);
  std::vector<float> input(samples.size());
  double sum = 0.0;
  learn_samples(samples, 2, 400, [&](std::size_t sample) {
    write_dense(samples[sample], input);
    map.learn(input);
    sum = (sum + 1.0) * (1.0 - 0.005);
  });
  EXPECT_GT(map.neurons(), 20U);
  EXPECT_NEAR(std::accumulate(map.counters().begin(), map.counters().end(), 0.0), sum, 1e-9);
}

// Two distant groups: the neurons between them never win, and without them the map falls apart.
TEST(GrowingCells, FallApartWhereNeuronsAreDeleted) {
  Matrix<float> points(40, 2);
  Random random(9);
  for (std::size_t i = 0; i < 40; ++i) {
    points(i, 0) = static_cast<float>((i % 2 == 0 ? 0.0 : 100.0) + random.normal());
    points(i, 1) = static_cast<float>(random.normal());
  }
  const Samples samples(std::move(points));
  const auto parts = [&](double threshold) {
    GrowingCells map(small_cells(threshold), samples);
    std::vector<float> input(2);
    learn_samples(samples, 3, 1500, [&](std::size_t sample) {
      write_dense(samples[sample], input);
      map.learn(input);
    });
    const auto of_neurons = map.map().grid().graph()->parts();
    return std::set<std::size_t>(of_neurons.begin(), of_neurons.end()).size();
  };
  EXPECT_EQ(parts(0.0), 1U);
  EXPECT_GE(parts(0.1), 2U);
}

}  // namespace
}  // namespace somato
