#include "maps/grid/size_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <utility>

#include "base/core/rank_correlation.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;
using Values = std::vector<double>;
using Individuals = std::vector<MappedIndividual>;

const Grid kSquare(3, 3, Lattice::kRectangular, Topology::kPlane);

//   0  1  2
//     3  4  5
//   6  7  8
TEST(MappedIndividuals, AreAtTheMeanOfTheirWinners) {
  const Grid grid(3, 3, Lattice::kHexagonal, Topology::kPlane);
  const Individuals mapped = mapped_individuals(grid, {0, 8, 4}, {1, 0, 1}, {7.0, 9.0}, {3, 2});
  ASSERT_EQ(mapped.size(), 2U);
  EXPECT_EQ(mapped[0].number, 7.0);
  EXPECT_EQ(mapped[0].group, 3U);
  EXPECT_DOUBLE_EQ(mapped[0].position.x, 2.0);
  EXPECT_DOUBLE_EQ(mapped[0].position.y, std::sqrt(3.0));
  EXPECT_EQ(mapped[1].number, 9.0);
  EXPECT_EQ(mapped[1].group, 2U);
  EXPECT_DOUBLE_EQ(mapped[1].position.x, 0.75);
  EXPECT_DOUBLE_EQ(mapped[1].position.y, std::sqrt(3.0) / 4.0);
}

// The first and the last neuron of a row touch, and yet their mean is in the middle.
TEST(MappedIndividuals, CutATorusOpen) {
  const Grid grid(1, 5, Lattice::kRectangular, Topology::kTorus);
  EXPECT_DOUBLE_EQ(mapped_individuals(grid, {0, 4}, {0, 0}, {1.0}, {0})[0].position.x, 2.0);
}

TEST(MappedIndividuals, RefuseWhatDoesNotFit) {
  EXPECT_THROW((void)mapped_individuals(kSquare, {0, 1}, {0}, {1}, {0}), InvalidArgument);
  EXPECT_THROW((void)mapped_individuals(kSquare, {0}, {0}, {1}, {0, 0}), InvalidArgument);
  EXPECT_THROW((void)mapped_individuals(kSquare, {0}, {1}, {1}, {0}), InvalidArgument);
  EXPECT_THROW((void)mapped_individuals(kSquare, {0}, {0}, {1, 2}, {0, 0}), InvalidArgument);
  EXPECT_THROW((void)mapped_individuals(kSquare, {9}, {0}, {1}, {0}), InvalidArgument);
}

// The number at each neuron of a map of 3 x 3, 0 for none, and its group.
Individuals drawn(const Values& numbers, const Numbers& groups = Numbers(9, 0)) {
  Individuals individuals;
  for (std::size_t neuron = 0; neuron < numbers.size(); ++neuron) {
    if (numbers[neuron] == 0.0) continue;
    individuals.push_back({numbers[neuron], groups[neuron], kSquare.position(neuron)});
  }
  return individuals;
}

TEST(CircularOrder, IsPerfectInEitherDirectionFromAnywhere) {
  const Individuals clockwise = drawn({1, 2, 3,  //
                                       8, 0, 4,  //
                                       7, 6, 5});
  const Individuals from_elsewhere = drawn({4, 5, 6,  //
                                            3, 0, 7,  //
                                            2, 1, 8});
  const Individuals mirrored = drawn({5, 4, 3,  //
                                      6, 0, 2,  //
                                      7, 8, 1});
  EXPECT_DOUBLE_EQ(circular_order(clockwise).around, 1.0);
  EXPECT_DOUBLE_EQ(circular_order(from_elsewhere).around, 1.0);
  EXPECT_DOUBLE_EQ(circular_order(mirrored).around, 1.0);
}

