#include "bodies/physics/surface.h"

#include <gtest/gtest.h>

#include <cmath>

namespace somato::detail {
namespace {

Material rough(double roughness, double correlation_length, double hurst) {
  Material material;
  material.name = "rough";
  material.roughness = roughness;
  material.correlation_length = correlation_length;
  material.hurst = hurst;
  return material;
}

// The mean square of the difference in height between places `distance` apart along x, over many
// places too far from each other to know of each other; the mean square itself for 0.
double mean_square(Surface& surface, double distance) {
  double sum = 0.0;
  constexpr int kPlaces = 20000;
  for (int i = 0; i < kPlaces; ++i) {
    const double x = 7.317 * i;
    const double z = surface.height(x, 0.3 * i);
    const double other = distance > 0.0 ? surface.height(x + distance, 0.3 * i) : 0.0;
    sum += (z - other) * (z - other);
  }
  return sum / kPlaces;
}

TEST(Surface, HasTheRoughnessThatItsMaterialDeclares) {
  for (const double roughness : {2.0, 50.0}) {
    for (const double hurst : {0.3, 0.8}) {
      Surface surface(rough(roughness, 0.5, hurst), 0.001, 1);
      // Nine lattices, of 0.5 mm to 0.5 / 256 mm: the rest of the variance is what they leave.
      const double followed = 1.0 - std::pow(2.0, -2.0 * hurst * 9);
      EXPECT_NEAR(mean_square(surface, 0.0) / (roughness * roughness * followed), 1.0, 0.03);
    }
  }
}

TEST(Surface, GrowsApartWithThePowerOfItsHurstExponent) {
  for (const double hurst : {0.3, 0.7}) {
    Surface surface(rough(10.0, 2.0, hurst), 0.0005, 2);
    const double ratio = mean_square(surface, 0.08) / mean_square(surface, 0.02);
    EXPECT_NEAR(0.5 * std::log2(ratio) / 2.0, hurst, 0.06);
  }
}

TEST(Surface, HeightsFarApartAreIndependent) {
  Surface surface(rough(10.0, 0.5, 0.6), 0.01, 3);
  const double apart = mean_square(surface, 2.0);  // four nodes of the coarsest lattice
  EXPECT_NEAR(apart / (2.0 * mean_square(surface, 0.0)), 1.0, 0.03);
}

TEST(Surface, IsContinuousAcrossTheCellsOfItsLattices) {
  Surface surface(rough(10.0, 0.1, 0.5), 0.01, 4);
  double largest = 0.0;
  double before = surface.height(-1.0, 0.0);
  for (int i = 1; i <= 200000; ++i) {  // 2 mm in steps of 0.01 um
    const double z = surface.height(-1.0 + 1e-5 * i, 0.0);
    largest = std::max(largest, std::abs(z - before));
    before = z;
  }
  EXPECT_GT(largest, 0.0);
  EXPECT_LT(largest, 0.03);  // a slope of 3; a jump would be some um
}

TEST(Surface, IsThereBeforeAnybodyVisitsIt) {
  Surface straight(rough(10.0, 0.3, 0.7), 0.01, 5);
  Surface visited(rough(10.0, 0.3, 0.7), 0.01, 5);
  for (int i = 0; i < 50; ++i) (void)visited.height(-3.0 * i, 11.0 * i);
  for (int i = -20; i < 20; ++i) {
    EXPECT_EQ(straight.height(0.37 * i, 0.2 * i), visited.height(0.37 * i, 0.2 * i));
  }
  for (const double y : {5.0, 6.0, 5.0}) {  // along one direction only
    Surface fresh(rough(10.0, 0.3, 0.7), 0.01, 5);
    EXPECT_EQ(straight.height(2.0, y), fresh.height(2.0, y));
  }
  for (const double x : {5.0, 6.0, 5.0}) {
    Surface fresh(rough(10.0, 0.3, 0.7), 0.01, 5);
    EXPECT_EQ(straight.height(x, 2.0), fresh.height(x, 2.0));
  }
}

TEST(Surface, EveryWorldAndEveryMaterialHasItsOwn) {
  Material other = rough(10.0, 0.3, 0.7);
  other.name = "other";
  Surface here(rough(10.0, 0.3, 0.7), 0.01, 5);
  Surface elsewhere(rough(10.0, 0.3, 0.7), 0.01, 6);
  Surface else_what(other, 0.01, 5);
  EXPECT_NE(here.height(1.0, 1.0), elsewhere.height(1.0, 1.0));
  EXPECT_NE(here.height(1.0, 1.0), else_what.height(1.0, 1.0));
}

TEST(Surface, AWeaveRisesAndFallsByItsHeightOnceAPeriod) {
  Material cloth = rough(0.0, 0.3, 0.7);
  cloth.weave_period = 1.5;
  cloth.weave_height = 200.0;
  Surface surface(cloth, 0.01, 7);
  double lowest = 1e9;
  double highest = -1e9;
  for (int i = 0; i < 1500; ++i) {
    const double z = surface.height(0.001 * i, 4.0);
    lowest = std::min(lowest, z);
    highest = std::max(highest, z);
    EXPECT_NEAR(surface.height(0.001 * i + 1.5, -9.0), z, 1e-9);
    EXPECT_NEAR(surface.height(0.001 * i + 0.75, -9.0), -z, 1e-9);
  }
  EXPECT_NEAR(highest - lowest, 200.0, 0.01);
}

TEST(Surface, AnEdgeThatIsWiderThanARidgeDoesNotFollowTheWeave) {
  Material cloth = rough(0.0, 0.3, 0.7);
  cloth.weave_period = 0.1;
  cloth.weave_height = 20.0;
  Surface followed(cloth, 0.05, 7);
  Surface bridged(cloth, 0.051, 7);
  EXPECT_NE(followed.height(0.01, 0.0), 0.0);
  EXPECT_EQ(bridged.height(0.01, 0.0), 0.0);
}

}  // namespace
}  // namespace somato::detail
