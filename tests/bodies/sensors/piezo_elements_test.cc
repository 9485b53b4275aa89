#include "bodies/sensors/piezo_elements.h"

#include <gtest/gtest.h>

#include <cmath>

#include "somato/core/random.h"

namespace somato::detail {
namespace {

TEST(PiezoElements, APiezoElementForgetsAStepOfForceInItsTime) {
  PiezoElements piezo(2, 0.1);
  const std::vector<double> forces{3.0, 0.0};
  double time = 0.0;
  for (int step = 0; step < 500; ++step) {
    piezo.step(forces, 0.001);
    time += 0.001;
    EXPECT_NEAR(piezo.signals()[0], 3.0 * std::exp(-time / 0.1), 0.03);
    EXPECT_EQ(piezo.signals()[1], 0.0);
  }
  piezo.step({0.0, 0.0}, 0.001);
  EXPECT_NEAR(piezo.signals()[0], 0.1 / 0.101 * (3.0 * std::exp(-5.0) - 3.0), 0.001);
}

TEST(PiezoElements, APiezoElementFollowsARampByItsSlopeTimesItsTime) {
  PiezoElements piezo(1, 0.05);
  for (int step = 1; step <= 1000; ++step) piezo.step({0.002 * step}, 0.001);  // 2 N/s
  EXPECT_NEAR(piezo.signals()[0], 2.0 * 0.05, 1e-6);
}

// Forces that change now and then, as they were in each step, and only their changes.
TEST(PiezoElements, StepsInWhichNothingChangesAreTheSameAllAtOnce) {
  Random random(5);
  for (const double time_constant : {0.001, 0.1, 10.0}) {
    PiezoElements each(1, time_constant);
    PiezoElements changes(1, time_constant);
    double force = 0.0;
    std::uint64_t still = 0;
    for (int step = 0; step < 3000; ++step) {
      const bool changes_now = random.uniform() < 0.05;
      if (changes_now) force = random.uniform() < 0.3 ? 0.0 : 5.0 * random.uniform();
      each.step({force}, 0.001);
      if (changes_now) {
        changes.advance(0, still, force, 0.001);
        still = 0;
      } else {
        ++still;
      }
    }
    changes.rest(0, still, 0.001);
    EXPECT_EQ(each.signals(), changes.signals());
    EXPECT_EQ(each.forces(), changes.forces());
  }
}

}  // namespace
}  // namespace somato::detail
