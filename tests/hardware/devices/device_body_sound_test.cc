// A microphone that gives other samples than it should, by a clock that only passes while the body
// waits.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "hardware/boards/emulated_board.h"
#include "hardware/devices/device_body.h"
#include "hardware/support/board_line.h"
#include "somato/bodies/explore_by.h"

namespace somato::devices {
namespace {

constexpr double kSoundBlock = 0.05;  // s

class MicrophoneBoard : public emulation::EmulatedBoard {
 public:
  explicit MicrophoneBoard(double rate, double lost_from = INFINITY, double lost_until = INFINITY)
      : rate_(rate), lost_from_(lost_from), lost_until_(lost_until) {}

  void receive(std::span<const std::uint8_t> /*bytes*/) override {}
  void restart() override {}
  void advance(double now, std::vector<std::uint8_t>& sent) override {
    for (; (blocks_ + 1) * kSoundBlock <= now; ++blocks_) {
      const double time = blocks_ * kSoundBlock;
      if (time >= lost_from_ && time < lost_until_) continue;
      sent.resize(sent.size() + 2 * static_cast<std::size_t>(std::lround(kSoundBlock * rate_)), 1);
    }
  }

 private:
  double rate_;
  double lost_from_;
  double lost_until_;
  int blocks_ = 0;
};

DeviceFile with_microphone() {
  return *parse_device_file(R"(name = "ear"
explore = "holding"
[microphone]
source = "raw:pipe"
rate = 8000
[sensor.sound]
from = "microphone"
)",
                            "d.toml");
}

// The channel, or what went wrong while it was held for three seconds.
Result<Exploration> recorded(MicrophoneBoard board, double seconds = 3.0) {
  testing::BoardLine line(board);
  SOMATO_TRY(const auto body, DeviceBody::start(with_microphone(), line));
  SOMATO_TRY_VOID(body->begin());
  SOMATO_TRY(auto exploration, explore_by_holding(*body, seconds, 0.02));
  SOMATO_TRY_VOID(body->end());
  return exploration;
}

TEST(DeviceBodySound, RecordsTheSamplesOfItsRate) {
  const auto exploration = recorded(MicrophoneBoard(8000.0));
  ASSERT_TRUE(exploration) << to_string(exploration.error());
  EXPECT_EQ(exploration->channels[0].frames.rows(), 24'000U);
}

TEST(DeviceBodySound, StopsForTooManySamplesAsForTooFew) {
  for (const double rate : {44100.0, 16000.0, 10000.0, 7000.0, 4000.0}) {
    const auto exploration = recorded(MicrophoneBoard(rate));
    ASSERT_FALSE(exploration) << rate;
    EXPECT_EQ(exploration.error().kind, ErrorKind::kSystem);
    EXPECT_NE(exploration.error().what.find("samples per second, not 8000"), std::string::npos)
        << exploration.error().what;
  }
}

TEST(DeviceBodySound, StopsForSamplesThatWereLost) {
  const auto exploration = recorded(MicrophoneBoard(8000.0, 1.0, 1.3), 12.0);
  ASSERT_FALSE(exploration);
  EXPECT_EQ(exploration.error().what, "the microphone lost 0.30 s of sound");
}

TEST(DeviceBodySound, NoticesALossAtTheEnd) {
  const auto exploration = recorded(MicrophoneBoard(8000.0, 2.6, 2.9));
  EXPECT_FALSE(exploration);
}

TEST(DeviceBodySound, DoesNotStartWithoutSamples) {
  const auto exploration = recorded(MicrophoneBoard(8000.0, 0.0));
  ASSERT_FALSE(exploration);
  EXPECT_EQ(exploration.error().what, "no samples arrived within 2 s");
}

}  // namespace
}  // namespace somato::devices
