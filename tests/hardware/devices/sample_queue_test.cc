#include "hardware/devices/sample_queue.h"

#include <gtest/gtest.h>

#include <array>

#include "somato/core/check.h"

namespace somato::devices {
namespace {

TEST(SampleQueue, JoinsBytesThatArriveApart) {
  SampleQueue queue(8);
  queue.receive(std::array<std::uint8_t, 1>{0x34});
  EXPECT_EQ(queue.size(), 0U);
  queue.receive(std::array<std::uint8_t, 4>{0x12, 0xFF, 0xFF, 0x00});
  queue.receive(std::array<std::uint8_t, 1>{0x80});
  std::array<float, 3> taken{};
  queue.take(taken);
  EXPECT_EQ(taken, (std::array<float, 3>{4660.0F, -1.0F, -32768.0F}));
  EXPECT_EQ(queue.size(), 0U);
}

TEST(SampleQueue, DiscardsTheOldestWhenItIsFull) {
  SampleQueue queue(2);
  queue.receive(std::array<std::uint8_t, 6>{1, 0, 2, 0, 3, 0});
  std::array<float, 2> taken{};
  queue.take(taken);
  EXPECT_EQ(taken, (std::array<float, 2>{2.0F, 3.0F}));
}

TEST(SampleQueue, KeepsTheOldest) {
  SampleQueue queue(4);
  queue.receive(std::array<std::uint8_t, 6>{1, 0, 2, 0, 3, 0});
  queue.keep_oldest(5);
  EXPECT_EQ(queue.size(), 3U);
  queue.keep_oldest(1);
  EXPECT_EQ(queue.size(), 1U);
  std::array<float, 1> taken{};
  queue.take(taken);
  EXPECT_EQ(taken[0], 1.0F);
}

TEST(SampleQueue, KeepsTheNewest) {
  SampleQueue queue(4);
  queue.receive(std::array<std::uint8_t, 6>{1, 0, 2, 0, 3, 0});
  queue.keep(1);
  std::array<float, 1> taken{};
  queue.take(taken);
  EXPECT_EQ(taken[0], 3.0F);
  EXPECT_THROW(queue.take(taken), InvalidArgument);
}

}  // namespace
}  // namespace somato::devices
