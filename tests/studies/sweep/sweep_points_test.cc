#include "studies/sweep/sweep_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "studies/sweep/sweeps.h"

namespace somato {
namespace {

using test::kDraws;
using test::rate;
using test::read;
using test::sweep_toml;

double number(const Value& value) {
  return std::get<double>(value.content);
}

std::int64_t whole(const Value& value) {
  return std::get<std::int64_t>(value.content);
}

TEST(SweepPoints, OneAtATimeStartsWithTheSystemAsItStands) {
  const auto sweep = read(sweep_toml("one_at_a_time", rate("levels = 3\n") + kDraws)).value();
  const auto points = sweep_points(sweep);
  ASSERT_EQ(points.size(), 6U);
  EXPECT_EQ(point_count(sweep), 6U);
  EXPECT_FALSE(points[0][0]);
  EXPECT_FALSE(points[0][1]);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_DOUBLE_EQ(number(points[1 + i][0]->value), 0.1 + 0.4 * static_cast<double>(i));
    EXPECT_EQ(points[1 + i][0]->cell, i);
    EXPECT_FALSE(points[1 + i][1]);
  }
  EXPECT_FALSE(points[4][0]);
  EXPECT_EQ(points[4][1]->value, Value{"with_replacement"});
  EXPECT_EQ(points[5][1]->value, Value{"without_replacement"});
}

TEST(SweepPoints, TheEndsOfARangeAreExactAndRatiosAreEqualOnALogarithmicScale) {
  const auto sweep =
      read(sweep_toml("full_factorial",
                      "[unknown.a]\nkey='module.map.a'\ntext='x'\nlow=0.001\nhigh=0.7\nlevels = 4\n"
                      "scale='logarithmic'\n" +
                          kDraws))
          .value();
  const auto points = sweep_points(sweep);
  ASSERT_EQ(points.size(), 8U);
  EXPECT_EQ(number(points[0][0]->value), 0.001);
  EXPECT_EQ(number(points[7][0]->value), 0.7);
  const double ratio = std::cbrt(700.0);
  EXPECT_NEAR(number(points[2][0]->value), 0.001 * ratio, 1e-12);
  EXPECT_NEAR(number(points[5][0]->value), 0.001 * ratio * ratio, 1e-12);
}

TEST(SweepPoints, FiveLevelsUnlessTheyAreGivenOrFewerWholeNumbers) {
  const auto count = [](const std::string& keys) {
    return point_count(read(sweep_toml("full_factorial",
                                       "[unknown.a]\nkey='module.map.a'\n"
                                       "text='x'\n" +
                                           keys))
                           .value());
  };
  EXPECT_EQ(count("low = 1.5\nhigh = 2\n"), 5U);
  EXPECT_EQ(count("low = 1\nhigh = 100\nwhole = true\n"), 5U);
  EXPECT_EQ(count("low = 1\nhigh = 3\nwhole = true\n"), 3U);
  EXPECT_EQ(count("low = 1\nhigh = 100\nlevels = 9\n"), 9U);
}

// Each whole number and each value is as frequent as any other, and each cell.
TEST(SweepPoints, SobolPointsCoverWholeNumbersValuesAndCellsEvenly) {
  const auto sweep = read(sweep_toml("sobol",
                                     "points = 256\n[unknown.rows]\nkey='module.map.rows'\n"
                                     "text='x'\nlow=3\nhigh=6\nwhole=true\n" +
                                         kDraws + rate()))
                         .value();
  std::map<std::int64_t, int> rows;
  std::map<std::string, int> draws;
  std::map<std::size_t, int> cells;
  for (const SweepPoint& point : sweep_points(sweep)) {
    ++rows[whole(point[0]->value)];
    EXPECT_EQ(point[0]->cell, static_cast<std::size_t>(whole(point[0]->value) - 3));
    ++draws[to_toml(point[1]->value)];
    ++cells[point[2]->cell];
    const double value = number(point[2]->value);
    const SweepCell cell = sweep_cells(sweep, sweep.unknowns[2])[point[2]->cell];
    EXPECT_GE(value, number(cell.from));
    EXPECT_LE(value, number(cell.to));
  }
  EXPECT_EQ(rows, (std::map<std::int64_t, int>{{3, 64}, {4, 64}, {5, 64}, {6, 64}}));
  EXPECT_EQ(draws.size(), 2U);
  for (const auto& [name, count] : draws) EXPECT_EQ(count, 128) << name;
  EXPECT_EQ(cells.size(), 8U);
  for (const auto& [cell, count] : cells) EXPECT_EQ(count, 32) << cell;
}

TEST(SweepPoints, MoreSobolPointsAreTheSameAndOthers) {
  const auto few = sweep_points(read(sweep_toml("sobol", "points = 8\n" + rate())).value());
  const auto many = sweep_points(read(sweep_toml("sobol", "points = 32\n" + rate())).value());
  for (std::size_t i = 0; i < few.size(); ++i) EXPECT_EQ(few[i][0]->value, many[i][0]->value);
}

TEST(SweepPoints, ALatinHypercubeFollowsItsSeed) {
  const auto points = [](const std::string& seed) {
    std::vector<double> rates;
    const std::string toml =
        sweep_toml("latin_hypercube", "points = 10\nseed = " + seed + "\n" + rate());
    for (const SweepPoint& point : sweep_points(read(toml).value())) {
      rates.push_back(number(point[0]->value));
    }
    return rates;
  };
  EXPECT_EQ(points("1"), points("1"));
  EXPECT_NE(points("1"), points("2"));
  std::vector<double> sorted = points("1");
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_EQ(std::floor((sorted[i] - 0.1) / 0.08), static_cast<double>(i));
  }
}

