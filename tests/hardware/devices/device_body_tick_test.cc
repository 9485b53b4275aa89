// A period of a device costs nothing besides its arithmetic; locks are excluded by
// scripts/check_includes.py.

#include <gtest/gtest.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstddef>

#include "base/support/no_malloc.h"
#include "base/support/sanitized.h"
#include "bodies/support/fake_hand.h"
#include "hardware/device_files/device_text.h"
#include "hardware/devices/device_body.h"
#include "hardware/emulation/replayed_lines.h"
#include "hardware/support/emulated_device.h"
#include "hardware/support/every_bus.h"

namespace somato::devices {
namespace {

constexpr const char* kTicking = R"(name = "finger"
explore = "closing"
[servos]
bus = "ssc32"
port = "servos"
[servo.finger]
channel = 0
zero = 1000
scale = 10
least = 0
most = 60
fastest = 60
[frames]
format = "frames"
port = "sensors"
elements = 1
rate = 50
[sensor.touch]
from = "frames"
elements = ["finger_1"]
[safety]
sensor = "touch"
limit = 8
)";

std::unique_ptr<Body> a_finger() {
  auto hand = std::make_unique<FakeHand>("finger");
  hand->add_servo({"finger", "deg", 0.0, 60.0, 600.0}, 0.0);
  ChannelDescription touch;
  touch.name = "touch";
  touch.element_names = {"finger_1"};
  hand->add_sensor(touch, [](const auto&) { return std::vector<float>{0.5F}; });
  return hand;
}

class DeviceTick : public ::testing::TestWithParam<BusKind> {
 protected:
  DeviceFile file_ = *parse_device_file(*with_bus(kTicking, "d.toml", GetParam()), "d.toml");

  // A movement of 50 periods, at lines that are recorded or replayed.
  template <typename Around>
  static void move(const DeviceFile& file, wire::Lines& lines, const Around& around) {
    const auto body = DeviceBody::start(file, lines);
    ASSERT_TRUE(body) << to_string(body.error());
    ASSERT_TRUE((*body)->command(std::array{50.0}));
    ASSERT_TRUE((*body)->step(0.1));
    around(**body);
  }

  std::vector<emulation::LineEvent> recorded() const {
    testing::EmulatedDevice device(file_, a_finger());
    emulation::RecordedLines lines(device.lines);
    move(file_, lines, [](Body& body) { ASSERT_TRUE(body.step(1.0)); });
    return lines.events();
  }
};

INSTANTIATE_TEST_SUITE_P(Buses, DeviceTick, ::testing::ValuesIn(testing::every_bus()),
                         testing::name_of_bus);

TEST_P(DeviceTick, AllocatesNothing) {
  if (!testing::counts_allocations()) GTEST_SKIP() << "this build does not count allocations";
  emulation::ReplayedLines lines(recorded());
  move(file_, lines, [](Body& body) {
    const testing::AllocationCounter counter;
    ASSERT_TRUE(body.step(1.0));
    EXPECT_EQ(counter.count(), 0U);
  });
}

// Any following system call, except the end, ends the process.
bool forbid_system_calls() {
  std::array<sock_filter, 4> code{
      sock_filter{BPF_LD | BPF_W | BPF_ABS, 0, 0, offsetof(seccomp_data, nr)},
      sock_filter{BPF_JMP | BPF_JEQ | BPF_K, 0, 1, SYS_exit},
      sock_filter{BPF_RET | BPF_K, 0, 0, SECCOMP_RET_ALLOW},
      sock_filter{BPF_RET | BPF_K, 0, 0, SECCOMP_RET_KILL_PROCESS}};
  const sock_fprog program{static_cast<unsigned short>(code.size()), code.data()};
  return prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
         prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

constexpr int kCompleted = 17;

// The end of a process in which `work` makes no system call, or -1.
template <typename Work>
int end_without_system_calls(const Work& work) {
  const pid_t child = fork();
  if (child == 0) {
    if (!forbid_system_calls()) _exit(1);
    const bool done = work();
    syscall(SYS_exit, done ? kCompleted : 2);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_P(DeviceTick, MakesNoSystemCall) {
#ifdef SOMATO_TESTS_SANITIZED
  GTEST_SKIP() << "sanitizers make system calls";
#endif
  ASSERT_EQ(end_without_system_calls([] { return true; }), kCompleted);
  ASSERT_EQ(end_without_system_calls([] { return getppid() > 0; }), -1);
  emulation::ReplayedLines lines(recorded());
  move(file_, lines, [](Body& body) {
    EXPECT_EQ(end_without_system_calls([&] { return body.step(1.0).has_value(); }), kCompleted);
  });
}

}  // namespace
}  // namespace somato::devices
