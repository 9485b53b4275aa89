#include "hardware/devices/sample_clock.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace somato::devices {
namespace {

// Blocks of 125 ms, as ALSA's recorder writes them, at another rate than was requested.
struct Blocks {
  double rate = 16000.0;
  double begin = 0.3;       // The device starts,
  double end = 2.3;         // and is watched so long.
  double lost = 0.0;        // s of sound that are lost
  double lost_at = 1.0;     // at that time.
  double delayed = 0.0;     // s by which the host is held up
  double delayed_at = 1.0;  // at that time.
};

SampleClock measured(const Blocks& blocks, const char* source = "alsa:hw:1,0", double clock = 1.0) {
  constexpr double kBlock = 0.125;
  SampleClock sound({source, 16000.0}, clock);
  for (double time = blocks.begin + kBlock; time < blocks.end; time += kBlock) {
    const bool is_lost = time > blocks.lost_at && time <= blocks.lost_at + blocks.lost;
    const bool is_late = time > blocks.delayed_at && time <= blocks.delayed_at + blocks.delayed;
    const double arrival = is_late ? blocks.delayed_at + blocks.delayed : time;
    if (!is_lost) sound.add(static_cast<std::size_t>(std::lround(kBlock * blocks.rate)), arrival);
  }
  return sound;
}

TEST(SampleClock, MeasuresTheRateFromTheFirstBlockOn) {
  EXPECT_NEAR(measured({}).rate(), 16000.0, 1.0);
  EXPECT_NEAR(measured({.rate = 44100.0}).rate(), 44100.0, 10.0);
  EXPECT_TRUE(measured({}).check());
  EXPECT_TRUE(measured({}).check_all());
}

TEST(SampleClock, AllowsForClocksThatDifferALittle) {
  for (const double rate : {15950.0, 16050.0}) {
    EXPECT_TRUE(measured({.rate = rate, .end = 10.0}).check_all()) << rate;
  }
  EXPECT_TRUE(measured({.rate = 16016.0, .end = 600.0}).check_all());
}

TEST(SampleClock, NamesTheRateAndWhatToDo) {
  const auto more = measured({.rate = 44000.0}).check_all();
  ASSERT_FALSE(more);
  EXPECT_EQ(more.error().what, "the microphone gave 44000 samples per second, not 16000");
  EXPECT_EQ(more.error().where, "alsa:hw:1,0");
  EXPECT_EQ(more.error().advice,
            "set rate = 44100 of [microphone], or use source = \"alsa:plughw:1,0\", which converts "
            "the rate");
  const auto fewer = measured({.rate = 8000.0}, "raw:pipe").check_all();
  ASSERT_FALSE(fewer);
  EXPECT_EQ(fewer.error().what, "the microphone gave 8000 samples per second, not 16000");
  EXPECT_EQ(fewer.error().advice, "set rate = 8000 of [microphone]");
  for (const double rate : {17408.0, 14400.0}) EXPECT_FALSE(measured({.rate = rate}).check_rate());
  for (const double rate : {15900.0, 16100.0}) EXPECT_TRUE(measured({.rate = rate}).check_rate());
}

// Without waiting for the end.
TEST(SampleClock, NoticesAnotherRateWithinSeconds) {
  EXPECT_FALSE(measured({.rate = 44100.0, .end = 2.0}).check());
  EXPECT_FALSE(measured({.rate = 8000.0, .end = 2.0}).check());
  EXPECT_FALSE(measured({.rate = 17416.0, .end = 8.0}).check());  // 48 kHz for 44.1
}

TEST(SampleClock, NoticesLostSamplesHoweverLongItRecords) {
  const auto lost = measured({.end = 602.0, .lost = 0.25, .lost_at = 600.0}).check();
  ASSERT_FALSE(lost);
  EXPECT_EQ(lost.error().what, "the microphone lost 0.25 s of sound");
  EXPECT_FALSE(measured({.lost = 0.25, .lost_at = 0.5}).check());
  // At the end there is no time to see whether they are only late.
  EXPECT_TRUE(measured({.lost = 0.25, .lost_at = 1.8}).check());
  EXPECT_FALSE(measured({.lost = 0.25, .lost_at = 1.8}).check_all());
}

// A sound device whose latency shrinks from 0.3 s while it runs gives more samples, and no others.
TEST(SampleClock, AllowsForALatencyThatEnds) {
  SampleClock sound({"alsa:default", 16000.0}, 1.0);
  std::size_t given = 0;
  for (double now = 0.4; now < 6.0; now += 0.01) {
    const double latency = std::max(0.01, 0.3 - 0.1 * now);
    const auto due = static_cast<std::size_t>(16000.0 * (now - latency));
    sound.add(due - given, now);
    given = due;
    ASSERT_TRUE(sound.check_all()) << now;
  }
  EXPECT_FALSE(sound.is_off());
}

TEST(SampleClock, WaitsForSamplesThatAreOnlyLate) {
  for (const double delayed : {0.1, 0.3, 0.6}) {
    EXPECT_TRUE(measured({.delayed = delayed}).check_all()) << delayed;
    EXPECT_TRUE(measured({.delayed = delayed, .delayed_at = 0.4}).check_all()) << delayed;
  }
}

// Emulated devices whose time passes faster are delayed by the host for longer.
TEST(SampleClock, ToleratesMoreOnAFasterClock) {
  EXPECT_FALSE(measured({.lost = 0.25}).check_all());
  EXPECT_TRUE(measured({.end = 8.0, .lost = 0.25}, "raw:pipe", 10.0).check_all());
}

TEST(SampleClock, KnowsHowMuchSoundIsMissing) {
  SampleClock sound = measured({});
  EXPECT_NEAR(sound.missing(12.175), 10.0, 0.13);
  EXPECT_NEAR(sound.age(12.175), 10.0, 0.13);
  sound.begin();
  EXPECT_FALSE(sound.has_begun());
  EXPECT_EQ(sound.missing(20.0), 0.0);
  EXPECT_TRUE(sound.check_all());
}

}  // namespace
}  // namespace somato::devices