TEST(SweepCells, TogetherAreTheRange) {
  const auto sweep = read(sweep_toml("sobol", "points = 20\n" + rate("scale = 'logarithmic'\n") +
                                                  "[unknown.rows]\nkey='module.map.rows'\n"
                                                  "text='x'\nlow=2\nhigh=11\nwhole=true\n"))
                         .value();
  const auto rates = sweep_cells(sweep, sweep.unknowns[0]);
  ASSERT_EQ(rates.size(), 4U);  // the square root of 20
  EXPECT_EQ(number(rates[0].from), 0.1);
  EXPECT_NEAR(number(rates[1].to), 0.3, 1e-12);  // the middle of 0.1 and 0.9 by ratio
  EXPECT_EQ(number(rates[3].to), 0.9);
  const auto rows = sweep_cells(sweep, sweep.unknowns[1]);  // 10 numbers in 4 parts of 2.5
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_EQ(whole(rows[0].from), 2);
  EXPECT_EQ(whole(rows[0].to), 4);
  EXPECT_EQ(whole(rows[2].from), 7);
  EXPECT_EQ(whole(rows[3].to), 11);
}

TEST(PlaceInRange, IsOnItsScale) {
  UnknownParameters linear;
  linear.low = 1.0;
  linear.high = 5.0;
  EXPECT_EQ(place_in_range(linear, 2.0), 0.25);
  EXPECT_FALSE(place_in_range(linear, 5.1));
  EXPECT_FALSE(place_in_range(linear, 0.9));
  UnknownParameters ratio;
  ratio.low = 1.0;
  ratio.high = 100.0;
  ratio.scale = UnknownScale::kLogarithmic;
  EXPECT_NEAR(*place_in_range(ratio, 10.0), 0.5, 1e-12);
  EXPECT_FALSE(place_in_range(UnknownParameters{}, 1.0));
}

// Lists of the same length, the second one later by two.
const std::string kIncreasing =
    "[unknown.small]\nkey='module.map.a'\ntext='x'\nvalues=[1, 2, 3]\nincreasing='sizes'\n"
    "[unknown.rate]\nkey='module.map.b'\ntext='x'\nlow=0.0\nhigh=1.0\n"
    "[unknown.large]\nkey='module.map.c'\ntext='x'\nvalues=[3, 4, 5]\nincreasing='sizes'\n";

TEST(SweepPoints, IncreasingUnknownsShareTheirPlacesInAscendingOrder) {
  const auto sweep = read(sweep_toml("sobol", "points = 64\n" + kIncreasing)).value();
  const SweepPoint point = point_at(sweep, {0.9, 0.25, 0.1});
  EXPECT_EQ(whole(point[0]->value), 1);
  EXPECT_EQ(number(point[1]->value), 0.25);
  EXPECT_EQ(whole(point[2]->value), 5);
  EXPECT_EQ(point_at(sweep, {0.1, 0.25, 0.9})[2]->value, point[2]->value);
  EXPECT_EQ(whole(place_at(sweep, sweep.unknowns[0], 0.9).value), 3) << "a place of one unknown";
  // Three of the nine pairs of places are equal, and each other pair is that of two.
  std::map<std::pair<std::int64_t, std::int64_t>, int> seen;
  for (const SweepPoint& one : sweep_points(sweep)) {
    const std::pair sizes{whole(one[0]->value), whole(one[2]->value)};
    EXPECT_GE(sizes.second, sizes.first + 2);
    ++seen[sizes];
  }
  EXPECT_EQ(seen.size(), 6U);
  EXPECT_NEAR(seen.at({1, 5}), 64 * 2 / 9.0, 3.0);
  EXPECT_NEAR(seen.at({2, 4}), 64 / 9.0, 3.0);
}

}  // namespace
}  // namespace somato
