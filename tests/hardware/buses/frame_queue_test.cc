#include "hardware/buses/frame_queue.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>

#include "somato/core/check.h"

namespace somato::devices {
namespace {

struct Taken {
  Matrix<float> values;
  std::vector<double> times;
};

Taken take(FrameQueue& queue, double end) {
  Taken taken;
  queue.take(end, taken.values, taken.times);
  return taken;
}

void add(FrameQueue& queue, float value, double now, std::optional<double> device_time = {}) {
  queue.add(std::vector<float>{value, -value}, now, device_time);
}

TEST(FrameQueue, GivesEachFrameOnceWithTheTimeOfItsArrival) {
  FrameQueue queue(2);
  queue.begin(10.0);
  add(queue, 1.0F, 10.0);
  add(queue, 2.0F, 10.5);
  add(queue, 3.0F, 11.5);
  const Taken first = take(queue, 11.0);
  EXPECT_EQ(first.values, Matrix<float>(2, 2, {1, -1, 2, -2}));
  EXPECT_EQ(first.times, (std::vector<double>{10.0, 10.5}));
  EXPECT_EQ(take(queue, 11.0).values, Matrix<float>(0, 2));
  const Taken second = take(queue, 12.0);
  EXPECT_EQ(second.values, Matrix<float>(1, 2, {3, -3}));
  EXPECT_EQ(second.times, std::vector<double>{11.5});
}

TEST(FrameQueue, KeepsNoneUntilItBeginsAndNoneFromBefore) {
  FrameQueue queue(2);
  add(queue, 1.0F, 1.0);
  queue.begin(2.0);
  add(queue, 2.0F, 2.5);
  queue.begin(3.0);
  // It was measured at 2.9, before the queue began again.
  add(queue, 3.0F, 3.0, 100.0);
  add(queue, 4.0F, 3.2, 100.1);
  add(queue, 5.0F, 3.2, 100.2);
  const Taken taken = take(queue, 4.0);
  EXPECT_EQ(taken.values, Matrix<float>(3, 2, {3, -3, 4, -4, 5, -5}));
  queue.begin(5.0);
  add(queue, 6.0F, 5.05, 101.9);
  add(queue, 7.0F, 5.05, 102.05);
  EXPECT_EQ(take(queue, 6.0).values, Matrix<float>(1, 2, {7, -7}));
}

// Frames of 1 kHz that arrive in blocks of ten, as through a USB converter.
TEST(FrameQueue, FramesThatArriveTogetherHaveTheDistancesOfTheBoardsClock) {
  for (const double board_seconds : {1.0, 0.995, 1.005}) {  // per second of the host
    FrameQueue queue(2);
    queue.begin(0.0);
    for (int i = 1; i <= 2000; ++i) {
      const double sampled = 0.001 * i;
      const double arrives = 0.01 * std::ceil(sampled / 0.01 - 1e-9);
      add(queue, static_cast<float>(i), arrives, 50.0 + board_seconds * sampled);
    }
    const Taken taken = take(queue, 2.0);
    ASSERT_EQ(taken.times.size(), 2000U);
    for (std::size_t i = 0; i < taken.times.size(); ++i) {
      // The first block is only known to have arrived at once.
      if (i < 20) continue;
      EXPECT_NEAR(taken.times[i], 0.001 * static_cast<double>(i + 1), 0.0003) << board_seconds;
    }
  }
}

TEST(FrameQueue, TimesNeverGoBackWhenABoardRestarts) {
  FrameQueue queue(2);
  queue.begin(0.0);
  add(queue, 1.0F, 1.0, 500.0);
  add(queue, 2.0F, 2.0, 501.0);
  add(queue, 3.0F, 3.0, 0.25);
  add(queue, 4.0F, 4.0, 1.25);
  EXPECT_EQ(take(queue, 9.0).times, (std::vector<double>{1.0, 2.0, 3.0, 4.0}));
}

}  // namespace
}  // namespace somato::devices
