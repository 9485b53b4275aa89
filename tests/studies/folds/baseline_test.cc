#include "studies/folds/baseline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

#include "somato/core/random.h"
#include "studies/support/prepared_study.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;
using Rows = std::vector<std::vector<double>>;

// Explorations with a vector each, and the division into training and test.
struct Problem {
  Rows rows;
  std::string letters;  // the class of each
  Fold fold;
  InnerFolds inner = {};

  ExplorationValues vectors() const {
    Matrix<float> matrix(rows.size(), rows.front().size());
    Numbers numbers;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      numbers.push_back(i);
      for (std::size_t d = 0; d < rows[i].size(); ++d) {
        matrix(i, d) = static_cast<float>(rows[i][d]);
      }
    }
    return {numbers, Samples(std::move(matrix))};
  }

  PreparedStudy prepared() const {
    return testing::study_of({testing::letter_label("object", letters)});
  }

  Neighbours neighbours() const {
    return nearest_neighbours(vectors(), prepared(), fold, inner).front();
  }
};

// Every third exploration is tested; classes are recorded one after another. Values are `float`.
Problem random_problem(std::size_t seed) {
  Random random(seed);
  Problem problem;
  const std::size_t classes = 2 + random.below(3);
  const std::size_t columns = 1 + random.below(5);
  const std::size_t each = 4 + random.below(12);
  for (std::size_t i = 0; i < classes * each; ++i) {
    problem.letters += static_cast<char>('a' + static_cast<int>(i / each));
    std::vector<double> row;
    for (std::size_t d = 0; d < columns; ++d) {
      const double scale = d % 2 == 0 || seed % 3 == 0 ? 1.0 : 40.0;
      const double noise = random.normal() * random.normal();
      row.push_back(static_cast<float>(scale * (noise + (d % 2 == 0 ? double(i / each) : 0.0))));
    }
    problem.rows.push_back(row);
    (i % 3 == 1 ? problem.fold.test : problem.fold.training).push_back(i);
  }
  return problem;
}

// As defined, with every distance written out.
Numbers slow_neighbours(const Rows& rows, const Numbers& training, const Numbers& tests,
                        bool manhattan, bool standardized) {
  std::vector<double> units;
  for (std::size_t d = 0; d < rows[0].size(); ++d) {
    double mean = 0.0;
    for (const std::size_t i : training) mean += rows[i][d] / double(training.size());
    double variance = 0.0;
    for (const std::size_t i : training) {
      variance += (rows[i][d] - mean) * (rows[i][d] - mean) / double(training.size());
    }
    units.push_back(standardized ? std::sqrt(variance) : 1.0);
  }
  Numbers nearest;
  for (const std::size_t test : tests) {
    double least = std::numeric_limits<double>::infinity();
    std::size_t found = 0;
    for (const std::size_t candidate : training) {
      double sum = 0.0;
      for (std::size_t d = 0; d < rows[0].size(); ++d) {
        if (units[d] == 0.0) continue;
        const double apart = (rows[candidate][d] - rows[test][d]) / units[d];
        sum += manhattan ? std::abs(apart) : apart * apart;
      }
      if (sum < least) {
        least = sum;
        found = candidate;
      }
    }
    nearest.push_back(found);
  }
  return nearest;
}

// The kind with most right answers in these divisions of the training part, and its neighbours.
BestNeighbours slow_best(const Problem& problem, const std::vector<Fold>& inner) {
  std::size_t most = 0;
  BestNeighbours best;
  for (std::size_t kind = 0; kind < 4; ++kind) {
    std::size_t right = 0;
    for (const Fold& fold : inner) {
      const Numbers nearest =
          slow_neighbours(problem.rows, fold.training, fold.test, kind >= 2, kind % 2 == 1);
      for (std::size_t i = 0; i < fold.test.size(); ++i) {
        right += problem.letters[nearest[i]] == problem.letters[fold.test[i]] ? 1 : 0;
      }
    }
    if (kind > 0 && right <= most) continue;
    most = right;
    best.kind = kind;
  }
  best.nearest = slow_neighbours(problem.rows, problem.fold.training, problem.fold.test,
                                 best.kind >= 2, best.kind % 2 == 1);
  return best;
}

TEST(BestNeighbour, IsThatOfASlowSearchInInnerFolds) {
  std::set<std::size_t> kinds;
  for (std::size_t seed = 1; seed <= 60; ++seed) {
    Problem problem = random_problem(seed);
    problem.inner.choice = seed % 2 == 0 ? FoldChoice::kBlocks : FoldChoice::kInterleaved;
    const auto inner = folds_among(problem.fold.training, problem.prepared().classes().of_sample, 5,
                                   1, problem.inner.choice);
    const BestNeighbours expected = slow_best(problem, inner);
    const Neighbours found = problem.neighbours();
    ASSERT_EQ(found.best.size(), 1U);
    EXPECT_EQ(found.best.front(), expected) << seed;
    EXPECT_EQ(found.raw, slow_neighbours(problem.rows, problem.fold.training, problem.fold.test,
                                         false, false));
    kinds.insert(expected.kind);
  }
  EXPECT_EQ(kinds.size(), 4U) << "the problems choose every kind";
}

