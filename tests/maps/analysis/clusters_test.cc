#include "somato/maps/clusters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "maps/support/random_maps.h"
#include "somato/core/check.h"
#include "somato/core/random.h"
#include "somato/maps/som_quality.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

Som row_with(std::vector<float> weights) {
  SomParameters p;
  p.rows = 1;
  p.columns = weights.size();
  return Som(resolve(p, 1, 1).value(), Matrix<float>(*p.columns, 1, std::move(weights)));
}

Som random_som(std::size_t rows, std::size_t columns, std::size_t features, Random& random) {
  SomParameters p;
  p.rows = rows;
  p.columns = columns;
  Matrix<float> weights(rows * columns, features);
  for (float& value : weights.values()) value = static_cast<float>(random.normal());
  return Som(resolve(p, 1, features).value(), weights);
}

// The rows of a map, each as many times as its neuron has hits, as a map without hits.
std::pair<Som, Numbers> repeated(const Som& som, const Numbers& hits) {
  Matrix<float> rows(0, som.input_size());
  Numbers origins;
  for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
    for (std::size_t i = 0; i < hits[neuron]; ++i) {
      som.weights().copy_row(neuron, rows.add_row());
      origins.push_back(neuron);
    }
  }
  SomParameters p;
  p.rows = 1;
  p.columns = rows.rows();
  return {Som(resolve(p, 1, rows.columns()).value(), rows), origins};
}

ClusterParameters with(ClusterMethod method, std::optional<std::size_t> count = {}) {
  ClusterParameters parameters;
  parameters.method = method;
  parameters.count = count;
  return parameters;
}

Numbers cluster_labels(const Som& som, const ClusterParameters& parameters,
                       const Numbers& hits = {}) {
  return cluster_neurons(som, parameters, hits).value().of_neuron;
}

TEST(Clusters, AreFoundByAllMethods) {
  const Som som = row_with({0, 1, 2, 50, 51, 52, 100, 101});
  const Numbers expected{0, 0, 0, 1, 1, 1, 2, 2};
  for (const auto& [method, name] : Choices<ClusterMethod>::all()) {
    EXPECT_EQ(cluster_labels(som, with(method, 3)), expected) << name;
  }
  for (const auto& [index, name] : Choices<ClusterIndex>::all()) {
    for (const ClusterMethod method : {ClusterMethod::kWard, ClusterMethod::kKMeans}) {
      ClusterParameters parameters = with(method);
      parameters.index = index;
      EXPECT_EQ(cluster_labels(som, parameters), expected) << name;
    }
  }
}

// By hand: means 0.5 and 10, spreads 0.5 and 0, 9.5 apart.
TEST(ClusterIndices, AreAsByHand) {
  const Som som = row_with({0, 1, 10});
  const Clusters clusters{{0, 0, 1}, 2, {}};
  EXPECT_DOUBLE_EQ(davies_bouldin_index(som, clusters), 0.5 / 9.5);
  EXPECT_DOUBLE_EQ(silhouette_index(som, clusters), (9.0 / 10 + 8.0 / 9 + 0) / 3);
  EXPECT_TRUE(std::isnan(davies_bouldin_index(som, {{0, 0, 0}, 1, {}})));
  EXPECT_TRUE(std::isnan(silhouette_index(som, {{0, 0, 0}, 1, {}})));
  EXPECT_TRUE(std::isinf(davies_bouldin_index(row_with({1, 1, 2}), {{0, 1, 2}, 3, {}})));
  EXPECT_THROW((void)davies_bouldin_index(som, {{0}, 1, {}}), InvalidArgument);
}

