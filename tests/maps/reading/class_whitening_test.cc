#include "maps/reading/class_whitening.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using Rows = std::vector<std::vector<double>>;
using Numbers = std::vector<std::size_t>;

struct ClassProblem {
  Matrix<float> rows;
  Numbers places;
  Numbers classes;
};

// Three classes far apart, whose elements vary by different amounts and together.
ClassProblem class_problem(std::size_t count, std::size_t size, std::uint64_t seed) {
  Random random(seed);
  ClassProblem problem{Matrix<float>(count, size), Numbers(count), {}};
  std::iota(problem.places.begin(), problem.places.end(), std::size_t{0});
  for (std::size_t i = 0; i < count; ++i) {
    problem.classes.push_back(i % 3);
    const double common = random.normal();
    for (std::size_t d = 0; d < size; ++d) {
      const double spread = 0.2 + static_cast<double>(d);
      problem.rows(i, d) = static_cast<float>(10.0 * static_cast<double>(i % 3 * (d % 2)) +
                                              spread * (common + 0.5 * random.normal()));
    }
  }
  return problem;
}

// (1 - s) S / (s m) + I, straight from the definition.
Rows normalized_covariance(const ClassProblem& problem, double shrinkage) {
  const std::size_t size = problem.rows.columns();
  Rows sums(3, std::vector<double>(size, 0.0));
  std::vector<double> counts(3, 0.0);
  for (std::size_t i = 0; i < problem.rows.rows(); ++i) {
    counts[problem.classes[i]] += 1.0;
    for (std::size_t d = 0; d < size; ++d) sums[problem.classes[i]][d] += problem.rows(i, d);
  }
  const double classes = static_cast<double>(
      std::count_if(counts.begin(), counts.end(), [](double one) { return one > 0.0; }));
  Rows covariance(size, std::vector<double>(size, 0.0));
  for (std::size_t a = 0; a < size; ++a) {
    for (std::size_t b = 0; b < size; ++b) {
      for (std::size_t i = 0; i < problem.rows.rows(); ++i) {
        const std::size_t c = problem.classes[i];
        covariance[a][b] += (problem.rows(i, a) - sums[c][a] / counts[c]) *
                            (problem.rows(i, b) - sums[c][b] / counts[c]);
      }
      covariance[a][b] /= static_cast<double>(problem.rows.rows()) - classes;
    }
  }
  double mean = 0.0;
  for (std::size_t d = 0; d < size; ++d) mean += covariance[d][d] / static_cast<double>(size);
  for (std::size_t a = 0; a < size; ++a) {
    for (double& value : covariance[a]) value *= (1.0 - shrinkage) / (shrinkage * mean);
    covariance[a][a] += 1.0;
  }
  return covariance;
}

Matrix<double> whitening_of(const ClassProblem& problem, double shrinkage = 0.3) {
  return whitening_within_classes(Samples(problem.rows), problem.places, problem.classes,
                                  shrinkage);
}

// B M B' is I if and only if B' B is the inverse of M. Also with fewer samples than elements.
TEST(ClassWhitening, IsTheInverseOfTheShrunkCovariance) {
  for (const auto& [count, size] : {std::pair{30, 4}, {7, 12}, {40, 1}}) {
    for (const double shrinkage : {0.02, 0.3, 0.9}) {
      const ClassProblem problem =
          class_problem(static_cast<std::size_t>(count), static_cast<std::size_t>(size), 5);
      const Rows matrix = normalized_covariance(problem, shrinkage);
      const Matrix<double> b = whitening_of(problem, shrinkage);
      const std::size_t n = matrix.size();
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
          double sum = 0.0;
          for (std::size_t k = 0; k < n; ++k) {
            for (std::size_t l = 0; l < n; ++l) sum += b(i, k) * matrix[k][l] * b(j, l);
          }
          EXPECT_NEAR(sum, i == j ? 1.0 : 0.0, 1e-9) << count << ' ' << shrinkage;
          if (j > i) {
            EXPECT_EQ(b(i, j), 0.0);
          }
        }
      }
    }
  }
}

Som map_with(const Matrix<float>& rows) {
  SomParameters parameters;
  parameters.rows = 1;
  parameters.columns = rows.rows();
  return {resolve(parameters, 1, 1).value(), rows};
}

double distance_by(const Matrix<double>& whitening, std::span<const float> a,
                   std::span<const float> b) {
  double squared = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    double sum = 0.0;
    for (std::size_t d = 0; d < a.size(); ++d) {
      sum += whitening(i, d) * (double{a[d]} - double{b[d]});
    }
    squared += sum * sum;
  }
  return std::sqrt(squared);
}