// From the top and on: 1 2 4 3, with 1 - 6 * 2 / 60; 2 4 3 1 with 14 in place of 2; 4 3 1 2 with
// 18; 3 1 2 4 with 6.
TEST(CircularOrder, TakesTheBestStart) {
  EXPECT_DOUBLE_EQ(circular_order(drawn({0, 1, 0,  //
                                         3, 0, 2,  //
                                         0, 4, 0}))
                       .around,
                   0.8);
}

TEST(CircularOrder, PutsWhoIsAtTheCentreInTheMiddle) {
  EXPECT_DOUBLE_EQ(circular_order(drawn({0, 1, 0,  //
                                         5, 3, 2,  //
                                         0, 4, 0}))
                       .around,
                   1.0);
  // Places 1, 2, 4, 5 and 3 of the numbers 1 to 5: 1 - 6 * (1 + 1 + 4) / 120; less from elsewhere.
  EXPECT_DOUBLE_EQ(circular_order(drawn({0, 1, 0,  //
                                         4, 5, 2,  //
                                         0, 3, 0}))
                       .around,
                   0.7);
}

// 1 and 2 to the right of the centre, one behind the other. Their ranks are 1.5; less the means the
// products are 1.5, 0.5, 0.25 and 2.25, the squares 5 and 4.5.
TEST(CircularOrder, SharesPlacesAtEqualAnglesDespiteRounding) {
  const Individuals exact{{1, 0, {2, 0}}, {2, 0, {1, 0}}, {3, 0, {-3, 3}}, {4, 0, {0, -3}}};
  EXPECT_DOUBLE_EQ(circular_order(exact).around, std::sqrt(0.9));
  for (const double turned : {0.1, 0.7, 1.3, 2.9, 4.4}) {
    Individuals rounded = exact;
    for (MappedIndividual& individual : rounded) {
      const Position at = individual.position;
      individual.position.x = 0.1 * (at.x * std::cos(turned) - at.y * std::sin(turned)) + 0.7;
      individual.position.y = 0.1 * (at.x * std::sin(turned) + at.y * std::cos(turned)) + 0.3;
    }
    EXPECT_DOUBLE_EQ(circular_order(rounded).around, std::sqrt(0.9)) << turned;
  }
}

// The same 1 and 2 a hair above and below the line where angles start again.
TEST(CircularOrder, SharesPlacesWhereAFullTurnEnds) {
  EXPECT_DOUBLE_EQ(
      circular_order({{1, 0, {2, -1e-12}}, {2, 0, {1, 1e-12}}, {3, 0, {-3, 3}}, {4, 0, {0, -3}}})
          .around,
      std::sqrt(0.9));
}

TEST(CircularOrder, IsNoneWhereNothingDiffers) {
  EXPECT_EQ(circular_order({{1, 0, {2, 3}}, {2, 0, {2, 3}}, {3, 0, {2, 3}}}).around, 0.0);
  EXPECT_EQ(circular_order({{1, 0, {2, 3}}, {2, 0, {2, 3}}, {3, 0, {2, 3}}}).within, 0.0);
  EXPECT_EQ(circular_order(drawn({5, 5, 0, 0, 0, 0, 0, 0, 5})).around, 0.0);
  EXPECT_EQ(circular_order(drawn({5})).around, 0.0);
}

TEST(CircularOrder, RefusesWhatHasNoOrder) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW((void)circular_order({}), InvalidArgument);
  EXPECT_THROW((void)circular_order({{nan, 0, {0, 0}}}), InvalidArgument);
  EXPECT_THROW((void)circular_order({{0, 0, {nan, 0}}}), InvalidArgument);
  EXPECT_THROW((void)circular_order({{0, 0, {0, nan}}}), InvalidArgument);
  EXPECT_THROW((void)circular_order_chance({}, 1, 1), InvalidArgument);
}

// Groups: sides 0, corners 1.
const Numbers kSidesAndCorners{1, 0, 1, 0, 2, 0, 1, 0, 1};

