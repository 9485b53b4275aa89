#include "maps/pictures/map_panels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "somato/core/check.h"
#include "somato/core/random.h"
#include "somato/maps/som.h"

namespace somato {
namespace {

// Four neurons in a row, with two weights each.
Som four_neurons() {
  SomParameters p;
  p.rows = 1;
  p.columns = 4;
  return Som(resolve(p, 2, 1).value(), Matrix<float>(4, 2, {0, 5, 3, 5, 9, 5, 10, 5}));
}

TEST(UMatrixPanel, HasTheMeanDistancesOfNeighbours) {
  const ValuePanel panel = u_matrix_panel(four_neurons());
  EXPECT_EQ(panel.title, "U-matrix");
  EXPECT_EQ(panel.values, (std::vector<double>{3, 4.5, 3.5, 1}));
  EXPECT_EQ(panel.grid.columns(), 4U);
}

TEST(ComponentPanels, AreThoseOfTheFirstElements) {
  const auto panels = component_panels(four_neurons(), {}, 1);
  ASSERT_EQ(panels.size(), 1U);
  EXPECT_EQ(std::get<ValuePanel>(panels[0]).title, "Component 1");
  EXPECT_EQ(std::get<ValuePanel>(panels[0]).values, (std::vector<double>{0, 3, 9, 10}));
}

TEST(ComponentPanels, AreNamedAndAreNoMoreThanTheElements) {
  const auto panels = component_panels(four_neurons(), {"force", "speed"}, 12);
  ASSERT_EQ(panels.size(), 2U);
  EXPECT_EQ(std::get<ValuePanel>(panels[1]).title, "speed");
  EXPECT_THROW(component_panels(four_neurons(), {"force"}, 12), InvalidArgument);
}

TEST(UMatrixEdgesPanel, HasTheDistanceOfEachTwoNeighbours) {
  const EdgePanel panel = u_matrix_edges_panel(four_neurons());
  ASSERT_EQ(panel.edges.size(), 3U);
  const double expected[] = {3, 6, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(panel.edges[i].first, i);
    EXPECT_EQ(panel.edges[i].second, i + 1);
    EXPECT_EQ(panel.edges[i].value, expected[i]);
  }
  EXPECT_EQ(panel.values, (std::vector<double>{3, 4.5, 3.5, 1}));
}

// The weights of 2 x 2 neurons: sides of 3 and 4, diagonals of 5.
TEST(UMatrixEdgesPanel, DiagonalsAreDividedByTheirLength) {
  SomParameters p;
  p.rows = 2;
  p.columns = 2;
  const Som som(resolve(p, 2, 1).value(), Matrix<float>(4, 2, {0, 0, 3, 0, 0, 4, 3, 4}));
  const EdgePanel panel = u_matrix_edges_panel(som);
  std::map<std::pair<std::size_t, std::size_t>, double> edges;
  for (const auto& [a, b, value] : panel.edges) edges[{a, b}] = value;
  ASSERT_EQ(edges.size(), 6U);
  EXPECT_EQ((edges[{0, 1}]), 3.0);
  EXPECT_EQ((edges[{0, 2}]), 4.0);
  EXPECT_NEAR((edges[{0, 3}]), 5.0 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR((edges[{1, 2}]), 5.0 / std::sqrt(2.0), 1e-12);
}

TEST(UMatrixEdgesPanel, EveryNeighbourOfAMapHasOneEdge) {
  Random random(2);
  for (const Topology topology : {Topology::kPlane, Topology::kTorus}) {
    SomParameters p;
    p.rows = 4;
    p.columns = 5;
    p.lattice = Lattice::kHexagonal;
    p.topology = topology;
    std::vector<float> weights;
    for (int i = 0; i < 40; ++i) weights.push_back(static_cast<float>(random.uniform()));
    const Som som(resolve(p, 2, 1).value(), Matrix<float>(20, 2, weights));
    const EdgePanel panel = u_matrix_edges_panel(som);
    std::size_t pairs = 0;
    for (std::size_t a = 0; a < 20; ++a) {
      for (std::size_t b = a + 1; b < 20; ++b) pairs += som.grid().adjacent(a, b) ? 1 : 0;
    }
    EXPECT_EQ(panel.edges.size(), pairs);
    for (const auto& [a, b, value] : panel.edges) {
      EXPECT_NEAR(
          value,
          std::hypot(weights[2 * a] - weights[2 * b], weights[2 * a + 1] - weights[2 * b + 1]),
          1e-6);
    }
  }
}

// Planes 0 and 3 are alike, 1 is the opposite of 0, and 2 is constant.
Som four_planes() {
  SomParameters p;
  p.rows = 1;
  p.columns = 4;
  return Som(resolve(p, 4, 1).value(), Matrix<float>(4, 4,
                                                     {0, 9, 5, 0,  //
                                                      1, 8, 5, 2,  //
                                                      2, 6, 5, 5,  //
                                                      9, 0, 5, 16}));
}

TEST(ComponentPanels, SortedByLikenessAreThoseOfTheFirstElements) {
  const auto all = component_panels(four_planes(), {}, 9, PlaneSorting::kLikeness);
  std::vector<std::string> titles;
  for (const Panel& panel : all) titles.push_back(std::get<ValuePanel>(panel).title);
  std::vector<std::size_t> places;
  for (const char* title : {"Component 1", "Component 4"}) {
    places.push_back(
        static_cast<std::size_t>(std::find(titles.begin(), titles.end(), title) - titles.begin()));
  }
  EXPECT_EQ(std::max(places[0], places[1]) - std::min(places[0], places[1]), 1U);
  const auto two =
      component_panels(four_planes(), {"a", "b", "c", "d"}, 2, PlaneSorting::kLikeness);
  ASSERT_EQ(two.size(), 2U);
  EXPECT_LE(std::get<ValuePanel>(two[0]).title, "b");
  EXPECT_LE(std::get<ValuePanel>(two[1]).title, "b");
}

TEST(ComponentPanels, OfACommonScaleHaveTheLimitsOfThoseThatAreDrawn) {
  const auto panels =
      component_panels(four_planes(), {}, 3, PlaneSorting::kColumns, PlaneScale::kCommon);
  for (const Panel& panel : panels) {
    const auto& limits = std::get<ValuePanel>(panel).limits;
    ASSERT_TRUE(limits);
    EXPECT_EQ(limits->least, 0.0);
    EXPECT_EQ(limits->greatest, 9.0);
  }
  EXPECT_FALSE(std::get<ValuePanel>(component_panels(four_planes(), {}, 1)[0]).limits);
  EXPECT_TRUE(
      component_panels(four_planes(), {}, 0, PlaneSorting::kColumns, PlaneScale::kCommon).empty());
}

TEST(ClustersByName, HaveTheMethodAndTheNumber) {
  const Clusters two = clusters_by_name(four_neurons(), "ward:2", "x").value();
  EXPECT_EQ(two.of_neuron, (std::vector<std::size_t>{0, 0, 1, 1}));
  EXPECT_EQ(clusters_by_name(four_neurons(), "k_means:3", "x").value().count, 3U);
  for (const char* wrong : {"", "wart", "ward:", "ward:0", "ward:-1", "ward:2x", "ward:9", ":2"}) {
    const auto refused = clusters_by_name(four_neurons(), wrong, "the flag");
    ASSERT_FALSE(refused) << wrong;
    EXPECT_EQ(refused.error().where, "the flag") << wrong;
  }
}

// draw_picture() refuses merges that are not those of a tree.
TEST(ClustersByName, MergesOfAnySizeAreDrawn) {
  for (const std::size_t neurons : {1U, 2U, 3U, 20U, 65U}) {
    SomParameters p;
    p.rows = 1;
    p.columns = neurons;
    Random random(neurons);
    std::vector<float> weights;
    for (std::size_t i = 0; i < 3 * neurons; ++i) {
      weights.push_back(static_cast<float>(random.normal()));
    }
    const Som som(resolve(p, 3, 1).value(), Matrix<float>(neurons, 3, weights));
    DendrogramPanel panel{"d", clusters_by_name(som, "ward:1", "x").value()};
    EXPECT_NO_THROW(draw_picture("", "", {panel})) << neurons;
  }
}

TEST(ProjectionPanelOfAMap, ManySamplesAreThinnedEvenlyAndCounted) {
  const Som som = four_neurons();
  Classes classes{{"a", "b"}, {}};
  std::vector<Position> samples;
  for (std::size_t i = 0; i < 2 * kMostProjectedSamples + 1; ++i) {
    samples.push_back({static_cast<double>(i), 0});
    classes.of_sample.push_back(i % 2);
  }
  const WeightPlane plane(som);
  const ProjectionPanel panel = projection_panel(som, plane, samples, classes);
  EXPECT_LE(panel.samples.size(), kMostProjectedSamples);
  EXPECT_EQ(panel.samples.at(1).x, 3.0);
  EXPECT_EQ(panel.classes.at(1), 1U);
  EXPECT_NE(panel.note.find("2667 of 8001 samples are drawn."), std::string::npos) << panel.note;
  EXPECT_TRUE(projection_panel(som, plane, {}, {}).samples.empty());
  EXPECT_THROW(projection_panel(som, plane, {{0, 0}}, classes), InvalidArgument);
}

TEST(LabelTextPanel, HasTheNamesOfTheNeurons) {
  const LabelPanel panel = label_text_panel(Grid(1, 3, Lattice::kRectangular, Topology::kPlane),
                                            NeuronLabels({1, std::nullopt, 0}), {"a", "b"});
  EXPECT_EQ(panel.winners, (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(panel.classes, (std::vector<std::size_t>{1, 0}));
}

TEST(Outline, SetsTheClustersOfEveryPanelOfCells) {
  Panel panel = u_matrix_panel(four_neurons());
  outline(panel, {0, 0, 1, 1});
  EXPECT_EQ(std::get<ValuePanel>(panel).clusters, (std::vector<std::size_t>{0, 0, 1, 1}));
  Panel tree = DendrogramPanel{"d", {{0}, 1, {}}};
  outline(tree, {0, 0, 1, 1});
  EXPECT_EQ(std::get<DendrogramPanel>(tree).clusters.of_neuron, (std::vector<std::size_t>{0}));
}

TEST(CaptionOf, DescribesTheGrid) {
  EXPECT_EQ(caption_of({2, 3, Lattice::kHexagonal, Topology::kTorus}),
            "2 x 3 neurons, hexagonal torus");
}

}  // namespace
}  // namespace somato
