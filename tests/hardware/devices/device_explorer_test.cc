#include "hardware/devices/device_explorer.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "hardware/support/every_bus.h"
#include "hardware/support/faulty_fingers.h"
#include "hardware/support/lent_lines.h"

namespace somato::devices {
namespace {

using testing::FaultyFingers;

// Two fingers and their sensors, which hold for two seconds each time.
DeviceFile holding_device() {
  DeviceFile file = testing::faulty_device(BusKind::kSts);
  file.settings.explore = ExploringMethod::kHolding;
  file.settings.duration = 2.0;
  return file;
}

class DeviceExplorerTest : public ::testing::Test {
 protected:
  DeviceSurroundings surroundings() {
    DeviceSurroundings surroundings;
    surroundings.open_lines = [this]() -> Result<std::unique_ptr<wire::Lines>> {
      ++opened_;
      return std::make_unique<testing::LentLines>(fingers_.device.lines);
    };
    return surroundings;
  }

  std::unique_ptr<Explorer> explorer(DeviceSurroundings surroundings) {
    Object ball;
    ball.name = "ball";
    auto made = DeviceExplorer::create(fingers_.device.file, {{ball.name, ball, {}}}, {},
                                       std::move(surroundings));
    EXPECT_TRUE(made) << to_string(made.error());
    return std::move(*made);
  }

  // The sensors fall silent in the middle of an exploration.
  void fail_once(Explorer& explorer) {
    fingers_.at(fingers_.device.lines.now() + 1.0, [&] { fingers_.sensor_line().silent = true; });
    const auto failed = explorer.explore(0, 0);
    fingers_.sensor_line().silent = false;
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.error().what, "no valid sensor frame arrived for 3 periods");
  }

  FaultyFingers fingers_{holding_device()};
  std::size_t opened_ = 0;
};

TEST_F(DeviceExplorerTest, MovesARealBody) {
  EXPECT_TRUE(explorer(surroundings())->moves_real_body());
  EXPECT_EQ(opened_, 0U) << "nothing happens before it explores";
}

TEST_F(DeviceExplorerTest, NothingMovesAfterAFaultUntilAPersonSaysSo) {
  const auto explorer = this->explorer(surroundings());
  ASSERT_TRUE(explorer->explore(0, 0));
  EXPECT_FALSE(explorer->is_stopped());
  fail_once(*explorer);
  EXPECT_TRUE(explorer->is_stopped());
  for (int i = 0; i < 3; ++i) {
    const auto refused = explorer->explore(0, 1);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, ErrorKind::kUnavailable);
    EXPECT_EQ(refused.error().what, "a fault has stopped the device");
  }
  EXPECT_EQ(opened_, 1U) << "its lines are not opened again";
  EXPECT_TRUE(fingers_.are_off());
  explorer->resume();
  EXPECT_FALSE(explorer->is_stopped());
  EXPECT_TRUE(explorer->explore(0, 1));
}

// It is pulled on the way to the resting position, when nothing can switch the servos off.
TEST_F(DeviceExplorerTest, ACableThatIsPutBackMovesNothing) {
  fingers_.device.file.servos[0].rest = 40.0;  // 0.67 s from where it starts
  const auto explorer = this->explorer(surroundings());
  ExploreOptions options;
  options.observer.on_begin = [](const BodyDescription&, const Scene&) -> Result<void> {
    return {};
  };
  options.observer.on_step = [&](const ExplorationStep& step) -> Result<void> {
    if (step.state.time < 1.9) return {};
    fingers_.at(fingers_.device.lines.now() + 0.3, [&] { fingers_.servo_line().hung_up = true; });
    return {};
  };
  const auto failed = explorer->explore(0, 0, options);
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().what, "the line has hung up");
  const double at = fingers_.hand.state().positions[0];
  EXPECT_GT(at, 5.0);
  EXPECT_LT(at, 35.0);
  fingers_.servo_line().hung_up = false;
  for (int i = 0; i < 100; ++i) fingers_.device.lines.wait(fingers_.device.lines.now() + 0.01);
  const auto refused = explorer->explore(0, 0);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().what, "a fault has stopped the device");
  EXPECT_NEAR(fingers_.hand.state().positions[0], at, 2.0) << "the rest of one period";
  EXPECT_EQ(opened_, 1U);
  explorer->resume();
  EXPECT_TRUE(explorer->explore(0, 0));
}

TEST_F(DeviceExplorerTest, APersonMayPermitItWhenTheNextExplorationBegins) {
  std::vector<std::string> faults;
  bool permits = false;
  DeviceSurroundings asking = surroundings();
  asking.permit = [&](const Error& fault) -> Result<void> {
    faults.push_back(fault.what);
    if (permits) return {};
    return fail(ErrorKind::kUnavailable, "no person is there");
  };
  const auto explorer = this->explorer(std::move(asking));
  fail_once(*explorer);
  EXPECT_EQ(explorer->explore(0, 1).error().what, "no person is there");
  permits = true;
  EXPECT_TRUE(explorer->explore(0, 1));
  EXPECT_TRUE(explorer->explore(0, 2));
  EXPECT_EQ(faults, (std::vector<std::string>(2, "no valid sensor frame arrived for 3 periods")));
}