// The sides 1 2 3 4 clockwise, the corners 5 6 7 8 clockwise from elsewhere.
TEST(CircularOrder, WithinGroupsStartsEachAnywhere) {
  const Individuals individuals = drawn({8, 1, 5,  //
                                         4, 0, 2,  //
                                         7, 3, 6},
                                        kSidesAndCorners);
  EXPECT_DOUBLE_EQ(circular_order(individuals).within, 1.0);
  EXPECT_LT(circular_order(individuals).around, 1.0);
}

// The corners the other way round: 1 for the sides clockwise, and the best start of 8 7 6 5 is
// 6 5 8 7 with 1 - 6 * 16 / 60 = -0.6 the other way, 0.6 this way: (1 + 0.6) / 2.
TEST(CircularOrder, WithinGroupsHasOneDirectionForAll) {
  const Individuals individuals = drawn({5, 1, 8,  //
                                         4, 0, 2,  //
                                         6, 3, 7},
                                        kSidesAndCorners);
  EXPECT_DOUBLE_EQ(circular_order(individuals).within, 0.8);
}

// Only two numbers at the corners: only the sides matter.
TEST(CircularOrder, WithinGroupsNeedsThreeNumbers) {
  const Individuals individuals = drawn({8, 1, 7,  //
                                         3, 0, 2,  //
                                         8, 4, 7},
                                        kSidesAndCorners);
  EXPECT_DOUBLE_EQ(circular_order(individuals).within, 0.8);
  EXPECT_EQ(circular_order(drawn({1, 2})).within, 0.0);
}

// From the top and on clockwise: 1 to 8, without and with 8 between 4 and 5; then two exceptions.
TEST(CircularOrder, CountsExceptionsInEitherDirectionFromAnywhere) {
  EXPECT_EQ(circular_order(drawn({1, 2, 3, 8, 0, 4, 7, 6, 5})).exceptions_around, 0U);
  EXPECT_EQ(circular_order(drawn({5, 4, 3, 6, 0, 2, 7, 8, 1})).exceptions_around, 0U);
  EXPECT_EQ(circular_order(drawn({1, 2, 3, 7, 0, 4, 6, 5, 8})).exceptions_around, 1U);
  EXPECT_EQ(circular_order(drawn({8, 5, 6, 4, 0, 7, 3, 2, 1})).exceptions_around, 1U);
  EXPECT_EQ(circular_order(drawn({3, 1, 5, 8, 0, 4, 7, 6, 2})).exceptions_around, 3U);
}

// Two lines from left to right. Around it 1 3 5 6 4 2, of which 1 3 5 6 are in order. Clockwise the
// lower line is 6 4 2, the other way round the upper one is 5 3 1: one exception in either
// direction.
TEST(CircularOrder, CountsExceptionsOfParallelLines) {
  const CircularOrder order = circular_order(drawn({1, 3, 5,  //
                                                    0, 0, 0,  //
                                                    2, 4, 6},
                                                   {0, 0, 0, 0, 0, 0, 1, 1, 1}));
  EXPECT_EQ(order.exceptions_around, 2U);
  EXPECT_EQ(order.exceptions_within, 1U);
}

TEST(CircularOrder, CountsNoExceptionOfEqualNumbers) {
  EXPECT_EQ(circular_order(drawn({1, 1, 2, 4, 0, 2, 3, 3, 3})).exceptions_around, 0U);
  EXPECT_EQ(circular_order(drawn({7, 7, 7, 7, 7, 7, 7, 7, 0})).exceptions_around, 0U);
}

// 1 and 2 at one angle are in no order; equal ones are. The centre has no angle.
TEST(CircularOrder, CountsWhatHasNoPlaceAsExceptions) {
  EXPECT_EQ(circular_order({{1, 0, {2, 0}}, {2, 0, {1, 0}}, {3, 0, {-3, 3}}, {4, 0, {0, -3}}})
                .exceptions_around,
            1U);
  EXPECT_EQ(circular_order({{2, 0, {2, 0}}, {2, 0, {1, 0}}, {3, 0, {-3, 3}}, {4, 0, {0, -3}}})
                .exceptions_around,
            0U);
  EXPECT_EQ(circular_order(drawn({0, 1, 0, 4, 9, 2, 0, 3, 0})).exceptions_around, 1U);
  EXPECT_EQ(circular_order(drawn({5})).exceptions_around, 0U);
  EXPECT_EQ(circular_order({{1, 0, {2, 3}}, {2, 0, {2, 3}}, {3, 0, {2, 3}}}).exceptions_around, 2U);
}

