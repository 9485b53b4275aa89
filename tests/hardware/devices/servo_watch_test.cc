#include "hardware/devices/servo_watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "base/support/no_malloc.h"

namespace somato::devices {
namespace {

constexpr double kPeriod = 0.02;

// A servo of 0 to 100 deg, of which a tenth is the permitted deviation.
DeviceFile device(ExploringMethod explore) {
  DeviceFile file;
  file.settings.explore = explore;
  file.settings.period = kPeriod;
  ServoSettings servo;
  servo.name = "thumb";
  servo.zero = 500.0;
  servo.scale = 10.0;
  servo.most = 100.0;
  file.servos = {servo};
  return file;
}

// Commands, and what the servo reports about itself, in deg.
struct Moment {
  double commanded = 0.0;
  double measured = 0.0;
  double temperature = 30.0;
};

using Path = std::function<Moment(double time)>;

// The time of the first fault in so many seconds, or nothing; its text in `said`.
class Watched {
 public:
  explicit Watched(ExploringMethod explore) : file_(device(explore)), watch_(file_) {}

  double fault(double seconds, const Path& path) {
    for (double time = kPeriod; time <= seconds; time += kPeriod) {
      if (!check(time, path(time))) return time;
    }
    return 0.0;
  }

  bool check(double time, const Moment& moment) {
    report_.time = time;
    report_.position = file_.servos[0].on_bus(moment.measured);
    report_.temperature = moment.temperature;
    const std::vector<double> commanded{moment.commanded};
    const auto checked = watch_.check(commanded, std::vector{report_});
    if (!checked) said = to_string(checked.error());
    return checked.has_value();
  }

  ServoWatch& watch() { return watch_; }
  SafetySettings& safety() { return file_.safety; }
  bool obeys() const { return watch_.obeys(); }

  std::string said;

