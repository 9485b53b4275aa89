#include "recordings/file/rollover.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

TEST(Rollover, NamesAFileByTheTimeAtWhichItBegins) {
  EXPECT_EQ(path_at("a/touch_{time}.mcap", 0.9), "a/touch_1970-01-01T00-00-00Z.mcap");
  EXPECT_EQ(path_at("{time}", 951827696.0), "2000-02-29T12-34-56Z");
  EXPECT_EQ(path_at("{time}.mcap", 0.0, 2), "1970-01-01T00-00-00Z-2.mcap");
  EXPECT_EQ(path_at("touch.mcap", 0.0, 2), "touch.mcap");
}

TEST(Rollover, IsDueByTimeOrSize) {
  double now = 100.0;
  Rollover rollover;
  rollover.now = [&] { return now; };
  EXPECT_FALSE(rollover.is_due(-1e9, std::size_t{1} << 40));
  rollover.every = 60.0;
  EXPECT_FALSE(rollover.is_due(41.0, 0));
  EXPECT_TRUE(rollover.is_due(40.0, 0));
  rollover.bytes = 1000;
  EXPECT_TRUE(rollover.is_due(41.0, 1000));
  EXPECT_FALSE(rollover.is_due(41.0, 999));
}

}  // namespace
}  // namespace somato
