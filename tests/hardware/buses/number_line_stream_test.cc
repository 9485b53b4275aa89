#include "hardware/buses/number_line_stream.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string_view>

namespace somato::devices {
namespace {

TEST(NumberLineStream, ShowsItsLines) {
  constexpr std::string_view kText = "\nleft:1,right:2\n1;2;3\n";
  NumberLineStream stream(2, {{"right", 0}, {"left", 1}});
  stream.receive({reinterpret_cast<const std::uint8_t*>(kText.data()), kText.size()}, 3.0);
  EXPECT_EQ(stream.values()[0], 2.0F);
  EXPECT_EQ(stream.last_line(), "1;2;3");
  EXPECT_EQ(stream.complaint(), "the last line was '1;2;3': 3 fields instead of 2");
}

TEST(NumberLineStream, CountsFramesAndRejectedLines) {
  constexpr std::string_view kNumbers = "ready\n1,2\n3\n4,5\r\n6,";
  NumberLineStream stream(2);
  stream.receive({reinterpret_cast<const std::uint8_t*>(kNumbers.data()), kNumbers.size()}, 3.0);
  EXPECT_EQ(stream.frames(), 2U);
  EXPECT_EQ(stream.rejected(), 1U);
  EXPECT_EQ(stream.values()[1], 5.0F);
  EXPECT_EQ(stream.time(), 3.0);
  EXPECT_EQ(stream.device_time(), std::nullopt);
}

}  // namespace
}  // namespace somato::devices