TEST(BestNeighbour, OfGroupsIsChosenByLeavingGroupsOut) {
  for (std::size_t seed = 1; seed <= 20; ++seed) {
    Problem problem = random_problem(seed);
    for (std::size_t i = 0; i < problem.rows.size(); ++i) problem.inner.groups.push_back(i % 7);
    Numbers groups;  // of the training part, of which the sixth and seventh join the first two
    for (std::size_t group = 0; group < 7; ++group) {
      const auto has = [&](std::size_t i) { return i % 7 == group; };
      if (std::ranges::any_of(problem.fold.training, has)) groups.push_back(group);
    }
    std::vector<Fold> inner(std::min<std::size_t>(5, groups.size()));
    for (std::size_t g = 0; g < groups.size(); ++g) {
      for (const std::size_t i : problem.fold.training) {
        if (i % 7 == groups[g]) inner[g % inner.size()].test.push_back(i);
      }
    }
    for (Fold& fold : inner) {
      std::sort(fold.test.begin(), fold.test.end());
      std::set_difference(problem.fold.training.begin(), problem.fold.training.end(),
                          fold.test.begin(), fold.test.end(), std::back_inserter(fold.training));
    }
    EXPECT_EQ(problem.neighbours().best.front(), slow_best(problem, inner)) << seed;
    problem.inner.groups.assign(problem.rows.size(), 3);  // one group cannot be left out
    const Neighbours one_group = problem.neighbours();
    problem.inner.groups.clear();
    EXPECT_EQ(one_group, problem.neighbours());
  }
}

// The first column separates the classes, and the second is noise with a large unit.
Problem standardized_problem(double unit) {
  Random random(4);
  Problem problem;
  for (std::size_t i = 0; i < 60; ++i) {
    problem.letters += i % 2 == 0 ? 'a' : 'b';
    problem.rows.push_back({double(i % 2) * 4.0 + random.uniform(), unit * random.normal()});
    (i % 5 == 0 ? problem.fold.test : problem.fold.training).push_back(i);
  }
  return problem;
}

TEST(BestNeighbour, IsStandardizedInAnyUnit) {
  const Neighbours first = standardized_problem(4096.0).neighbours();
  EXPECT_TRUE(kNeighbourKinds.at(first.best.front().kind).standardized);
  for (const double unit : {1024.0, 65536.0}) {  // powers of two lose nothing to rounding
    const Neighbours scaled = standardized_problem(unit).neighbours();
    EXPECT_EQ(scaled.best, first.best);
    EXPECT_EQ(scaled.standardized, first.standardized);
  }
}

TEST(BestNeighbour, ChoosesTheSameFromAFewTestsOfManySamples) {
  Problem problem = standardized_problem(4096.0);
  const Neighbours all = problem.neighbours();
  problem.inner.most_tests = 8;
  EXPECT_EQ(problem.neighbours(), all);
}

TEST(BestNeighbour, IsTheFirstKindWhereNothingCanBeChosen) {
  for (const Numbers& training : {Numbers{1}, Numbers{1, 2}, Numbers{1, 2, 3}}) {
    Problem problem;
    problem.rows = {{0.0}, {1.0}, {1.0}, {1.0}, {5.0}};
    problem.letters = "aaaab";  // one class is learned, and all samples are equal
    problem.fold = {training, {0, 4}};
    const Neighbours found = problem.neighbours();
    EXPECT_EQ(found.best.front().kind, 0U);
    EXPECT_EQ(found.best.front().nearest, (Numbers{1, 1}));
  }
}

TEST(BestNeighbour, IsChosenForEachLabel) {
  Problem problem = standardized_problem(4096.0);
  PreparedStudy prepared = problem.prepared();
  std::string noise;  // the second label follows from the second column
  for (const auto& row : problem.rows) noise += row[1] < 0.0 ? 'x' : 'y';
  prepared.labels.push_back(testing::letter_label("noise", noise));
  const auto best = nearest_neighbours(problem.vectors(), prepared, problem.fold, {}).front().best;
  ASSERT_EQ(best.size(), 2U);
  EXPECT_TRUE(kNeighbourKinds.at(best[0].kind).standardized);
  EXPECT_FALSE(kNeighbourKinds.at(best[1].kind).standardized);
}

TEST(InnerFolds, FollowTheProtocol) {
  FoldSamples samples{4};
  samples.groups = {0, 1, 0, 1};
  samples.choice = FoldChoice::kBlocks;
  EXPECT_EQ(inner_folds_for(Protocol::kFolds, samples, 5).choice, FoldChoice::kBlocks);
  EXPECT_EQ(inner_folds_for(Protocol::kLeaveOneOut, samples, 5).choice, FoldChoice::kInterleaved);
  EXPECT_EQ(inner_folds_for(Protocol::kLeaveGroupOut, samples, 5).groups, samples.groups);
  EXPECT_TRUE(inner_folds_for(Protocol::kFolds, samples, 5).groups.empty());
  EXPECT_EQ(inner_folds_for(Protocol::kFolds, samples, 5).most_tests, 1000U);
  EXPECT_EQ(inner_folds_for(Protocol::kLeaveOneOut, samples, 10000).most_tests, 200U);
}

TEST(NeighbourKind, HasAName) {
  EXPECT_EQ(kNeighbourKinds[0].name(), "euclidean, raw");
  EXPECT_EQ(kNeighbourKinds[3].name(), "manhattan, standardized");
}

}  // namespace
}  // namespace somato
