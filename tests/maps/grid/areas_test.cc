#include "maps/grid/areas.h"

#include <gtest/gtest.h>

#include "somato/core/check.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

const Grid kRow(1, 7, Lattice::kRectangular, Topology::kPlane);
const Grid kRing(1, 7, Lattice::kRectangular, Topology::kTorus);

TEST(WinnerAreas, BelongToTheNearestWinner) {
  EXPECT_EQ(WinnerAreas(kRow, {0, 5}).classes_of_neurons({3, 4}), (Numbers{3, 3, 3, 4, 4, 4, 4}));
}

TEST(WinnerAreas, GiveTiesToTheClassWithMoreSamplesThenToTheLower) {
  // Neuron 3 is as far from winner 1 as from winner 5.
  EXPECT_EQ(WinnerAreas(kRow, {1, 5, 5}).classes_of_neurons({0, 1, 1})[3], 1U);
  EXPECT_EQ(WinnerAreas(kRow, {1, 5}).classes_of_neurons({1, 0})[3], 0U);
  // A winner shared by two classes goes to the more frequent one.
  EXPECT_EQ(WinnerAreas(kRow, {2, 2, 2}).classes_of_neurons({5, 4, 4})[2], 4U);
}

TEST(WinnerAreas, CountEquallyNearWinnersOfAHexagonalGridDespiteRounding) {
  // Neuron 4 (row 1, column 1) of a 3 x 3 grid has six neighbours at distance 1; two of them, one
  // in its own row and one in the next, are winners.
  const Grid grid(3, 3, Lattice::kHexagonal, Topology::kPlane);
  EXPECT_EQ(WinnerAreas(grid, {3, 8, 8}).classes_of_neurons({0, 1, 1})[4], 1U);
  EXPECT_EQ(WinnerAreas(grid, {3, 3, 8}).classes_of_neurons({1, 1, 0})[4], 1U);
}

// One winner a neuron makes the area of a neuron its own class.
bool connected(const Grid& grid, const Numbers& class_of_neuron) {
  Numbers winners;
  for (std::size_t neuron = 0; neuron < grid.size(); ++neuron) winners.push_back(neuron);
  return WinnerAreas(grid, winners).connected(class_of_neuron);
}

TEST(WinnerAreas, AreConnectedOrNot) {
  EXPECT_TRUE(connected(kRow, {0, 0, 1, 1, 2, 2, 2}));
  EXPECT_FALSE(connected(kRow, {0, 0, 1, 1, 2, 2, 0}));
  EXPECT_TRUE(connected(kRing, {0, 0, 1, 1, 2, 2, 0}));
}

TEST(WinnerAreas, DoNotConnectOverCorners) {
  const Grid square(2, 2, Lattice::kRectangular, Topology::kPlane);
  EXPECT_FALSE(connected(square, {0, 1, 1, 0}));
  const Grid hexagons(2, 2, Lattice::kHexagonal, Topology::kPlane);
  EXPECT_FALSE(connected(hexagons, {0, 1, 1, 0}));  // 1 and 2 touch, 0 and 3 do not
  EXPECT_TRUE(connected(hexagons, {0, 1, 1, 2}));
}

TEST(WinnerAreas, AreNotConnectedWhenAClassHasNoneLeft) {
  EXPECT_TRUE(WinnerAreas(kRow, {0, 3, 6}).connected({0, 1, 2}));
  EXPECT_FALSE(WinnerAreas(kRow, {0, 3, 6}).connected({0, 1, 0}));
  EXPECT_FALSE(WinnerAreas(kRow, {0, 3, 3, 3}).connected({0, 1, 1, 2}));
}

TEST(WinnerAreas, RefuseWhatIsNotOnTheMap) {
  EXPECT_THROW(WinnerAreas(kRow, {7}), InvalidArgument);
  EXPECT_THROW(WinnerAreas(kRow, {}), InvalidArgument);
  EXPECT_THROW((void)WinnerAreas(kRow, {1}).classes_of_neurons({1, 2}), InvalidArgument);
}

TEST(IndividualsApart, WhenNoWinnerIsShared) {
  EXPECT_TRUE(individuals_apart({0, 0, 1, 2}, {5, 5, 6, 7}));
  EXPECT_FALSE(individuals_apart({0, 0, 1, 1}, {5, 5, 6, 7}));
}

}  // namespace
}  // namespace somato
