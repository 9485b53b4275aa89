#include "maps/pictures/dendrogram_panel.h"

#include <gtest/gtest.h>

#include <limits>

#include "maps/pictures/geometry.h"
#include "maps/pictures/panels.h"
#include "somato/core/check.h"

namespace somato {
namespace {

using test::draw;
using test::group;
using test::texts;

// Neurons 0 and 2 merge at 1, 1 and 3 at 2, all at 10.
DendrogramPanel four() {
  DendrogramPanel panel{.title = "Dendrogram"};
  panel.clusters.of_neuron = {0, 1, 0, 1};
  panel.clusters.count = 2;
  panel.clusters.merges = {{0, 2, 1.0, 2}, {1, 3, 2.0, 2}, {4, 5, 10.0, 4}};
  return panel;
}

TEST(DendrogramPanel, ClustersHaveTheirNumbersBelowTheirLeaves) {
  EXPECT_EQ(texts(group(draw(four()), "clusters")), (std::vector<std::string>{"1", "2"}));
  const test::Element clusters = group(draw(four()), "clusters");
  const auto bars = test::drawn_in(clusters, "rect");
  ASSERT_EQ(bars.size(), 2U);
  EXPECT_NEAR(bars[0].box.right, bars[1].box.left, 0.02);
  EXPECT_EQ(bars[0].element.children.at(0).text, "cluster 1: 2 neurons");
}

TEST(DendrogramPanel, HeightsAreProportional) {
  const auto paths = test::elements(group(draw(four()), "merges"), "path");
  ASSERT_EQ(paths.size(), 2U);  // two merges within clusters, one of them
  double left[3];
  double y[3];
  ASSERT_EQ(
      std::sscanf(paths[0]["d"].c_str(), "M%lf %lfL%lf %lf", &left[0], &y[0], &left[1], &y[1]), 4);
  EXPECT_EQ(left[0], left[1]);
  const double whole = 240.0;
  EXPECT_NEAR(y[0] - y[1], whole / 10, 0.02);
  EXPECT_EQ(texts(group(draw(four()), "heights")), (std::vector<std::string>{"0", "10"}));
}

TEST(DendrogramPanel, TheCutIsBetweenTheHeightsOfBothKindsOfMerges) {
  const auto cut = test::elements(group(draw(four()), "cut"), "path");
  ASSERT_EQ(cut.size(), 1U);
  double x = 0;
  double y = 0;
  ASSERT_EQ(std::sscanf(cut[0]["d"].c_str(), "M%lf %lf", &x, &y), 2);
  EXPECT_NEAR(y, 6 + 240 * (1 - 6.0 / 10), 0.02);
  EXPECT_FALSE(cut[0]["stroke-dasharray"].empty());
  DendrogramPanel one = four();
  one.clusters.of_neuron = {0, 0, 0, 0};
  EXPECT_TRUE(test::groups(draw(one), "cut").empty());
  // Merges that are restricted to adjacent clusters may have heights in another order.
  DendrogramPanel inverted = four();
  inverted.clusters.merges[2].height = 1.5;
  EXPECT_TRUE(test::groups(draw(inverted), "cut").empty());
}

TEST(DendrogramPanel, OneNeuronEqualNeuronsAndDeepTreesAreDrawn) {
  DendrogramPanel panel{.title = "d", .clusters = {{0}, 1, {}}};
  EXPECT_EQ(texts(group(draw(panel), "clusters")), (std::vector<std::string>{"1"}));
  panel = four();
  for (ClusterMerge& merge : panel.clusters.merges) merge.height = 0.0;
  EXPECT_NO_THROW(draw(panel));
  constexpr std::size_t kNeurons = 5000;
  Clusters chain{std::vector<std::size_t>(kNeurons, 0), 1, {}};
  for (std::size_t i = 0; i + 1 < kNeurons; ++i) {
    chain.merges.push_back({i + 1, i == 0 ? 0 : kNeurons + i - 1, static_cast<double>(i), i + 2});
  }
  EXPECT_NO_THROW(draw(DendrogramPanel{.title = "d", .clusters = chain}));
}

TEST(DendrogramPanel, WhatIsNoTreeIsRefused) {
  const auto refused = [](const std::function<void(Clusters&)>& change) {
    DendrogramPanel panel = four();
    change(panel.clusters);
    EXPECT_THROW(draw(panel), InvalidArgument);
  };
  refused([](Clusters& c) { c.merges.pop_back(); });
  refused([](Clusters& c) { c.merges.clear(); });
  refused([](Clusters& c) { c.merges[1].first = 0; });
  refused([](Clusters& c) { c.merges[1].first = 3; });
  refused([](Clusters& c) { c.merges[0].second = 5; });
  refused([](Clusters& c) { c.merges[0].height = -1; });
  refused([](Clusters& c) { c.merges[0].height = std::numeric_limits<double>::infinity(); });
  refused([](Clusters& c) { c.of_neuron.clear(); });
}

}  // namespace
}  // namespace somato
