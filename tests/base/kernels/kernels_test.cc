#include "base/kernels/kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "base/core/lanes.h"
#include "base/support/instruction_sets.h"
#include "somato/core/matrix.h"
#include "somato/core/random.h"

namespace somato {
namespace {

// A random problem: weights, a sample of full length, a sparse one, and a value a row.
template <typename Real>
struct Problem {
  LaneMatrix<Real> weights;
  std::vector<Real> sample;
  std::vector<std::uint32_t> indices;
  std::vector<Real> sparse_values;
  AlignedVector<Real> gains;
};

template <typename Real>
Problem<Real> random_problem(Random& random) {
  const std::size_t rows = 1 + random.below(100);
  const std::size_t columns = 1 + random.below(700);
  Problem<Real> problem{LaneMatrix<Real>(rows, columns), {}, {}, {}, {}};
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      problem.weights(row, column) = static_cast<Real>(random.normal());
    }
  }
  for (std::uint32_t column = 0; column < columns; ++column) {
    problem.sample.push_back(static_cast<Real>(random.normal()));
    if (random.below(5) == 0) {
      problem.indices.push_back(column);
      problem.sparse_values.push_back(static_cast<Real>(random.normal()));
    }
  }
  problem.gains.resize(problem.weights.padded_rows());
  for (std::size_t row = 0; row < rows; ++row) {
    problem.gains[row] = row % 40 < 20 ? static_cast<Real>(random.uniform()) : Real{0};
  }
  return problem;
}

// Sums of products are right within the bound for chunks of kChunk: every partial sum is rounded
// once a term and once a chunk.
template <typename Real>
double rounding_bound(std::size_t terms, double sum_of_magnitudes) {
  const double roundings = static_cast<double>(std::min(terms, kernels::kChunk)) +
                           static_cast<double>(terms / kernels::kChunk) + 4.0;
  return roundings * std::numeric_limits<Real>::epsilon() * sum_of_magnitudes;
}

// Compares a kernel's sums with plain sums of term(row, column) in long double.
template <typename Real, typename Term>
void expect_sums(const AlignedVector<Real>& sums, std::size_t rows, std::size_t terms,
                 const Term& term) {
  for (std::size_t row = 0; row < rows; ++row) {
    long double expected = 0.0L;
    long double magnitude = 0.0L;
    for (std::size_t i = 0; i < terms; ++i) {
      const long double value = term(row, i);
      expected += value;
      magnitude += std::fabs(value);
    }
    EXPECT_NEAR(static_cast<double>(sums[row]), static_cast<double>(expected),
                rounding_bound<Real>(terms, static_cast<double>(magnitude)))
        << "row " << row;
  }
}

template <typename Real>
class Kernels : public ::testing::Test {};
using Reals = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Kernels, Reals);

TYPED_TEST(Kernels, GiveThePlainSums) {
  using Real = TypeParam;
  Random random(11);
  for (int i = 0; i < 60; ++i) {
    const Problem<Real> p = random_problem<Real>(random);
    const auto& w = p.weights;
    const std::size_t rows = w.rows();
    const auto& table = kernels::table<Real>();
    AlignedVector<Real> out(w.padded_rows());
    using Exact = long double;

    table.squared_distances(kernels::lanes(w), p.sample.data(), out.data());
    expect_sums(out, rows, w.columns(), [&](std::size_t row, std::size_t d) {
      const Exact difference = Exact{p.sample[d]} - Exact{w(row, d)};
      return difference * difference;
    });
    table.inner_products(kernels::lanes(w), p.sample.data(), out.data());
    expect_sums(out, rows, w.columns(), [&](std::size_t row, std::size_t d) {
      return Exact{p.sample[d]} * Exact{w(row, d)};
    });
    table.squared_norms(kernels::lanes(w), out.data());
    expect_sums(out, rows, w.columns(), [&](std::size_t row, std::size_t d) {
      return Exact{w(row, d)} * Exact{w(row, d)};
    });
    table.sparse_inner_products(kernels::lanes(w), p.indices.data(), p.sparse_values.data(),
                                p.indices.size(), out.data());
    expect_sums(out, rows, p.indices.size(), [&](std::size_t row, std::size_t k) {
      return Exact{p.sparse_values[k]} * Exact{w(row, p.indices[k])};
    });
  }
}