TEST(ClassWhitening, TheNearestNeuronIsThatOfPlainLoops) {
  const ClassProblem problem = class_problem(24, 5, 2);
  const Matrix<double> whitening = whitening_of(problem);
  const ClassProblem others = class_problem(9, 5, 8);
  const Som som = map_with(others.rows);
  const Numbers neurons{1, 4, 5, 8};
  const WhitenedNeurons whitened(whitening, som, neurons);
  for (std::size_t i = 0; i < problem.rows.rows(); ++i) {
    for (const auto except : {std::optional<std::size_t>{}, std::optional<std::size_t>{4}}) {
      double best = 1e300;
      std::size_t nearest = 0;
      for (const std::size_t neuron : neurons) {
        const double distance =
            distance_by(whitening, problem.rows.row(i), others.rows.row(neuron));
        if (neuron == except || distance >= best) continue;
        best = distance;
        nearest = neuron;
      }
      const auto found = whitened.nearest(SignalView::dense(problem.rows.row(i)), except);
      EXPECT_EQ(found.neuron, nearest);
      EXPECT_NEAR(found.distance, best, 1e-9 * best);
    }
  }
}

TEST(ClassWhitening, AnOnlyNeuronIsTheNearestEvenIfItIsExcepted) {
  const ClassProblem problem = class_problem(6, 2, 2);
  const Matrix<double> whitening = whitening_of(problem);
  const WhitenedNeurons whitened(whitening, map_with(problem.rows), {3});
  EXPECT_EQ(whitened.nearest(SignalView::dense(problem.rows.row(0)), 3).neuron, 3U);
  EXPECT_THROW(WhitenedNeurons(whitening, map_with(problem.rows), {}), InvalidArgument);
}

// 1024 is a power of two, so that every product is exact.
TEST(ClassWhitening, DoesNotDependOnTheUnit) {
  ClassProblem problem = class_problem(20, 6, 3);
  const Matrix<double> before = whitening_of(problem);
  for (float& value : problem.rows.values()) value *= 1024.0F;
  EXPECT_EQ(whitening_of(problem), before);
}

TEST(ClassWhitening, DoesNotDependOnAConstantElement) {
  const ClassProblem problem = class_problem(20, 3, 3);
  ClassProblem wider{Matrix<float>(20, 4, 7.0F), problem.places, problem.classes};
  for (std::size_t i = 0; i < 20; ++i) {
    std::copy_n(problem.rows.row(i).begin(), 3, wider.rows.row(i).begin());
  }
  const Matrix<double> before = whitening_of(problem);
  const Matrix<double> after = whitening_of(wider);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t d = 0; d < 3; ++d) EXPECT_EQ(after(i, d), before(i, d));
    EXPECT_EQ(after(3, i), 0.0);
  }
  EXPECT_EQ(after(3, 3), 1.0);
}

TEST(ClassWhitening, DistancesDoNotDependOnTheOrderOfElements) {
  const ClassProblem problem = class_problem(20, 4, 3);
  ClassProblem turned = problem;
  for (std::size_t i = 0; i < 20; ++i)
    std::reverse(turned.rows.row(i).begin(), turned.rows.row(i).end());
  for (std::size_t i = 1; i < 20; ++i) {
    const double before =
        distance_by(whitening_of(problem), problem.rows.row(0), problem.rows.row(i));
    const double after = distance_by(whitening_of(turned), turned.rows.row(0), turned.rows.row(i));
    EXPECT_NEAR(after, before, 1e-9 * before);
  }
}

TEST(ClassWhitening, IsPlainWithoutVarianceWithinClasses) {
  const Matrix<double> plain(2, 2, {1.0, 0.0, 0.0, 1.0});
  const Samples samples(Matrix<float>(3, 2, {1, 2, 1, 2, 5, 6}));
  EXPECT_EQ(whitening_within_classes(samples, Numbers{0, 1, 2}, Numbers{0, 0, 1}, 0.3), plain);
  EXPECT_EQ(whitening_within_classes(samples, Numbers{2}, Numbers{0}, 0.3), plain);
  EXPECT_EQ(whitening_of(class_problem(20, 2, 1), 1.0), plain);
}

TEST(ClassWhitening, RefusesImpossibleArguments) {
  const Samples samples(Matrix<float>(2, 1, {1, 2}));
  EXPECT_THROW((void)whitening_within_classes(samples, Numbers{}, Numbers{}, 0.3), InvalidArgument);
  EXPECT_THROW((void)whitening_within_classes(samples, Numbers{0}, Numbers{0, 1}, 0.3),
               InvalidArgument);
  EXPECT_THROW((void)whitening_within_classes(samples, Numbers{0}, Numbers{0}, 0.0),
               InvalidArgument);
  const Samples wide(Matrix<float>(1, kMostWhitenedElements + 1));
  EXPECT_THROW((void)whitening_within_classes(wide, Numbers{0}, Numbers{0}, 0.3), InvalidArgument);
}

TEST(ClassWhitening, IsForEuclideanMapsOfAFewElements) {
  EXPECT_TRUE(can_be_whitened(map_with(Matrix<float>(2, 3))));
  EXPECT_FALSE(can_be_whitened(map_with(Matrix<float>(2, kMostWhitenedElements + 1))));
  SomParameters parameters;
  parameters.rows = 1;
  parameters.columns = 2;
  parameters.similarity = Similarity::kManhattan;
  EXPECT_FALSE(can_be_whitened({resolve(parameters, 1, 1).value(), Matrix<float>(2, 3)}));
  EXPECT_EQ(not_to_be_whitened().value().kind, ErrorKind::kUsage);
}

}  // namespace
}  // namespace somato
