#include "somato/maps/areas.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

const Grid kRow(1, 7, Lattice::kRectangular, Topology::kPlane);
const Grid kRing(1, 7, Lattice::kRectangular, Topology::kTorus);

TEST(Areas, BelongToTheNearestWinner) {
  EXPECT_EQ(areas(kRow, {0, 5}, {3, 4}), (Numbers{3, 3, 3, 4, 4, 4, 4}));
}

TEST(Areas, GiveTiesToTheClassWithMoreSamplesThenToTheLower) {
  // Neuron 3 is as far from winner 1 as from winner 5.
  EXPECT_EQ(areas(kRow, {1, 5, 5}, {0, 1, 1})[3], 1U);
  EXPECT_EQ(areas(kRow, {1, 5}, {1, 0})[3], 0U);
  // A winner shared by two classes goes to the more frequent one.
  EXPECT_EQ(areas(kRow, {2, 2, 2}, {5, 4, 4})[2], 4U);
}

TEST(Areas, AreConnectedOrNot) {
  EXPECT_TRUE(areas_connected(kRow, {0, 0, 1, 1, 2, 2, 2}));
  EXPECT_FALSE(areas_connected(kRow, {0, 0, 1, 1, 2, 2, 0}));
  EXPECT_TRUE(areas_connected(kRing, {0, 0, 1, 1, 2, 2, 0}));
}

TEST(Areas, OnASquareDiagonalsDoNotConnect) {
  const Grid square(2, 2, Lattice::kRectangular, Topology::kPlane);
  EXPECT_FALSE(areas_connected(square, {0, 1, 1, 0}));
  const Grid hexagons(2, 2, Lattice::kHexagonal, Topology::kPlane);
  EXPECT_FALSE(areas_connected(hexagons, {0, 1, 1, 0}));  // 1 and 2 touch, 0 and 3 do not
  EXPECT_TRUE(areas_connected(hexagons, {0, 1, 1, 1}));
}

TEST(ClassesConnected, AreNotWhenAClassHasNoAreaLeft) {
  EXPECT_TRUE(classes_connected(kRow, {0, 3, 6}, {0, 1, 2}));
  EXPECT_FALSE(classes_connected(kRow, {0, 3, 6}, {0, 1, 0}));
  EXPECT_FALSE(classes_connected(kRow, {0, 3, 3, 3}, {0, 1, 1, 2}));
}

TEST(IndividualsApart, WhenNoWinnerIsShared) {
  EXPECT_TRUE(individuals_apart({0, 0, 1, 2}, {5, 5, 6, 7}));
  EXPECT_FALSE(individuals_apart({0, 0, 1, 1}, {5, 5, 6, 7}));
}

}  // namespace
}  // namespace somato