// Ends the start of a device when its first servo is on.
class EndedStart : public testing::LentLines {
 public:
  EndedStart(FaultyFingers& fingers, std::function<void()> end)
      : LentLines(fingers.device.lines), fingers_(fingers), end_(std::move(end)) {}
  void wait(double until) override {
    LentLines::wait(until);
    if (end_ && fingers_.servos().driven_position(0)) std::exchange(end_, nullptr)();
  }

 private:
  FaultyFingers& fingers_;
  std::function<void()> end_;
};

class DeviceStartTest : public ::testing::TestWithParam<BusKind> {
 protected:
  // An explorer whose start is ended so; afterwards it starts as usual.
  std::unique_ptr<Explorer> explorer(std::function<void()> end) {
    DeviceSurroundings surroundings;
    surroundings.open_lines = [this, end = std::move(end)]() mutable {
      return Result<std::unique_ptr<wire::Lines>>(
          std::make_unique<EndedStart>(fingers_, std::exchange(end, nullptr)));
    };
    surroundings.on_switch = [this](wire::Lines&, std::span<const std::uint8_t> relax_bytes) {
      relax_bytes_.assign(relax_bytes.begin(), relax_bytes.end());
    };
    DeviceFile file = fingers_.device.file;
    file.settings.explore = ExploringMethod::kHolding;
    file.settings.duration = 0.1;
    Object ball;
    ball.name = "ball";
    return *DeviceExplorer::create(std::move(file), {{ball.name, ball, {}}}, {},
                                   std::move(surroundings));
  }

  FaultyFingers fingers_{testing::faulty_device(GetParam())};
  std::vector<std::uint8_t> relax_bytes_;  // That a signal handler would send.
};

TEST_P(DeviceStartTest, ASignalCanSwitchOffWhatTheStartHasSwitchedOn) {
  std::vector<std::uint8_t> then;
  const auto explorer = this->explorer([&] { then = relax_bytes_; });
  ASSERT_TRUE(explorer->explore(0, 0));
  ASSERT_FALSE(then.empty());
  EXPECT_FALSE(fingers_.are_off());
  ASSERT_TRUE(fingers_.device.lines.write(0, then));
  EXPECT_TRUE(fingers_.are_off());
}

TEST_P(DeviceStartTest, AnExceptionLeavesItsServosOff) {
  const auto explorer = this->explorer([] { throw std::runtime_error("the start is ended"); });
  EXPECT_THROW((void)explorer->explore(0, 0), std::runtime_error);
  EXPECT_TRUE(fingers_.are_off());
  EXPECT_TRUE(explorer->explore(0, 0)) << "it can be started again";
}

TEST_P(DeviceStartTest, AnErrorLeavesItsServosOff) {
  const auto explorer = this->explorer([&] { fingers_.sensor_line().hung_up = true; });
  EXPECT_EQ(explorer->explore(0, 0).error().kind, ErrorKind::kUnavailable);
  EXPECT_TRUE(fingers_.are_off());
  EXPECT_TRUE(relax_bytes_.empty()) << "a signal handler has nothing left to send";
}

INSTANTIATE_TEST_SUITE_P(Buses, DeviceStartTest, ::testing::ValuesIn(testing::every_bus()),
                         testing::name_of_bus);

// An exploration that was interrupted is no fault: the command that interrupted it may be followed
// by another.
TEST_F(DeviceExplorerTest, AnInterruptionIsNoFault) {
  const auto explorer = this->explorer(surroundings());
  ExploreOptions options;
  options.limits.should_continue = [] { return false; };
  EXPECT_EQ(explorer->explore(0, 0, options).error().kind, ErrorKind::kInterrupted);
  EXPECT_TRUE(fingers_.are_off());
  EXPECT_FALSE(explorer->is_stopped());
  EXPECT_TRUE(explorer->explore(0, 0));
}

// A servo rests elsewhere than where it starts: it goes there after the exploration.
TEST_F(DeviceExplorerTest, TheWayBackCanBeInterruptedAndTheExplorationCounts) {
  fingers_.device.file.servos[0].rest = 40.0;  // 0.67 s from where it starts
  const auto explorer = this->explorer(surroundings());
  double until = 0.0;
  ExploreOptions options;
  options.observer.on_begin = [](const BodyDescription&, const Scene&) -> Result<void> {
    return {};
  };
  options.observer.on_step = [&](const ExplorationStep& step) -> Result<void> {
    if (step.state.time > 1.9) until = fingers_.device.lines.now() + 0.2;
    return {};
  };
  options.limits.should_continue = [&] {
    return until == 0.0 || fingers_.device.lines.now() < until;
  };
  const auto explored = explorer->explore(0, 0, options);
  ASSERT_TRUE(explored) << to_string(explored.error());
  EXPECT_EQ(explored->labels[0].value, "ball");
  EXPECT_TRUE(fingers_.are_off());
  EXPECT_LT(fingers_.hand.state().positions[0], 20.0);
}

}  // namespace
}  // namespace somato::devices