// A neuron with three hits is three equal neurons, and one without hits is none.
TEST(Clusters, ByHitsAreThoseOfRepeatedNeurons) {
  Random random(7);
  for (int trial = 0; trial < 4; ++trial) {
    const Som som = random_som(5, 6, 3, random);
    Numbers hits;
    for (std::size_t i = 0; i < 30; ++i) hits.push_back(random.below(4));
    const auto [copies, origins] = repeated(som, hits);
    for (const ClusterMethod method : {ClusterMethod::kWard, ClusterMethod::kKMeans}) {
      ClusterParameters parameters = with(method, 5);
      const Clusters plain = cluster_neurons(copies, parameters).value();
      parameters.by_hits = true;
      const Clusters weighted = cluster_neurons(som, parameters, hits).value();
      for (std::size_t a = 0; a < origins.size(); ++a) {
        for (std::size_t b = 0; b < a; ++b) {
          EXPECT_EQ(plain.of_neuron[a] == plain.of_neuron[b],
                    weighted.of_neuron[origins[a]] == weighted.of_neuron[origins[b]]);
        }
      }
      EXPECT_NEAR(davies_bouldin_index(som, weighted, hits), davies_bouldin_index(copies, plain),
                  1e-12);
      EXPECT_NEAR(silhouette_index(som, weighted, hits), silhouette_index(copies, plain), 1e-12);
    }
  }
}

TEST(Clusters, OfNeuronsWithoutHitsAreThoseOfTheNearestWithHits) {
  const Som som = row_with({0, 4, 10, 11, 7.4F});
  ClusterParameters parameters = with(ClusterMethod::kWard, 2);
  parameters.by_hits = true;
  const Clusters clusters = cluster_neurons(som, parameters, {3, 0, 0, 2, 0}).value();
  EXPECT_EQ(clusters.of_neuron, (Numbers{0, 0, 1, 1, 1}));
  ASSERT_EQ(clusters.merges.size(), 4U);
  EXPECT_EQ(clusters.merges[0], (ClusterMerge{0, 1, 0.0, 2}));
  EXPECT_EQ(clusters.merges[1], (ClusterMerge{2, 3, 0.0, 2}));
  EXPECT_EQ(clusters.merges[2], (ClusterMerge{4, 6, 0.0, 3}));
  EXPECT_EQ(clusters.merges[3].neurons, 5U);
  EXPECT_EQ(cut_merges(clusters.merges, 2), clusters.of_neuron);
}

TEST(Clusters, ThatAreConnectedAreOneRegionEach) {
  Random random(9);
  for (const testing::Variant& variant : testing::all_variants()) {
    SomParameters p = testing::random_parameters(variant, random);
    p.rows = 4;
    p.columns = 5;
    Matrix<float> weights(20, 2);
    for (float& value : weights.values()) value = static_cast<float>(random.normal());
    const Som som(resolve(p, 1, 2).value(), weights);
    ClusterParameters parameters = with(ClusterMethod::kWard, 4);
    parameters.connected = true;
    const Clusters clusters = cluster_neurons(som, parameters).value();
    for (const ClusterSamples& of : samples_of_clusters(som.grid(), clusters, {})) {
      EXPECT_EQ(of.regions, 1U) << testing::name_of(variant);
    }
    parameters.by_hits = true;
    EXPECT_EQ(cluster_neurons(som, parameters, Numbers(20, 1)).value().of_neuron,
              clusters.of_neuron);
  }
}

TEST(Clusters, KMeansNeverHasAGreaterSumOfSquaresThanWard) {
  Random random(10);
  const auto squares = [](const Som& som, const Clusters& clusters) {
    double sum = 0.0;
    for (std::size_t c = 0; c < clusters.count; ++c) {
      for (std::size_t d = 0; d < som.input_size(); ++d) {
        double mean = 0.0;
        double count = 0.0;
        for (std::size_t i = 0; i < som.neurons(); ++i) {
          if (clusters.of_neuron[i] != c) continue;
          mean += double{som.weight(i, d)};
          count += 1.0;
        }
        for (std::size_t i = 0; i < som.neurons(); ++i) {
          if (clusters.of_neuron[i] != c) continue;
          sum += std::pow(double{som.weight(i, d)} - mean / count, 2);
        }
      }
    }
    return sum;
  };
  bool better = false;
  for (std::size_t count = 1; count <= 10; ++count) {
    const Som som = random_som(6, 6, 2, random);
    const Clusters ward = cluster_neurons(som, with(ClusterMethod::kWard, count)).value();
    const Clusters means = cluster_neurons(som, with(ClusterMethod::kKMeans, count)).value();
    EXPECT_EQ(means.count, count);
    EXPECT_LE(squares(som, means), squares(som, ward) + 1e-9);
    better = better || squares(som, means) < squares(som, ward) - 1e-6;
  }
  EXPECT_TRUE(better);
}

