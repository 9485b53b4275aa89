#include "studies/sweep/sweep.h"

#include <gtest/gtest.h>

#include "studies/sweep/sweeps.h"

namespace somato {
namespace {

using test::kDraws;
using test::rate;
using test::read;
using test::sweep_toml;

TEST(Sweep, IsReadWithItsUnknownsInTheirOrder) {
  const auto sweep = read(sweep_toml("sobol", "points = 8\npairs = 3\nseed = 7\n" + kDraws +
                                                  rate("scale = 'logarithmic'\n") +
                                                  "[study]\nprotocols = ['leave_one_out']\n"));
  ASSERT_TRUE(sweep) << sweep.error().what;
  EXPECT_EQ(sweep->sweep.design, SweepDesign::kSobol);
  EXPECT_EQ(sweep->sweep.points, 8U);
  EXPECT_EQ(sweep->sweep.pairs, 3U);
  EXPECT_EQ(sweep->sweep.seed, 7U);
  ASSERT_EQ(sweep->unknowns.size(), 2U);
  EXPECT_EQ(sweep->unknowns[0].name, "draws");
  EXPECT_EQ(sweep->unknowns[0].where, "sweep.toml:6");
  EXPECT_EQ(sweep->unknowns[0].parameters.values.size(), 2U);
  EXPECT_EQ(sweep->unknowns[1].parameters.key,
            std::vector<std::string>{"module.map.learning_rate_start"});
  EXPECT_EQ(sweep->unknowns[1].parameters.scale, UnknownScale::kLogarithmic);
  ASSERT_EQ(sweep->changes.entries.size(), 1U);
  EXPECT_EQ(sweep->changes.entries[0].name, "study");
}

struct Refused {
  std::string toml;
  std::string where;
  std::string what;
};

TEST(Sweep, RefusesWhatIsNone) {
  const std::string head = "[unknown.rate]\nkey = 'module.map.rows'\n";
  const std::string text = "text = 'x'\n";
  const auto one = [&](const std::string& keys) {
    return sweep_toml("one_at_a_time", head + keys);
  };
  const std::vector<Refused> all{
      {rate(), "sweep.toml", "requires a design"},
      {"[sweep]\npairs = 2\n" + rate(), "sweep.toml:1", "requires a design"},
      {sweep_toml("sobl", rate()), "sweep.toml:2", "design"},
      {sweep_toml("sobol", "point = 3\n" + rate()), "sweep.toml:3", "point"},
      {sweep_toml("one_at_a_time", ""), "sweep.toml", "requires unknowns"},
      {sweep_toml("one_at_a_time", "[unknown]\n"), "sweep.toml:3", "requires unknowns"},
      {sweep_toml("one_at_a_time", "[unknown]\nrate = 3\n"), "sweep.toml:4", "must be a table"},
      {one(text + "vlaues = [1]\n"), "sweep.toml:6", "vlaues"},
      {one("values = [1]\n"), "sweep.toml:3", "does not explain its values"},
      {sweep_toml("one_at_a_time", "[unknown.rate]\ntext = 'x'\nvalues = [1]\n"), "sweep.toml:3",
       "has no key"},
      {one(text), "sweep.toml:3", "has no values"},
      {one(text + "values = []\n"), "sweep.toml:3", "has no values"},
      {one(text + "values = [1, 2, 1]\n"), "sweep.toml:3", "the value 1 twice"},
      {one(text + "values = [1]\nlow = 1\n"), "sweep.toml:3", "values and a range"},
      {one(text + "values = [1]\nhigh = 1\n"), "sweep.toml:3", "both 'values' and keys of a range"},
      {one(text + "values = [1]\nlevels = 3\n"), "sweep.toml:3",
       "both 'values' and keys of a range"},
      {one(text + "low = 1\n"), "sweep.toml:3", "has 'low', but no 'high'"},
      {one(text + "low = 2\nhigh = 2\n"), "sweep.toml:3", "empty range"},
      {one(text + "low = 0\nhigh = 2\nscale = 'logarithmic'\n"), "sweep.toml:3", "logarithmic"},
      {one(text + "low = -1e308\nhigh = 1e308\n"), "sweep.toml:3", "too wide"},
      {one(text + "low = 0\nhigh = 1e300\nwhole = true\n"), "sweep.toml:3", "too large"},
      {one(text + "low = 0.5\nhigh = 2\nwhole = true\n"), "sweep.toml:3", "requires integers"},
      {one(text + "low = 1\nhigh = 3\nwhole = true\nlevels = 4\n"), "sweep.toml:3", "more levels"},
      {one(text + "low = 1\nhigh = 5\nwhole = true\nscale = 'logarithmic'\n"), "sweep.toml:3",
       "the level 1 twice"},
      {one(text + "values = [1]\n[unknown.again]\nkey = 'module.map.rows'\ntext = 'x'\nvalues = "
                  "[2]\n"),
       "sweep.toml:7", "already varied"},
      {one(text + "values = [1]\nsystems = ['a', 'b']\n[unknown.again]\nkey = 'module.map.rows'\n"
                  "text = 'x'\nvalues = [2]\nsystems = ['b']\n"),
       "sweep.toml:8", "already varied"},
      {one(text + "values = [1]\nincreasing = 'a'\n"), "sweep.toml:3", "has levels"},
      {sweep_toml("sobol",
                  "points = 8\n[unknown.a]\nkey = 'module.map.a'\ntext = 'x'\nvalues = "
                  "[1, 2]\nincreasing = 'a'\n[unknown.b]\nkey = 'module.map.b'\ntext = "
                  "'x'\nvalues = [1]\nincreasing = 'a'\n"),
       "sweep.toml:9", "more or fewer values"},
      {sweep_toml("one_at_a_time", "recordings = 3\nstock = 2\n" + rate()), "sweep.toml:1",
       "fewer recordings than a point"},
      {sweep_toml("sobol", rate()), "sweep.toml:1", "requires 'points'"},
      {sweep_toml("latin_hypercube", rate()), "sweep.toml:1", "requires 'points'"},
      {sweep_toml("full_factorial", "points = 8\n" + rate()), "sweep.toml:1",
       "follow from its levels"}};
  for (const Refused& refused : all) {
    const auto sweep = read(refused.toml);
    ASSERT_FALSE(sweep) << refused.toml;
    EXPECT_EQ(sweep.error().kind, ErrorKind::kUsage);
    EXPECT_EQ(sweep.error().where.substr(0, refused.where.size()), refused.where) << refused.toml;
    EXPECT_NE(sweep.error().what.find(refused.what), std::string::npos) << sweep.error().what;
  }
}

TEST(Sweep, AKeyMayHaveAnUnknownForEachSystem) {
  const std::string of = "key = 'explore.simulation.placement_noise'\ntext = 'x'\nvalues = [0.5]\n";
  const auto sweep = read(sweep_toml("one_at_a_time", "stock = 3\n[unknown.a]\n" + of +
                                                          "systems = ['one']\n[unknown.b]\n" + of +
                                                          "systems = ['two', 'three']\n"));
  ASSERT_TRUE(sweep) << to_string(sweep.error());
  EXPECT_EQ(sweep->sweep.stock, 3U);
  EXPECT_TRUE(sweep->unknowns[1].parameters.is_of("three"));
  EXPECT_FALSE(sweep->unknowns[1].parameters.is_of("one"));
}

TEST(Sweep, RefusesMorePointsOrDimensionsThanThereAre) {
  std::string many;
  for (int i = 0; i < 33; ++i) {
    many += "[unknown.u" + std::to_string(i) + "]\nkey = 'module.map.k" + std::to_string(i) +
            "'\ntext = 'x'\nlow = 0\nhigh = 1\n";
  }
  const auto sobol = read(sweep_toml("sobol", "points = 4\n" + many));
  ASSERT_FALSE(sobol);
  EXPECT_NE(sobol.error().what.find("at most 32 unknowns"), std::string::npos);
  EXPECT_TRUE(read(sweep_toml("latin_hypercube", "points = 4\n" + many)));
  const auto factorial = read(sweep_toml("full_factorial", many));
  ASSERT_FALSE(factorial);
  EXPECT_NE(factorial.error().what.find("more than 1048576 points"), std::string::npos);
}

}  // namespace
}  // namespace somato
