#include "studies/lifelong/touch_order.h"

#include <gtest/gtest.h>

#include "somato/core/random.h"

namespace somato {
namespace {

// Four objects in four poses: the first two poses do not distinguish them, the third whether the
// object is one of the first two, the fourth which of a pair it is. Of four pairs of values, each
// is enough.
Recording informative_poses(std::size_t trials, std::uint64_t seed) {
  Random random(seed);
  Recording recording;
  for (std::size_t object = 0; object < 4; ++object) {
    for (std::size_t trial = 0; trial < trials; ++trial) {
      Matrix<float> wrist(4, 1);
      Matrix<float> joints(4, 2);
      for (std::size_t pose = 0; pose < 4; ++pose) {
        wrist(pose, 0) = static_cast<float>(10 * pose);
        const std::size_t side = pose == 2 ? object / 2 : pose == 3 ? object % 2 : 0;
        joints(pose, 0) = static_cast<float>(100.0 * static_cast<double>(side) + random.uniform());
        joints(pose, 1) = static_cast<float>(100.0 * static_cast<double>(side) + random.uniform());
      }
      recording.explorations.push_back({{{"object", "object " + std::to_string(object)}},
                                        {},
                                        {{"wrist", "deg", {}, std::move(wrist), {}},
                                         {"joints", "deg", {}, std::move(joints), {}}}});
    }
  }
  return recording;
}

TouchOrderParameters small_parameters() {
  TouchOrderParameters parameters;
  parameters.pose = {"wrist"};
  parameters.channels = {"joints"};
  parameters.rows = 3;
  parameters.columns = 3;
  parameters.iterations = 200;
  parameters.folds = 4;
  parameters.certainty = 0.6;
  parameters.seeds = 3;
  return parameters;
}

TEST(TouchOrder, TheChosenGraspsAreInformative) {
  const auto orders = compare_touch_orders(informative_poses(16, 1), small_parameters());
  ASSERT_TRUE(orders) << to_string(orders.error());
  EXPECT_EQ(orders->explorations, 64U);
  EXPECT_EQ(orders->classes, 4U);
  EXPECT_EQ(orders->grasps, 4U);
  ASSERT_EQ(orders->orders.size(), 3U);
  const TouchOrderResult& chosen = orders->orders[0];
  const TouchOrderResult& fixed = orders->orders[1];
  const TouchOrderResult& random = orders->orders[2];
  EXPECT_GT(chosen.accuracy[1].mean(), 0.85);
  EXPECT_LT(fixed.accuracy[1].mean(), 0.5) << "two poses without information: 0.25 by chance";
  EXPECT_LT(random.accuracy[1].mean(), chosen.accuracy[1].mean());
  EXPECT_LT(chosen.stopped_grasps.mean(), fixed.stopped_grasps.mean() - 0.5);
  for (const TouchOrderResult& order : orders->orders) {
    EXPECT_EQ(order.accuracy[0].values.size(), 3U);
    EXPECT_EQ(order.accuracy[3].values, chosen.accuracy[3].values) << "all grasps, in any order";
  }
}

TEST(TouchOrder, IsTheSameForAnyNumberOfThreads) {
  const Recording recording = informative_poses(8, 2);
  const auto one = compare_touch_orders(recording, small_parameters(), {}, 1);
  const auto two = compare_touch_orders(recording, small_parameters(), {}, 2);
  ASSERT_TRUE(one && two);
  for (std::size_t order = 0; order < 3; ++order) {
    for (std::size_t grasp = 0; grasp < 4; ++grasp) {
      EXPECT_EQ(one->orders[order].certainty[grasp].values,
                two->orders[order].certainty[grasp].values);
    }
    EXPECT_EQ(one->orders[order].stopped_grasps.values, two->orders[order].stopped_grasps.values);
  }
}

TEST(TouchOrder, RefusesWhatCannotBeCompared) {
  const Recording recording = informative_poses(2, 3);
  const auto refused = [&](const auto& change, ErrorKind kind) {
    TouchOrderParameters parameters = small_parameters();
    change(parameters);
    const auto orders = compare_touch_orders(recording, parameters);
    ASSERT_FALSE(orders);
    EXPECT_EQ(orders.error().kind, kind);
  };
  refused([](TouchOrderParameters& p) { p.label = "thing"; }, ErrorKind::kUsage);
  refused([](TouchOrderParameters& p) { p.pose = {"wirst"}; }, ErrorKind::kUsage);
  refused([](TouchOrderParameters& p) { p.pose_tolerance = 100; }, ErrorKind::kData);
  refused([](TouchOrderParameters& p) { p.folds = 5; }, ErrorKind::kData);
}

TEST(TouchOrder, StopsOnRequest) {
  const auto orders = compare_touch_orders(informative_poses(4, 3), small_parameters(),
                                           [](std::uint64_t, std::uint64_t) { return false; });
  ASSERT_FALSE(orders);
  EXPECT_EQ(orders.error().kind, ErrorKind::kInterrupted);
}

}  // namespace
}  // namespace somato
