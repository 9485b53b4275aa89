#include "maps/t_mpsom/t_mpsom_arbor.h"

#include <gtest/gtest.h>

#include "maps/support/t_mpsom_problems.h"
#include "maps/t_mpsom/t_mpsom_reference.h"

namespace somato {
namespace {

// The group's mask, or zero beyond it.
float masked(const TMpsomArbor& arbor, std::size_t neuron, std::size_t element) {
  const auto& field = arbor.field(neuron / TMpsomArbor::kNeurons);
  if (element < field.first || element >= field.end) return 0.0F;
  return field.mask(neuron % TMpsomArbor::kNeurons, element - field.first);
}

void expect_reference(const TMpsomParameters& p) {
  const TMpsomReference reference(p);
  for (std::size_t a = 0; a < p.input_sizes.size(); ++a) {
    const TMpsomArbor arbor(p, a);
    const Matrix<float> all = arbor.to_matrix();
    ASSERT_EQ(all.rows(), p.neurons());
    ASSERT_EQ(all.columns(), p.input_sizes[a]);
    for (std::size_t n = 0; n < all.rows(); ++n) {
      for (std::size_t k = 0; k < all.columns(); ++k) {
        const double expected = reference.arbor(a, n, k);
        EXPECT_NEAR(double{all(n, k)}, expected < 1e-18 ? 0.0 : expected, 1e-7 * expected);
        EXPECT_EQ(masked(arbor, n, k), all(n, k));
      }
    }
  }
}

TEST(TMpsomArbor, IsTheReferencesWhateverItsWidth) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    TMpsomParameters p = testing::random_parameters(random);
    for (const double sigma : {0.05, 0.4, 1.0, 30.0}) {
      p.arbor_sigma = sigma;
      expect_reference(p);
    }
  }
}

TEST(TMpsomArbor, IsTheReferencesOnLargeGrids) {
  TMpsomParameters p;
  p.shape = {46, 23};
  p.input_sizes = {90, 45};
  expect_reference(p);
  p.shape = {7, 90};
  p.input_sizes = {20, 600};
  p.arbor_sigma = 2.0;
  expect_reference(p);
  p.shape = {300};
  p.input_sizes = {3};
  expect_reference(p);
}

TEST(TMpsomArbor, KeepsWhatIsSeenOncePerPlace) {
  TMpsomParameters p;
  p.shape = {64, 64};
  p.input_sizes = {128, 128};
  const TMpsomArbor first(p, 0);
  EXPECT_EQ(first.groups(), 64U);
  EXPECT_EQ(first.masks(), 64U);
  for (std::size_t group = 0; group < 64; ++group) {
    EXPECT_LE(first.field(group).mask.columns(), 38U);  // 9.1 neurons of two elements, either side
  }
  EXPECT_EQ(TMpsomArbor(p, 1).masks(), 1U);
}

}  // namespace
}  // namespace somato
