#include "maps/grid/neighbourhood_mixing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/support/instruction_sets.h"
#include "maps/support/random_maps.h"
#include "somato/core/random.h"

namespace somato {
namespace {

constexpr std::size_t kLanes = NeighbourhoodMixing::kLanes;

std::vector<testing::Variant> variants_of_all_shapes() {
  std::vector<testing::Variant> variants;
  for (testing::Variant variant : testing::all_variants()) {
    if (variant.neighbourhood != NeighbourhoodShape::kBubble) continue;
    for (const auto& [shape, name] : Choices<NeighbourhoodShape>::all()) {
      variant.neighbourhood = shape;
      variants.push_back(variant);
    }
  }
  return variants;
}

void expect_plain_sums(const testing::Variant& variant, std::size_t rows, std::size_t columns,
                       double radius) {
  const Grid grid(rows, columns, variant.lattice, variant.topology);
  Random random(rows * 100 + columns);
  AlignedVector<double> in(grid.size() * kLanes);
  for (double& value : in) value = random.uniform();
  Neighbourhood neighbourhood(grid, variant.neighbourhood);
  std::vector<double> around(grid.size());
  std::vector<AlignedVector<double>> found;
  testing::for_each_instruction_set([&](InstructionSet /*set*/) {
    const NeighbourhoodMixing mixing(grid, variant.neighbourhood, radius);
    NeighbourhoodMixing::Workspace workspace;
    AlignedVector<double> out(in.size(), 7.0);
    mixing.apply(in, out, workspace);
    for (std::size_t k = 0; k < grid.size(); ++k) {
      neighbourhood.around(k, radius, around);
      for (std::size_t lane = 0; lane < kLanes; ++lane) {
        double sum = 0.0;
        for (std::size_t j = 0; j < grid.size(); ++j) sum += around[j] * in[j * kLanes + lane];
        ASSERT_NEAR(out[k * kLanes + lane], sum, 1e-12 * (1.0 + std::fabs(sum)))
            << testing::name_of(variant) << ' ' << rows << " x " << columns << ", neuron " << k;
      }
    }
    found.push_back(out);
  });
  for (const auto& out : found) EXPECT_TRUE(out == found.front());
}

TEST(NeighbourhoodMixing, IsTheSumOverEveryPairOfNeurons) {
  for (const testing::Variant& variant : variants_of_all_shapes()) {
    for (const double radius : {0.0, 0.7, 2.5, 100.0}) {
      expect_plain_sums(variant, 6, 9, radius);
      expect_plain_sums(variant, 2, 1, radius);
      expect_plain_sums(variant, 12, 5, radius);
    }
  }
}

TEST(NeighbourhoodMixing, KnowsOddNumbersOfRows) {
  for (const testing::Variant& variant : variants_of_all_shapes()) {
    if (variant.topology == Topology::kPlane) expect_plain_sums(variant, 7, 4, 1.5);
  }
}

}  // namespace
}  // namespace somato
