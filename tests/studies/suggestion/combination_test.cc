#include "studies/suggestion/combination.h"

#include <gtest/gtest.h>

#include "studies/codes/neighbours.h"

namespace somato {
namespace {

// A part whose values are the same in every view.
Part part_of(std::size_t sense, const std::vector<float>& values) {
  Part part{{sense}, {}};
  const Matrix<float> distances =
      squared_distances(Samples(Matrix<float>(values.size(), 1, values)), 1);
  for (const View view : kAllViews) part.distances[view] = distances;
  return part;
}

std::vector<Neighbourhoods> senses_of(const std::vector<Choice>& choices,
                                      const std::vector<std::size_t>& of_senses) {
  std::vector<Neighbourhoods> senses;
  for (const std::size_t choice : of_senses) {
    Neighbourhoods& ranks = senses.emplace_back();
    for (const View view : kAllViews) {
      const Matrix<float>& distances = choices[choice].part.distances[view];
      ranks.ranks[view] = Matrix<float>(distances.rows(), distances.rows());
      add_ranks(distances, 1, ranks.ranks[view]);
    }
  }
  return senses;
}

CombinationSettings settings(std::size_t budget = 1000) {
  return {{1.0, 0.5, 2.0}, 0.002, budget, 1, [](double) { return Result<void>(); }};
}

// Four objects, felt three times each: the first sense separates them in two pairs, the second one
// in two other pairs.
std::vector<Choice> complementary() {
  return {
      {0, 0,
       part_of(0, {0.0F, 0.1F, 0.3F, 0.05F, 0.15F, 0.2F, 9.0F, 9.1F, 9.3F, 9.05F, 9.15F, 9.2F})},
      {1, 0,
       part_of(1, {0.0F, 0.2F, 0.3F, 9.0F, 9.2F, 9.3F, 0.1F, 0.25F, 0.05F, 9.1F, 9.25F, 9.05F})}};
}

TEST(Combination, ComplementarySensesAreBothKept) {
  const std::vector<Choice> choices = complementary();
  const auto senses = senses_of(choices, {0, 1});
  const Combination found = best_combination(choices, senses, settings()).value();
  ASSERT_EQ(found.parts.size(), 2U);
  EXPECT_LT(found.parts[1].score, found.parts[0].score);
  EXPECT_EQ(found.parts[0].weight, 1.0);
  EXPECT_EQ(found.compared, 2U + 3U);
}

TEST(Combination, APartThatDoesNotHelpIsNotAdded) {
  std::vector<Choice> choices = complementary();
  const auto senses = senses_of(choices, {0});
  const Combination found = best_combination(choices, senses, settings()).value();
  ASSERT_EQ(found.parts.size(), 1U);
  EXPECT_EQ(found.parts[0].choice, 0U);
}

TEST(Combination, AGroupIsUsedOnce) {
  std::vector<Choice> choices = complementary();
  choices.push_back({0, 1, choices[0].part});
  const Combination found =
      best_combination(choices, senses_of(choices, {0, 1}), settings()).value();
  EXPECT_EQ(found.parts.size(), 2U);
}

TEST(Combination, TheBudgetLimitsTheNumberOfCombinations) {
  const std::vector<Choice> choices = complementary();
  const auto senses = senses_of(choices, {0, 1});
  for (const std::size_t budget : {1U, 2U, 3U}) {
    EXPECT_EQ(best_combination(choices, senses, settings(budget)).value().compared, budget);
  }
  EXPECT_EQ(best_combination(choices, senses, settings(2)).value().parts.size(), 1U);
}

TEST(Combination, CanBeInterrupted) {
  const std::vector<Choice> choices = complementary();
  CombinationSettings stopped = settings();
  stopped.proceed = [](double) -> Result<void> { return fail(ErrorKind::kInterrupted, "stopped"); };
  const auto found = best_combination(choices, senses_of(choices, {0, 1}), stopped);
  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().kind, ErrorKind::kInterrupted);
}

TEST(Combination, OfAllTakesTheFirstChoiceOfEverySense) {
  std::vector<Choice> choices = complementary();
  choices.insert(choices.begin() + 1, {0, 1, choices[0].part});
  const Combination all = all_of(choices, senses_of(choices, {0, 2}));
  ASSERT_EQ(all.parts.size(), 2U);
  EXPECT_EQ(all.parts[1].choice, 2U);
}

}  // namespace
}  // namespace somato
