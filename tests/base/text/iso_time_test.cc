#include "base/text/iso_time.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

// 2025-04-17T17:00:08Z, as `date -u -d 2025-04-17T17:00:08Z +%s` prints it.
constexpr std::int64_t kAfternoon = 1744909208;

IsoTime read(const char* text) {
  const auto time = read_iso_time(text);
  EXPECT_TRUE(time) << text;
  return time.value_or(IsoTime{});
}

TEST(IsoTime, HasADateAndATimeOfDay) {
  for (const char* text : {"2025-04-17T17:00:08", "2025-04-17 17:00:08", "2025-04-17t17:00:08",
                           "20250417T170008", " 2025-04-17T17:00:08 "}) {
    EXPECT_EQ(read(text), (IsoTime{kAfternoon, 0.0, true, false})) << text;
  }
  EXPECT_EQ(read("2025-04-17"), (IsoTime{1744848000, 0.0, true, false}));
  EXPECT_EQ(read("2025-04-17T17:00"), (IsoTime{kAfternoon - 8, 0.0, true, false}));
  EXPECT_EQ(read("1969-12-31T23:59:59"), (IsoTime{-1, 0.0, true, false}));
  EXPECT_EQ(read("2024-02-29").seconds + 86400, read("2024-03-01").seconds);
  EXPECT_EQ(read("2024-12-31T24:00:00").seconds, read("2025-01-01").seconds);
  EXPECT_EQ(read("2016-12-31T23:59:60").seconds, read("2017-01-01").seconds) << "a leap second";
}

TEST(IsoTime, HasAFractionAfterAPointOrAComma) {
  EXPECT_EQ(read("2025-04-17T17:00:08.01"), (IsoTime{kAfternoon, 0.01, true, false}));
  EXPECT_EQ(read("2025-04-17 17:00:08,250"), (IsoTime{kAfternoon, 0.25, true, false}));
  EXPECT_EQ(read("20250417T170008.123456789Z").fraction, 0.123456789);
}

TEST(IsoTime, IsInUtcIfItsZoneIsKnown) {
  for (const char* text :
       {"2025-04-17T17:00:08Z", "2025-04-17T17:00:08z", "2025-04-17T19:00:08+02:00",
        "2025-04-17 19:00:08+0200", "2025-04-17 19:00:08 +02", "2025-04-17T12:30:08-04:30",
        "2025-04-18T03:00:08+10:00"}) {
    EXPECT_EQ(read(text), (IsoTime{kAfternoon, 0.0, true, true})) << text;
  }
}

TEST(IsoTime, MayBeATimeOfDay) {
  EXPECT_EQ(read("10:30:25.5"), (IsoTime{37825, 0.5, false, false}));
  EXPECT_EQ(read("T103025"), (IsoTime{37825, 0.0, false, false}));
  EXPECT_EQ(read("10:30Z"), (IsoTime{37800, 0.0, false, true}));
}

TEST(IsoTime, IsNoOtherText) {
  for (const char* text : {"",
                           "T",
                           "2025",
                           "2025-4-17",
                           "2025-04",
                           "17.04.2025",
                           "04/17/2025",
                           "2025/04/17",
                           "2025-13-01",
                           "2025-00-10",
                           "2025-02-29",
                           "2025-04-31",
                           "2025-04-17T",
                           "2025-04-17T17",
                           "2025-04-17  17:00",
                           "2025-04-17T25:00",
                           "2025-04-17T24:00:01",
                           "2025-04-17T17:60",
                           "2025-04-17T17:00:61",
                           "2025-04-17T17:00:08.",
                           "2025-04-17T17:00:08.x",
                           "2025-04-17T17:00:08+24:00",
                           "2025-04-17T17:00:08+2",
                           "2025-04-17T17:00:08+02:",
                           "2025-04-17T17:00:08 CEST",
                           "2025-04-17T17:00:08Zx",
                           "20250417 170008",
                           "1713373208",
                           "103025",
                           "0.25",
                           "10:30:25 PM",
                           "2025-04-17_17:00:08"}) {
    EXPECT_FALSE(read_iso_time(text)) << text;
  }
}

}  // namespace
}  // namespace somato