TEST(Clusters, OfEqualWeightsAreOneAndOfOneNeuronToo) {
  for (const ClusterMethod method :
       {ClusterMethod::kWard, ClusterMethod::kKMeans, ClusterMethod::kWatershed}) {
    EXPECT_EQ(cluster_labels(row_with({2, 2, 2, 2}), with(method)), Numbers(4, 0));
    EXPECT_EQ(cluster_labels(row_with({2}), with(method)), Numbers{0});
    if (method == ClusterMethod::kWatershed) continue;  // the smallest ridge divides basins
    EXPECT_EQ(cluster_labels(row_with({2, 2, 2.0000005F, 2}), with(method)), Numbers(4, 0));
  }
  EXPECT_EQ(cluster_labels(row_with({1, 2}), with(ClusterMethod::kWard)), (Numbers{0, 1}));
  // Equal neurons may be divided when a number is given.
  EXPECT_EQ(cluster_neurons(row_with({2, 2, 2}), with(ClusterMethod::kKMeans, 3)).value().count,
            3U);
}

TEST(Clusters, RefuseWhatCannotBe) {
  const Som som = row_with({0, 1, 5, 6});
  const auto refused = [&](ClusterParameters parameters, const Numbers& hits = {}) {
    const auto clusters = cluster_neurons(som, parameters, hits);
    return clusters ? std::string() : clusters.error().where;
  };
  EXPECT_EQ(refused(with(ClusterMethod::kWard, 5)), "count");
  EXPECT_FALSE(cluster_neurons(som, with(ClusterMethod::kWard, 0)));
  EXPECT_EQ(refused(with(ClusterMethod::kWatershed, 4)), "count");
  ClusterParameters parameters = with(ClusterMethod::kWard);
  parameters.by_hits = true;
  EXPECT_EQ(refused(parameters), "by_hits");
  EXPECT_EQ(refused(parameters, {0, 0, 0, 0}), "by_hits");
  parameters.count = 3;
  EXPECT_EQ(refused(parameters, {0, 1, 1, 0}), "count");
  EXPECT_THROW((void)cluster_neurons(som, parameters, {1}), InvalidArgument);
  parameters = with(ClusterMethod::kKMeans);
  parameters.connected = true;
  EXPECT_EQ(refused(parameters), "connected");
  parameters = with(ClusterMethod::kWatershed);
  parameters.index = ClusterIndex::kSilhouette;
  EXPECT_EQ(refused(parameters), "index");
  parameters = with(ClusterMethod::kWard, 2);
  parameters.most_clusters = 3;
  EXPECT_EQ(refused(parameters), "most_clusters");
}

TEST(ClusterSamples, AreNamedByMajority) {
  const Grid grid(1, 5, Lattice::kRectangular, Topology::kPlane);
  const Clusters clusters{{0, 1, 0, 1, 2}, 3, {}};
  const auto found = samples_of_clusters(grid, clusters, {0, 0, 2, 1, 3}, {1, 2, 1, 2, 0});
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].neurons, 2U);
  EXPECT_EQ(found[0].regions, 2U);
  EXPECT_EQ(found[0].samples, 3U);
  EXPECT_EQ(found[0].name, 1U);
  EXPECT_DOUBLE_EQ(found[0].purity, 2.0 / 3);
  EXPECT_EQ(found[1].name, 0U);  // a tie: the lowest
  EXPECT_FALSE(found[2].name);
  EXPECT_THROW((void)samples_of_clusters(grid, clusters, {5}), InvalidArgument);
}

TEST(CutMerges, RefusesOtherNumbers) {
  const std::vector<ClusterMerge> merges{{0, 1, 1.0, 2}, {2, 3, 2.0, 3}};
  EXPECT_EQ(cut_merges(merges, 3), (Numbers{0, 1, 2}));
  EXPECT_EQ(cut_merges(merges, 2), (Numbers{0, 0, 1}));
  EXPECT_EQ(cut_merges(merges, 1), (Numbers{0, 0, 0}));
  EXPECT_EQ(cut_merges({}, 1), Numbers{0});
  EXPECT_THROW((void)cut_merges(merges, 4), InvalidArgument);
}

}  // namespace
}  // namespace somato
