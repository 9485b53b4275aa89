#include "maps/grid/leading_eigenvectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "somato/core/random.h"

namespace somato {
namespace {

// H diag(values) H for a random reflection H = 1 - 2 v v', whose columns are the eigenvectors.
struct Reflected {
  Matrix<double> matrix;
  Matrix<double> vectors;
};

Reflected reflected(const std::vector<double>& values, Random& random) {
  const std::size_t size = values.size();
  std::vector<double> normal(size);
  double square = 0.0;
  for (double& one : normal) {
    one = random.normal();
    square += one * one;
  }
  Reflected made{Matrix<double>(size, size), Matrix<double>(size, size)};
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      made.vectors(i, j) = (i == j ? 1.0 : 0.0) - 2.0 * normal[i] * normal[j] / square;
    }
  }
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      for (std::size_t k = 0; k < size; ++k) {
        made.matrix(i, j) += made.vectors(k, i) * values[k] * made.vectors(k, j);
      }
    }
  }
  return made;
}

double cosine(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

TEST(LeadingEigenvectors, OfSmallAndLargeMatricesAreThoseTheyWereMadeOf) {
  Random random(1);
  for (const std::size_t size : {2U, 3U, 5U, 20U, 64U, 65U, 90U, 200U}) {
    std::vector<double> values(size);
    for (double& value : values) value = random.uniform();
    values[1] = 3.0;
    values[0] = 2.5;
    const Reflected made = reflected(values, random);
    const Eigenvectors found = leading_eigenvectors(made.matrix, 2);
    ASSERT_EQ(found.values.size(), 2U);
    EXPECT_NEAR(found.values[0], 3.0, 1e-9) << size;
    EXPECT_NEAR(found.values[1], 2.5, 1e-9) << size;
    EXPECT_NEAR(std::fabs(cosine(found.vectors.row(0), made.vectors.row(1))), 1.0, 1e-9) << size;
    EXPECT_NEAR(std::fabs(cosine(found.vectors.row(1), made.vectors.row(0))), 1.0, 1e-9) << size;
  }
}

// Values that are close to each other, and a value that occurs several times.
TEST(LeadingEigenvectors, OfEqualValuesSpanTheirSpace) {
  Random random(2);
  for (const std::size_t size : {12U, 150U}) {
    std::vector<double> values(size);
    for (std::size_t k = 0; k < size; ++k) values[k] = 1.0 - 0.001 * static_cast<double>(k);
    for (std::size_t k = 0; k < 4; ++k) values[k] = 1.02;
    const Reflected made = reflected(values, random);
    const Eigenvectors found = leading_eigenvectors(made.matrix, 2);
    EXPECT_NEAR(cosine(found.vectors.row(0), found.vectors.row(1)), 0.0, 1e-12);
    for (const std::size_t k : {0U, 1U}) {
      EXPECT_NEAR(found.values[k], 1.02, 1e-9) << size;
      double inside = 0.0;
      for (std::size_t own = 0; own < 4; ++own) {
        const double part = cosine(found.vectors.row(k), made.vectors.row(own));
        inside += part * part;
      }
      EXPECT_NEAR(inside, 1.0, 1e-7) << size;
    }
  }
}

TEST(LeadingEigenvectors, OfAMatrixOfLowRankHaveTheValueZeroBeyondIt) {
  Random random(3);
  for (const std::size_t size : {1U, 4U, 70U}) {
    std::vector<double> values(size);
    values[size / 2] = 1e30;
    const Reflected made = reflected(values, random);
    const Eigenvectors found = leading_eigenvectors(made.matrix, 2);
    EXPECT_EQ(found.values.size(), std::min<std::size_t>(size, 2));
    EXPECT_NEAR(found.values[0] / 1e30, 1.0, 1e-12);
    if (size > 1) {
      EXPECT_NEAR(found.values[1] / 1e30, 0.0, 1e-12);
    }
    const Eigenvectors none = leading_eigenvectors(Matrix<double>(size, size), 2);
    EXPECT_EQ(none.values.front(), 0.0);
  }
}

// Of [[2, 1], [1, 2]]: 3 and (1, 1), 1 and (1, -1).
TEST(LeadingEigenvectors, AllAreInTheOrderOfTheirValues) {
  const Eigenvectors all = all_eigenvectors(Matrix<double>(2, 2, {2, 1, 1, 2}));
  EXPECT_NEAR(all.values[0], 3.0, 1e-15);
  EXPECT_NEAR(all.values[1], 1.0, 1e-15);
  EXPECT_NEAR(all.vectors(0, 0), all.vectors(0, 1), 1e-15);
  EXPECT_NEAR(all.vectors(1, 0), -all.vectors(1, 1), 1e-15);
}

}  // namespace
}  // namespace somato