// Two numbers are always in order, so that the corners do not count: the sides are 1 2 4 3.
TEST(CircularOrder, CountsExceptionsOfGroupsWithThreeNumbers) {
  const Individuals individuals = drawn({8, 1, 7,  //
                                         3, 0, 2,  //
                                         8, 4, 7},
                                        kSidesAndCorners);
  EXPECT_EQ(circular_order(individuals).exceptions_within, 1U);
  EXPECT_EQ(circular_order(drawn({1, 2})).exceptions_within, 0U);
}

bool circular_order_has_centre(const Individuals& individuals) {
  Position sum;
  for (const MappedIndividual& one : individuals) {
    sum.x += one.position.x;
    sum.y += one.position.y;
  }
  const auto count = static_cast<double>(individuals.size());
  return std::any_of(individuals.begin(), individuals.end(), [&](const MappedIndividual& one) {
    return std::abs(one.position.x - sum.x / count) + std::abs(one.position.y - sum.y / count) <
           1e-6;
  });
}

// The individuals of a set of bits, by ascending angle around the centre.
std::vector<std::pair<double, double>> chosen(const Individuals& individuals, std::size_t bits,
                                              double direction) {
  double x = 0.0;
  double y = 0.0;
  for (const MappedIndividual& one : individuals) {
    x += one.position.x / static_cast<double>(individuals.size());
    y += one.position.y / static_cast<double>(individuals.size());
  }
  std::vector<std::pair<double, double>> turns;
  for (std::size_t i = 0; i < individuals.size(); ++i) {
    if ((bits >> i & 1U) == 0) continue;
    const double angle = std::atan2(individuals[i].position.y - y, individuals[i].position.x - x);
    turns.emplace_back(std::round(direction * angle * 1e6), individuals[i].number);
  }
  std::sort(turns.begin(), turns.end());
  return turns;
}

// Whether from some start no number falls, and those at one angle are equal.
bool is_in_order(const std::vector<std::pair<double, double>>& turns) {
  std::size_t falls = 0;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const auto& next = turns[(i + 1) % turns.size()];
    if (turns[i].first == next.first && turns[i].second != next.second) return false;
    falls += next.second < turns[i].second ? 1 : 0;
  }
  return falls <= 1;
}

std::size_t exceptions_by_trying(const Individuals& individuals) {
  int most = 1;
  for (std::size_t bits = 1; bits < std::size_t{1} << individuals.size(); ++bits) {
    for (const double direction : {1.0, -1.0}) {
      if (is_in_order(chosen(individuals, bits, direction))) {
        most = std::max(most, std::popcount(bits));
      }
    }
  }
  return individuals.size() - static_cast<std::size_t>(most);
}

// On odd numbers of places around a centre that no individual is at, some of them shared.
TEST(CircularOrder, CountsTheExceptionsThatTryingAllFinds) {
  Random random(5, Stream::kSizeOrder);
  for (int problem = 0; problem < 200; ++problem) {
    Individuals individuals;
    const std::size_t count = 3 + random.below(6);
    for (std::size_t i = 0; i < count; ++i) {
      individuals.push_back(
          {static_cast<double>(random.below(6)),
           0,
           {static_cast<double>(random.below(5)), static_cast<double>(random.below(5)) + 0.37}});
    }
    // An individual at the centre has no angle, and atan2 gives it one.
    if (circular_order_has_centre(individuals)) continue;
    EXPECT_EQ(circular_order(individuals).exceptions_around, exceptions_by_trying(individuals))
        << problem;
  }
}

