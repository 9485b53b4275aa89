#include "somato/maps/som_quality.h"

#include <gtest/gtest.h>

#include <memory>

#include "maps/support/random_maps.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

// Four neurons in a row with weights 0, 10, 20, 1: neurons 0 and 3 are far apart on the map but
// near each other in what they stand for.
Som row_of_four() {
  SomParameters p;
  p.rows = 1;
  p.columns = 4;
  return Som(resolve(p, 1, 1).value(), Matrix<float>(4, 1, {0, 10, 20, 1}));
}

TEST(SomQuality, IsAsByHand) {
  // 0.25: winner 0 at 0.25, second 3, not adjacent. 14: winner 1 at 4, second 2. 18: winner 2 at 2,
  // second 1. 7: winner 1 at 3, second 3 at 6 (0 is at 7), not adjacent.
  const SomQuality quality =
      measure_quality(row_of_four(), Samples(Matrix<float>(4, 1, {0.25F, 14, 18, 7})));
  EXPECT_DOUBLE_EQ(quality.quantization_error, (0.25 + 4 + 2 + 3) / 4);
  EXPECT_DOUBLE_EQ(quality.topographic_error, 0.5);
  EXPECT_EQ(quality.hits, (std::vector<std::size_t>{1, 2, 1, 0}));
  EXPECT_EQ(quality.winners, (std::vector<std::size_t>{0, 1, 2, 1}));
}

TEST(SomQuality, ATorusJoinsTheEnds) {
  SomParameters p;
  p.rows = 1;
  p.columns = 4;
  p.topology = Topology::kTorus;
  const Som som(resolve(p, 1, 1).value(), Matrix<float>(4, 1, {0, 10, 20, 1}));
  EXPECT_EQ(measure_quality(som, Samples(Matrix<float>(1, 1, 0.25F))).topographic_error, 0.0);
}

TEST(SomQuality, IsTheSameForEveryNumberOfThreads) {
  Random random(61);
  const Samples samples = testing::random_samples(101, 1, false, random);
  const SomQuality one = measure_quality(row_of_four(), samples, 1);
  const SomQuality three = measure_quality(row_of_four(), samples, 3);
  EXPECT_EQ(one.quantization_error, three.quantization_error);
  EXPECT_EQ(one.winners, three.winners);
}

TEST(SomQuality, OfNothingIsZero) {
  const SomQuality quality = measure_quality(row_of_four(), Samples(Matrix<float>(0, 1)));
  EXPECT_EQ(quality.quantization_error, 0.0);
  EXPECT_EQ(quality.topographic_error, 0.0);
}

TEST(UMatrix, IsTheMeanDistanceToTheNeighbours) {
  EXPECT_EQ(u_matrix(row_of_four()), (std::vector<double>{10, 10, 14.5, 19}));
}

// Neuron 2 with neighbours 0 and 3; neuron 1 has none.
TEST(UMatrix, OfAGraphFollowsItsEdges) {
  SomParameters p;
  p.rows = 1;
  p.columns = 4;
  const auto graph =
      std::make_shared<const NeuronGraph>(4, std::vector<NeuronGraph::Edge>{{2, 3}, {0, 2}});
  const Som som(resolve(p, 1, 1).value(), Matrix<float>(4, 1, {0, 10, 20, 1}), graph);
  EXPECT_EQ(u_matrix(som), (std::vector<double>{20, 0, 19.5, 19}));
  EXPECT_EQ(edge_distances(som), (std::vector<double>{20, 19}));  // edges are ascending
  EXPECT_TRUE(edge_distances(row_of_four()).empty());
}

TEST(ComponentPlane, HoldsTheWeightsOfOneElement) {
  EXPECT_EQ(component_plane(row_of_four(), 0), (std::vector<double>{0, 10, 20, 1}));
  EXPECT_THROW((void)component_plane(row_of_four(), 1), InvalidArgument);
}

}  // namespace
}  // namespace somato