TYPED_TEST(Kernels, MoveRowsByTheirGain) {
  using Real = TypeParam;
  Random random(12);
  for (int i = 0; i < 60; ++i) {
    const Problem<Real> p = random_problem<Real>(random);
    LaneMatrix<Real> moved = p.weights;
    kernels::table<Real>().move_towards(kernels::lanes(moved), p.sample.data(), p.gains.data());
    for (std::size_t row = 0; row < moved.rows(); ++row) {
      for (std::size_t d = 0; d < moved.columns(); ++d) {
        const Real difference = p.sample[d] - p.weights(row, d);
        EXPECT_EQ(moved(row, d), std::fma(p.gains[row], difference, p.weights(row, d)));
      }
    }
  }
}

TYPED_TEST(Kernels, AddScaledVectorsInDoublePrecision) {
  using Real = TypeParam;
  Random random(15);
  const std::vector<double> start(37, 0.25);
  std::vector<Real> x(37);
  for (Real& value : x) value = static_cast<Real>(random.normal());
  std::vector<double> sums = start;
  kernels::table<Real>().add_scaled(x.data(), 1.5, x.size(), sums.data());
  for (std::size_t i = 0; i < x.size(); ++i) {
    EXPECT_EQ(sums[i], std::fma(1.5, static_cast<double>(x[i]), 0.25));
  }
}

TYPED_TEST(Kernels, ScaleRowsByTheirFactor) {
  using Real = TypeParam;
  Random random(13);
  const Problem<Real> p = random_problem<Real>(random);
  LaneMatrix<Real> scaled = p.weights;
  kernels::table<Real>().scale_rows(kernels::lanes(scaled), p.gains.data());
  for (std::size_t row = 0; row < scaled.rows(); ++row) {
    for (std::size_t d = 0; d < scaled.columns(); ++d) {
      EXPECT_EQ(scaled(row, d), p.weights(row, d) * p.gains[row]);
    }
  }
}

// The least magnitude kept is kNegligible itself; NaN is no small number.
TYPED_TEST(Kernels, ClearWhatIsNegligible) {
  using Real = TypeParam;
  const Real limit = kernels::kNegligible<Real>;
  const Real below = std::nextafter(limit, Real{0});
  const Real smallest = std::numeric_limits<Real>::denorm_min();
  testing::for_each_instruction_set([&](InstructionSet /*set*/) {
    LaneMatrix<Real> w(Matrix<Real>(2, 4, {limit, below, -limit, -below, smallest, 1, -1, 0}));
    kernels::table<Real>().clear_negligible(kernels::lanes(w));
    EXPECT_EQ(w.to_matrix(), Matrix<Real>(2, 4, {limit, 0, -limit, 0, 0, 1, -1, 0}));
    w(0, 0) = std::numeric_limits<Real>::quiet_NaN();
    kernels::table<Real>().clear_negligible(kernels::lanes(w));
    EXPECT_TRUE(std::isnan(w(0, 0)));
  });
}

// Everything the kernels compute for some problems, one value after the other.
template <typename Real>
std::vector<Real> all_results() {
  Random random(14);
  std::vector<Real> results;
  const auto& table = kernels::table<Real>();
  for (int i = 0; i < 30; ++i) {
    Problem<Real> p = random_problem<Real>(random);
    const kernels::Lanes<const Real> w = kernels::lanes(std::as_const(p.weights));
    AlignedVector<Real> out(p.weights.padded_rows());
    const auto keep = [&] { results.insert(results.end(), out.begin(), out.end()); };
    table.squared_distances(w, p.sample.data(), out.data());
    keep();
    table.inner_products(w, p.sample.data(), out.data());
    keep();
    table.squared_norms(w, out.data());
    keep();
    table.sparse_inner_products(w, p.indices.data(), p.sparse_values.data(), p.indices.size(),
                                out.data());
    keep();
    table.move_towards(kernels::lanes(p.weights), p.sample.data(), p.gains.data());
    table.scale_rows(kernels::lanes(p.weights), p.gains.data());
    const Matrix<Real> weights = p.weights.to_matrix();
    results.insert(results.end(), weights.values().begin(), weights.values().end());
  }
  return results;
}

TYPED_TEST(Kernels, GiveTheSameBitsOnEveryInstructionSet) {
  use_instruction_set(InstructionSet::kPortable);
  const std::vector<TypeParam> expected = all_results<TypeParam>();
  testing::for_each_instruction_set(
      [&](InstructionSet set) { EXPECT_EQ(all_results<TypeParam>(), expected) << name_of(set); });
  use_instruction_set(available_instruction_sets().back());
}

}  // namespace
}  // namespace somato