 private:
  DeviceFile file_;
  ServoWatch watch_;
  ServoReport report_;
};

// To and fro between 0 and 90 deg at 90 deg/s.
double to_and_fro(double time) {
  const double phase = std::fmod(time, 2.0);
  return 90.0 * (phase < 1.0 ? phase : 2.0 - phase);
}

TEST(ServoWatch, AServoThatFollowsLateIsNoFault) {
  for (const auto explore : {ExploringMethod::kClosing, ExploringMethod::kGrasping}) {
    Watched watched(explore);
    EXPECT_EQ(watched.fault(10.0,
                            [](double time) {
                              return Moment{to_and_fro(time),
                                            to_and_fro(std::max(0.0, time - 0.1))};
                            }),
              0.0)
        << watched.said;
  }
}

// The command passes 10 deg after 1/9 s; half a second later the servo is stuck.
TEST(ServoWatch, AServoThatNeverMovesIsStuck) {
  for (const auto explore : {ExploringMethod::kClosing, ExploringMethod::kGrasping}) {
    Watched watched(explore);
    const double at =
        watched.fault(5.0, [](double time) { return Moment{std::min(90.0, 90.0 * time), 1.0}; });
    EXPECT_NEAR(at, 11.0 / 90.0 + 0.5, 2.0 * kPeriod);
    EXPECT_NE(watched.said.find("the servo 'thumb' does not move: it has been at 1.0 deg for 0.5"),
              std::string::npos)
        << watched.said;
    EXPECT_TRUE(watched.obeys());
  }
}

// An object stops a finger that closes; it opens again.
TEST(ServoWatch, AnObjectMayStopAHandThatCloses) {
  const auto blocked = [](double time) {
    const double commanded = to_and_fro(time);
    return Moment{commanded, std::min(commanded, 40.0)};
  };
  Watched closing(ExploringMethod::kClosing);
  EXPECT_EQ(closing.fault(10.0, blocked), 0.0) << closing.said;
  Watched grasping(ExploringMethod::kGrasping);
  EXPECT_NEAR(grasping.fault(10.0, blocked), 50.0 / 90.0 + 0.5, 2.0 * kPeriod);
}

TEST(ServoWatch, AFingerThatDoesNotOpenAgainIsStuck) {
  Watched watched(ExploringMethod::kClosing);
  const double at = watched.fault(10.0, [](double time) {
    const double commanded =
        time < 4.0 ? std::min(90.0, 90.0 * time) : std::max(0.0, 90.0 - 90.0 * (time - 4.0));
    return Moment{commanded, std::min(40.0, 90.0 * time)};
  });
  EXPECT_NEAR(at, 4.0 + 60.0 / 90.0 + 0.5, 2.0 * kPeriod);
}

// 176 deg/s away from its command: 10 deg are reached after 57 ms, of which the median takes one
// period more.
TEST(ServoWatch, AServoThatDriftsAwayIsStoppedWithin50MillisecondsOfItsDeviation) {
  Watched watched(ExploringMethod::kClosing);
  const double at = watched.fault(
      5.0, [](double time) { return Moment{20.0, 20.0 + 176.0 * std::max(0.0, time - 1.0)}; });
  EXPECT_GT(at, 1.0 + 10.0 / 176.0);
  EXPECT_LE(at, 1.0 + 10.0 / 176.0 + 0.05);
  EXPECT_NE(watched.said.find("the servo 'thumb' moves away from its command"), std::string::npos)
      << watched.said;
  EXPECT_FALSE(watched.obeys());
}

TEST(ServoWatch, AnObjectMayPushAServoBackALittle) {
  Watched watched(ExploringMethod::kClosing);
  EXPECT_EQ(watched.fault(20.0,
                          [](double time) {
                            const double pushed = std::fmod(time, 1.0) < 0.5 ? 5.0 : 0.0;
                            return Moment{60.0, 40.0 - pushed};
                          }),
            0.0)
      << watched.said;
}

TEST(ServoWatch, AServoOutsideOfItsLimitsIsAFault) {
  Watched watched(ExploringMethod::kClosing);
  EXPECT_EQ(watched.fault(1.0, [](double) { return Moment{100.0, 104.0}; }), 0.0);
  const double at =
      Watched(ExploringMethod::kClosing).fault(1.0, [](double) { return Moment{0.0, -6.0}; });
  EXPECT_NEAR(at, 3.0 * kPeriod, 1e-9);
  EXPECT_FALSE(watched.check(2.0, {100.0, 227.0}) && watched.check(2.02, {100.0, 227.0}));
  EXPECT_NE(watched.said.find("the servo 'thumb' is at 227.0 deg, outside its limits, 0 to 100"),
            std::string::npos)
      << watched.said;
  EXPECT_FALSE(watched.obeys());
}

TEST(ServoWatch, AHotServoIsAFaultWhenThreeReportsSaySo) {
  Watched watched(ExploringMethod::kClosing);
  EXPECT_NEAR(watched.fault(1.0, [](double) { return Moment{0.0, 0.0, 130.0}; }), 3.0 * kPeriod,
              1e-9);
  EXPECT_NE(watched.said.find("130 degrees Celsius, above 70"), std::string::npos) << watched.said;
  EXPECT_TRUE(watched.obeys());
  EXPECT_EQ(Watched(ExploringMethod::kClosing)
                .fault(1.0, [](double) { return Moment{0.0, 0.0, std::nan("")}; }),
            0.0);
}

// A report in ten is wrong in all that it says.
TEST(ServoWatch, SingleDamagedReportsAreOutvoted) {
  Watched watched(ExploringMethod::kGrasping);
  std::size_t number = 0;
  EXPECT_EQ(watched.fault(10.0,
                          [&](double time) {
                            const double commanded = to_and_fro(time);
                            if (++number % 10 == 0) return Moment{commanded, 4000.0, 200.0};
                            return Moment{commanded, commanded};
                          }),
            0.0)
      << watched.said;
}

// Then nothing is known of the servo: the silence of the line is another fault.
TEST(ServoWatch, TimeWithoutReportsDoesNotCount) {
  Watched watched(ExploringMethod::kGrasping);
  for (double time = kPeriod; time < 0.5; time += kPeriod) ASSERT_TRUE(watched.check(time, {0, 0}));
  for (int i = 0; i < 50; ++i) ASSERT_TRUE(watched.check(0.5, {90.0, 0.0}));
  EXPECT_TRUE(watched.check(2.5, {90.0, 0.0}));
}

TEST(ServoWatch, ItsSettingsAreWhatIsPermitted) {
  Watched watched(ExploringMethod::kGrasping);
  watched.safety().deviation = 0.5;
  watched.safety().unmoved = 2.0;
  watched.safety().beyond = 1.0;
  watched.safety().hottest = 150.0;
  EXPECT_EQ(watched.fault(1.0, [](double) { return Moment{0.0, -40.0, 130.0}; }), 0.0);
  EXPECT_EQ(watched.fault(1.9, [](double) { return Moment{90.0, 0.0}; }), 0.0);
}

TEST(ServoWatch, AllocatesNothing) {
  Watched watched(ExploringMethod::kClosing);
  const std::vector<double> commanded{1.0};
  std::vector<ServoReport> reports(1);
  const testing::AllocationCounter allocations;
  for (int i = 0; i < 10; ++i) {
    reports[0].time = i;
    reports[0].position = 510.0;
    ASSERT_TRUE(watched.watch().check(commanded, reports));
  }
  EXPECT_EQ(allocations.count(), 0U);
}

}  // namespace
}  // namespace somato::devices
