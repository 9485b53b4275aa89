#include "maps/grid/principal_plane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/support/instruction_sets.h"
#include "maps/support/random_maps.h"
#include "somato/core/random.h"

namespace somato {
namespace {

struct Ranges {
  std::vector<float> low;
  std::vector<float> high;
};

Ranges ranges_of(const Samples& samples) {
  Ranges ranges;
  std::vector<float> row(samples.size());
  for (std::size_t i = 0; i < samples.count(); ++i) {
    write_dense(samples[i], row);
    if (i == 0) ranges = {row, row};
    for (std::size_t d = 0; d < row.size(); ++d) {
      ranges.low[d] = std::min(ranges.low[d], row[d]);
      ranges.high[d] = std::max(ranges.high[d], row[d]);
    }
  }
  return ranges;
}

PrincipalPlane plane_of_samples(const Samples& samples, std::size_t threads = 1) {
  const Ranges ranges = ranges_of(samples);
  return principal_plane(samples, ranges.low, ranges.high, threads);
}

CovarianceSums sums_of(const Samples& samples) {
  const Ranges ranges = ranges_of(samples);
  return CovarianceSums(samples.count(), ranges.low, ranges.high, 1);
}

void expect_same_plane(const PrincipalPlane& plane, const PrincipalPlane& expected) {
  EXPECT_EQ(plane.mean, expected.mean);
  EXPECT_EQ(plane.first, expected.first);
  EXPECT_EQ(plane.second, expected.second);
}

// Random samples in which features have different variances; the first component is clear.
Samples spread_samples(std::size_t count, std::size_t size, Random& random) {
  Matrix<float> rows(count, size);
  for (std::size_t i = 0; i < count; ++i) {
    const double first = 9.0 * random.normal();
    const double second = 4.0 * random.normal();
    for (std::size_t d = 0; d < size; ++d) {
      const auto place = static_cast<double>(d + 1) / static_cast<double>(size);
      rows(i, d) = static_cast<float>(100.0 + first * place + second * (1.0 - place * place) +
                                      0.3 * random.normal());
    }
  }
  return Samples(std::move(rows));
}

// The variances along the axes are 2 9 / 4 and 2 1 / 4.
TEST(PrincipalPlane, HasTheAxesOfARhombus) {
  const Samples samples(Matrix<float>(4, 2, {8, 5, 2, 5, 5, 6, 5, 4}));
  const PrincipalPlane plane = plane_of_samples(samples);
  EXPECT_EQ(plane.mean, (std::vector<double>{5, 5}));
  EXPECT_NEAR(plane.first[0], std::sqrt(4.5), 1e-6);
  EXPECT_NEAR(plane.first[1], 0.0, 1e-6);
  EXPECT_NEAR(plane.second[0], 0.0, 1e-6);
  EXPECT_NEAR(plane.second[1], std::sqrt(0.5), 1e-6);
}

// The same rhombus in five features, so that there are fewer samples: (3, 0), (0, 1) become
// (1, 2, 2, 0, 0) and (0, 0, 0, 0, -1).
TEST(PrincipalPlane, HasThemWithFewerSamplesThanFeatures) {
  const Samples samples(
      Matrix<float>(4, 5, {1, 2, 2, 0, 7, -1, -2, -2, 0, 7, 0, 0, 0, 0, 6, 0, 0, 0, 0, 8}));
  const PrincipalPlane plane = plane_of_samples(samples);
  const std::vector<double> first{1, 2, 2, 0, 0};
  for (std::size_t d = 0; d < 5; ++d) {
    EXPECT_NEAR(plane.mean[d], d == 4 ? 7.0 : 0.0, 1e-12);
    EXPECT_NEAR(plane.first[d], first[d] * std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(plane.second[d], d == 4 ? std::sqrt(0.5) : 0.0, 1e-12);
  }
}

TEST(PrincipalPlane, IsTheSameBySamplesAndByFeatures) {
  Random random(3);
  for (int round = 0; round < 20; ++round) {
    const std::size_t count = 3 + random.below(90);
    const Samples samples = spread_samples(count, count + random.below(40), random);
    const PrincipalPlane plane = plane_of_samples(samples);
    CovarianceSums sums = sums_of(samples);
    sums.add(samples);
    const PrincipalPlane by_features = sums.plane();
    for (std::size_t d = 0; d < samples.size(); ++d) {
      EXPECT_NEAR(plane.mean[d], by_features.mean[d], 1e-5);
      EXPECT_NEAR(plane.first[d], by_features.first[d], 1e-4);
      EXPECT_NEAR(plane.second[d], by_features.second[d], 1e-4);
    }
  }
}

TEST(PrincipalPlaneThread, HasTheSameBitsForAllPartsThreadsAndInstructionSets) {
  Random random(4);
  for (const auto& [count, size] : {std::pair{700U, 20U}, {40U, 90U}, {130U, 1U}}) {
    const Samples samples = spread_samples(count, size, random);
    const PrincipalPlane expected = plane_of_samples(samples);
    testing::for_each_instruction_set([&](InstructionSet /*set*/) {
      for (const std::size_t threads : {2U, 3U}) {
        expect_same_plane(plane_of_samples(samples, threads), expected);
      }
    });
    if (count <= size) continue;
    for (const std::size_t most : {1U, 63U, 65U, 699U}) {
      CovarianceSums sums = sums_of(samples);
      SamplesInMemory source(samples, most);
      ASSERT_TRUE(for_each_part(source, [&](const Samples& part) -> Result<void> {
        sums.add(part);
        return {};
      }));
      expect_same_plane(sums.plane(), expected);
    }
  }
}

TEST(PrincipalPlane, OfSparseSamplesIsThatOfDenseOnes) {
  Random random(5);
  for (const std::size_t count : {4U, 30U, 200U}) {
    const Samples sparse = testing::random_samples(count, 25, true, random);
    Matrix<float> rows(count, 25);
    for (std::size_t i = 0; i < count; ++i) write_dense(sparse[i], rows.row(i));
    expect_same_plane(plane_of_samples(sparse), plane_of_samples(Samples(std::move(rows))));
  }
}

TEST(PrincipalPlane, PointsTowardsItsGreatestElement) {
  Random random(6);
  for (int round = 0; round < 30; ++round) {
    const PrincipalPlane plane =
        plane_of_samples(spread_samples(2 + random.below(30), 1 + random.below(9), random));
    for (const auto* component : {&plane.first, &plane.second}) {
      const auto [least, greatest] = std::minmax_element(component->begin(), component->end());
      EXPECT_LE(-*least, *greatest);
    }
  }
  // Equal magnitudes: the first is positive.
  const PrincipalPlane tie = plane_of_samples(Samples(Matrix<float>(3, 2, {1, -1, 0, 0, -1, 1})));
  EXPECT_GT(tie.first[0], 0.0);
  EXPECT_LT(tie.first[1], 0.0);
}

TEST(PrincipalPlane, WithoutVarianceIsAPointOrALine) {
  const std::vector<double> zeros(3);
  for (const std::size_t count : {1U, 2U, 9U}) {
    const Samples constant(Matrix<float>(count, 3, 0.1F));
    const PrincipalPlane plane = plane_of_samples(constant);
    EXPECT_EQ(plane.mean, std::vector<double>(3, double{0.1F}));
    EXPECT_EQ(plane.first, zeros);
    EXPECT_EQ(plane.second, zeros);
  }
  Matrix<float> line(10, 3);
  for (std::size_t i = 0; i < 10; ++i) {
    for (std::size_t d = 0; d < 3; ++d) line(i, d) = 0.37F * static_cast<float>(i * (d + 1));
  }
  EXPECT_EQ(plane_of_samples(Samples(line)).second, zeros);
}

// An offset of a million leaves 1/16 between the values.
TEST(PrincipalPlane, IsNotLostInAnOffset) {
  const Samples samples(Matrix<float>(4, 2, {1000008, 5, 1000002, 5, 1000005, 6, 1000005, 4}));
  const PrincipalPlane plane = plane_of_samples(samples);
  EXPECT_EQ(plane.mean[0], 1000005.0);
  EXPECT_NEAR(plane.first[0], std::sqrt(4.5), 1e-6);
  EXPECT_NEAR(plane.second[1], std::sqrt(0.5), 1e-6);
}

TEST(PrincipalPlane, TakesVerySmallAndVeryLargeNumbers) {
  for (const float scale : {1e-15F, 1e17F}) {
    const Samples samples(Matrix<float>(4, 2, {3 * scale, 0, -3 * scale, 0, 0, scale, 0, -scale}));
    const PrincipalPlane plane = plane_of_samples(samples);
    EXPECT_NEAR(plane.first[0] / double{scale}, std::sqrt(4.5), 1e-6);
    EXPECT_NEAR(plane.second[1] / double{scale}, std::sqrt(0.5), 1e-6);
  }
}

TEST(PrincipalPlane, IsRefusedWhereBothSidesAreLarge) {
  const std::vector<float> low(5000, 0.0F);
  std::vector<float> high(5000, 1.0F);
  EXPECT_FALSE(check_plane(5000, low, high));
  EXPECT_TRUE(check_plane(4096, low, high));
  std::fill_n(high.begin(), 1000, 0.0F);  // constant features do not count
  EXPECT_TRUE(check_plane(5000, low, high));
}

TEST(PrincipalPlane, ComponentsAreCombinationsOfSamples) {
  Random random(7);
  for (const auto& [count, size] : {std::pair{12U, 30U}, {50U, 6U}}) {
    const Samples samples = spread_samples(count, size, random);
    const PrincipalPlane plane = plane_of_samples(samples);
    for (const auto* component : {&plane.first, &plane.second}) {
      const std::vector<double> factors = factors_of_component(plane, *component, samples);
      for (std::size_t d = 0; d < size; ++d) {
        double sum = 0.0;
        for (std::size_t i = 0; i < count; ++i) sum += factors[i] * double{samples[i].values[d]};
        EXPECT_NEAR(sum, (*component)[d], 1e-3);
      }
    }
  }
}

TEST(PlanePlaces, RunFromMinusOneToOneAlongTheLongerSideFirst) {
  const auto expect_place = [](const Grid& grid, std::size_t neuron, double first, double second) {
    const PlanePlace place = place_on_plane(grid, neuron);
    EXPECT_DOUBLE_EQ(place.first, first);
    EXPECT_DOUBLE_EQ(place.second, second);
  };
  const Grid wide(3, 5, Lattice::kRectangular, Topology::kTorus);
  expect_place(wide, 0, -1, -1);
  expect_place(wide, 4, 1, -1);
  expect_place(wide, 6, -0.5, 0);
  const Grid high(5, 3, Lattice::kRectangular, Topology::kPlane);
  expect_place(high, 2, -1, 1);
  expect_place(high, 12, 1, -1);
  const Grid square(2, 2, Lattice::kRectangular, Topology::kPlane);
  expect_place(square, 1, 1, -1);
  expect_place(Grid(1, 4, Lattice::kRectangular, Topology::kPlane), 3, 1, 0);
  expect_place(Grid(4, 1, Lattice::kHexagonal, Topology::kPlane), 3, 1, 0);
  expect_place(Grid(1, 1, Lattice::kHexagonal, Topology::kPlane), 0, 0, 0);
  // Odd rows are half a neuron further to the right.
  const Grid hexagonal(3, 4, Lattice::kHexagonal, Topology::kPlane);
  expect_place(hexagonal, 0, -1, -1);
  expect_place(hexagonal, 7, 1, 0);
  expect_place(hexagonal, 3, 6.0 / 3.5 - 1.0, -1);
}

}  // namespace
}  // namespace somato