TEST(CircularOrderByChance, HasTheExceptionsOfEachShuffle) {
  const CircularOrderByChance by_chance =
      circular_order_chance(drawn({0, 1, 0, 4, 0, 2, 0, 3, 0}), 600, 3);
  std::size_t without = 0;
  for (const CircularOrder& order : by_chance.of_each) {
    EXPECT_LE(order.exceptions_around, 1U);
    EXPECT_EQ(order.exceptions_around == 0, order.around > 0.99);
    without += order.exceptions_around == 0 ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<double>(without) / 600, 1.0 / 3.0, 0.07);  // 2 of the 6 orders
}

// Four have six orders around: two of them (one a direction) with 1, four with 0.8.
TEST(CircularOrderByChance, GivesFourAMeanAndAShare) {
  const Individuals right = drawn({0, 1, 0,  //
                                   4, 0, 2,  //
                                   0, 3, 0});
  const CircularOrderByChance by_chance = circular_order_chance(right, 20000, 3);
  EXPECT_NEAR(by_chance.mean.around, 2.6 / 3.0, 0.003);
  EXPECT_NEAR(by_chance.share_as_high.around, 1.0 / 3.0, 0.015);
  const CircularOrderByChance of_nearly = circular_order_chance(drawn({0, 1, 0,  //
                                                                       3, 0, 2,  //
                                                                       0, 4, 0}),
                                                                500, 3);
  EXPECT_EQ(of_nearly.share_as_high.around, 1.0);
}

// Growing and falling, the six orders around of four have 1 and 0.6; 0.6 and 1; twice 0.8 and 0.8;
// 0.8 and 0.4; 0.4 and 0.8. The better of both means, over the 36 pairs, adds up to 29.6; two of
// the pairs have 1.
TEST(CircularOrderByChance, ShufflesWithinGroups) {
  const Individuals right = drawn({8, 1, 5,  //
                                   4, 0, 2,  //
                                   7, 3, 6},
                                  kSidesAndCorners);
  const CircularOrderByChance by_chance = circular_order_chance(right, 20000, 4);
  EXPECT_NEAR(by_chance.mean.within, 29.6 / 36.0, 0.004);
  EXPECT_NEAR(by_chance.share_as_high.within, 2.0 / 36.0, 0.008);
}

TEST(CircularOrderByChance, CountsTheTrueOrderToo) {
  const Individuals right = drawn({1, 2, 3,  //
                                   8, 0, 4,  //
                                   7, 6, 5});
  EXPECT_DOUBLE_EQ(circular_order_chance(right, 9, 1).share_as_high.around, 0.1);
  const CircularOrderByChance none = circular_order_chance(right, 0, 1);
  EXPECT_EQ(none.mean.around, 0.0);
  EXPECT_EQ(none.mean.within, 0.0);
  EXPECT_EQ(none.share_as_high.around, 1.0);
  EXPECT_EQ(none.share_as_high.within, 1.0);
}

TEST(CircularOrderByChance, IsTheSameForASeed) {
  const Individuals individuals = drawn({1, 2, 3, 8, 0, 4, 7, 6, 5});
  EXPECT_EQ(circular_order_chance(individuals, 50, 1).mean.around,
            circular_order_chance(individuals, 50, 1).mean.around);
  EXPECT_NE(circular_order_chance(individuals, 50, 1).mean.around,
            circular_order_chance(individuals, 50, 2).mean.around);
}

// The slow way: angles of circles, every individual as a start, both directions walked.

Position centre_of(const Individuals& individuals) {
  Position centre;
  for (const MappedIndividual& individual : individuals) {
    centre.x += individual.position.x / static_cast<double>(individuals.size());
    centre.y += individual.position.y / static_cast<double>(individuals.size());
  }
  return centre;
}

