#include "maps/pictures/map_panels.h"

#include <gtest/gtest.h>

#include "somato/core/check.h"
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

TEST(CaptionOf, DescribesTheGrid) {
  EXPECT_EQ(caption_of({2, 3, Lattice::kHexagonal, Topology::kTorus}),
            "2 x 3 neurons, hexagonal torus");
}

}  // namespace
}  // namespace somato
