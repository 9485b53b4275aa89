#include "hardware/lines/receive_buffer.h"

#include <gtest/gtest.h>

#include <vector>

namespace somato::wire {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes bytes_of(const ReceiveBuffer<4>& buffer) {
  return {buffer.bytes().begin(), buffer.bytes().end()};
}

TEST(ReceiveBuffer, KeepsTheOrderAndDiscardsTheOldest) {
  ReceiveBuffer<4> buffer;
  EXPECT_EQ(buffer.put(Bytes{1, 2, 3}), 0U);
  EXPECT_EQ(buffer.put(Bytes{4, 5}), 1U);
  EXPECT_EQ(bytes_of(buffer), (Bytes{2, 3, 4, 5}));
  buffer.drop(3);
  EXPECT_EQ(bytes_of(buffer), (Bytes{5}));
  buffer.drop(9);
  EXPECT_EQ(bytes_of(buffer), Bytes{});
}

TEST(ReceiveBuffer, TakesTheEndOfWhatIsLongerThanItself) {
  ReceiveBuffer<4> buffer;
  buffer.put(Bytes{9});
  EXPECT_EQ(buffer.put(Bytes{1, 2, 3, 4, 5, 6}), 3U);
  EXPECT_EQ(bytes_of(buffer), (Bytes{3, 4, 5, 6}));
  buffer.clear();
  EXPECT_EQ(bytes_of(buffer), Bytes{});
}

}  // namespace
}  // namespace somato::wire