// In millionths of a turn of 1 radian, from 0 to a full turn; nothing on a small map is closer.
double millionths(double turn) {
  const double full = 2.0 * std::numbers::pi;
  while (turn < -1e-7) turn += full;
  while (turn > full - 1e-7) turn -= full;
  return std::abs(std::round(1e6 * turn));
}

double slow_order(const Individuals& individuals, const Position& centre, double direction) {
  const auto angle_of = [&](const MappedIndividual& one) {
    return std::atan2(one.position.y - centre.y, one.position.x - centre.x);
  };
  Individuals around;
  Individuals at_centre;
  for (const MappedIndividual& one : individuals) {
    const double away = std::hypot(one.position.x - centre.x, one.position.y - centre.y);
    (away > 1e-7 ? around : at_centre).push_back(one);
  }
  if (around.empty()) return 0.0;
  Values numbers;
  for (const MappedIndividual& one : around) numbers.push_back(one.number);
  for (const MappedIndividual& one : at_centre) numbers.push_back(one.number);
  double best = -1.0;
  for (const MappedIndividual& start : around) {
    Values turns;
    for (const MappedIndividual& one : around) {
      turns.push_back(millionths(direction * (angle_of(one) - angle_of(start))));
    }
    Values places = ranks_of(turns);
    places.resize(numbers.size(), (static_cast<double>(around.size()) + 1.0) / 2.0);
    best = std::max(best, rank_correlation(numbers, places));
  }
  return best;
}

double slow_within(const Individuals& individuals, double direction) {
  double sum = 0.0;
  double groups = 0.0;
  for (std::size_t group = 0; group < 3; ++group) {
    Individuals members;
    std::set<double> numbers;
    for (const MappedIndividual& one : individuals) {
      if (one.group != group) continue;
      members.push_back(one);
      numbers.insert(one.number);
    }
    if (numbers.size() < 3) continue;
    sum += slow_order(members, centre_of(individuals), direction);
    groups += 1.0;
  }
  return groups > 0.0 ? sum / groups : 0.0;
}

// Few neurons, so that angles are shared and individuals stand at the centre.
Individuals random_individuals(Random& random) {
  const auto lattice = random.below(2) == 0 ? Lattice::kRectangular : Lattice::kHexagonal;
  const auto topology = random.below(2) == 0 ? Topology::kPlane : Topology::kTorus;
  const std::size_t rows = 2 * (1 + random.below(3));
  const Grid grid(rows, 1 + random.below(5), lattice, topology);
  const std::size_t count = 1 + random.below(12);
  Numbers winners;
  Numbers individuals;
  Numbers groups;
  Values numbers;
  for (std::size_t individual = 0; individual < count; ++individual) {
    numbers.push_back(static_cast<double>(random.below(8)));
    groups.push_back(random.below(3));
    for (std::size_t sample = 0; sample <= random.below(2); ++sample) {
      winners.push_back(random.below(grid.size()));
      individuals.push_back(individual);
    }
  }
  return mapped_individuals(grid, winners, individuals, numbers, groups);
}

TEST(CircularOrder, AgreesWithAnglesOfACircle) {
  Random random(21);
  int at_centre = 0;
  for (int run = 0; run < 1000; ++run) {
    const Individuals individuals = random_individuals(random);
    const Position centre = centre_of(individuals);
    for (const MappedIndividual& one : individuals) {
      const double away = std::hypot(one.position.x - centre.x, one.position.y - centre.y);
      at_centre += individuals.size() > 1 && away < 1e-7 ? 1 : 0;
    }
    const CircularOrder order = circular_order(individuals);
    EXPECT_NEAR(
        order.around,
        std::max(slow_order(individuals, centre, 1.0), slow_order(individuals, centre, -1.0)),
        1e-12)
        << run;
    EXPECT_NEAR(order.within,
                std::max(slow_within(individuals, 1.0), slow_within(individuals, -1.0)), 1e-12)
        << run;
  }
  EXPECT_GT(at_centre, 20);
}

}  // namespace
}  // namespace somato
