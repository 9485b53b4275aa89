// 'somato live' as a service: what it says to a service manager, which these tests stand for.

#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "base/support/eventually.h"
#include "program/support/emulation_test.h"
#include "program/support/program_test.h"

namespace somato {
namespace {

// Receives the messages of a service, by the protocol of sd_notify(3).
class Manager {
 public:
  // `address`: a file, or '@' and a name that is no file.
  explicit Manager(const std::string& address) {
    sockaddr_un at{};
    at.sun_family = AF_UNIX;
    std::copy(address.begin(), address.end(), at.sun_path);
    if (address.front() == '@') at.sun_path[0] = 0;
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + address.size());
    const timeval patience{.tv_sec = 0, .tv_usec = 20000};
    if (bind(handle_, reinterpret_cast<const sockaddr*>(&at), size) != 0 ||
        setsockopt(handle_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience) != 0) {
      throw std::runtime_error("no socket at " + address);
    }
    reader_ = std::jthread([this](const std::stop_token& stop) { read(stop); });
  }
  Manager(const Manager&) = delete;
  Manager(Manager&&) = delete;
  Manager& operator=(const Manager&) = delete;
  Manager& operator=(Manager&&) = delete;
  ~Manager() {
    reader_ = {};
    close(handle_);
  }

  std::vector<std::string> messages() const {
    const std::scoped_lock lock(mutex_);
    return messages_;
  }

  std::ptrdiff_t count(const std::string& message) const {
    const auto all = messages();
    return std::count(all.begin(), all.end(), message);
  }

  bool has(const std::string& message) const { return count(message) > 0; }

 private:
  void read(const std::stop_token& stop) {
    std::array<char, 256> bytes{};
    while (!stop.stop_requested()) {
      const auto count = recv(handle_, bytes.data(), bytes.size(), 0);
      if (count <= 0) continue;
      const std::scoped_lock lock(mutex_);
      messages_.emplace_back(bytes.data(), static_cast<std::size_t>(count));
    }
  }

  int handle_ = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  mutable std::mutex mutex_;
  std::vector<std::string> messages_;
  std::jthread reader_;
};

// The device file of an emulated probe, with only its sensors.
std::string without_servos(const std::string& device) {
  std::string kept = "explore = \"holding\"\nduration = 0.2\n";
  bool is_kept = true;
  std::istringstream lines(device);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('[')) is_kept = !line.starts_with("[servo");
    const bool is_other =
        line.starts_with("body") || line.starts_with("explore ") || line.starts_with("placing");
    if (is_kept && !is_other) kept += line + "\n";
  }
  return kept;
}

class Service : public EmulationTest {
 protected:
  void learn() const {
    write_study("1", "20");
    output_of({"run", "study.toml", "--data", kTrials, "--out", "out"});
  }

  static ProgramWorld watched(const std::string& address, const std::string& microseconds) {
    ProgramWorld world;
    world.environment = {{"NOTIFY_SOCKET", address}, {"WATCHDOG_USEC", microseconds}};
    world.terminal = true;
    world.interrupt_at = "Press Ctrl-C to end.";
    world.interrupt_with = SIGTERM;
    return world;
  }

  // A session that replays, slowly, until it is ended by a signal once `holds`.
  ProgramRun serve(const std::string& address, const std::string& microseconds,
                   const std::function<bool()>& holds) const {
    ProgramWorld world = watched(address, microseconds);
    world.before_interrupt = [&](const std::string& /*said*/) {
      EXPECT_TRUE(testing::eventually(holds));
    };
    return run({"live", "--model", "out/system.somato", "--recording", kTrials, "--speed", "0.05"},
               world);
  }
};

TEST_F(Service, SaysThatItIsReadyThenThatItRespondsThenThatItEnds) {
  learn();
  const Manager manager(path("notify"));
  const auto responded = [&] { return manager.count("WATCHDOG=1") >= 3; };
  EXPECT_EQ(serve(path("notify"), "400000", responded).exit_code, 128 + SIGTERM);
  ASSERT_TRUE(testing::eventually([&] { return manager.has("STOPPING=1"); }));
  const auto all = manager.messages();
  EXPECT_EQ(all.front(), "READY=1");
  EXPECT_EQ(all.back(), "STOPPING=1");
  EXPECT_EQ(std::count(all.begin(), all.end(), "WATCHDOG=1") + 2,
            static_cast<std::ptrdiff_t>(all.size()));
}

TEST_F(Service, AnAddressMayBeNoFileAndAManagerMayNotWatch) {
  learn();
  const std::string address = "@" + path("abstract");
  const Manager manager(address);
  serve(address, "", [&] { return manager.has("READY=1"); });
  ASSERT_TRUE(testing::eventually([&] { return manager.has("STOPPING=1"); }));
  EXPECT_EQ(manager.messages(), (std::vector<std::string>{"READY=1", "STOPPING=1"}));
}

// The player waits until its line is taken: a session that hangs reports no more responses.
TEST_F(Service, ASessionThatHangsDoesNotRespond) {
  learn();
  const Manager manager(path("notify"));
  ASSERT_EQ(mkfifo(path("lines").c_str(), 0600), 0);
  const int reader = open(path("lines").c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  ASSERT_GE(fcntl(reader, F_SETPIPE_SZ, 4096), 4096);  // It has no room after a line.
  ProgramWorld world = watched(path("notify"), "200000");
  world.output_to = path("lines");
  std::ptrdiff_t before = 0;
  std::ptrdiff_t later = 0;
  world.before_interrupt = [&](const std::string& /*said*/) {
    int waiting = 0;
    EXPECT_TRUE(
        testing::eventually([&] { return ioctl(reader, FIONREAD, &waiting) == 0 && waiting > 0; }));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    before = manager.count("WATCHDOG=1");
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    later = manager.count("WATCHDOG=1");
  };
  run({"live", "--model", "out/system.somato", "--recording", kTrials, "--speed", "max"}, world);
  EXPECT_LE(later, before + 1);  // 12 times if it did
  close(reader);
}

TEST_F(Service, WhatIsNoAddressIsRefused) {
  learn();
  const auto refused = [&](const std::string& address, const std::string& time, int status,
                           const Words& says) {
    ProgramWorld world;
    world.environment = {{"NOTIFY_SOCKET", address}, {"WATCHDOG_USEC", time}};
    const ProgramRun done = run(
        {"live", "--model", "out/system.somato", "--recording", kTrials, "--speed", "max"}, world);
    EXPECT_EQ(done.exit_code, status) << done.err;
    for (const std::string& part : says)
      EXPECT_NE(done.err.find(part), std::string::npos) << done.err;
  };
  refused("notify", "", 2, {"NOTIFY_SOCKET", "not the address of a local socket"});
  refused("/" + std::string(200, 'x'), "", 2, {"NOTIFY_SOCKET"});
  refused(path("notify"), "soon", 2, {"WATCHDOG_USEC", "'soon' is not a number"});
  refused(path("notify"), "-5", 2, {"WATCHDOG_USEC"});
  refused(path("missing"), "", 1, {path("missing"), "cannot be notified"});
}

// A device of sensors explores without a person; servos do not move.
TEST_F(Service, SensorsNeedNoPersonAndServosDo) {
  with_emulation({"--body", "hardness", "--bus", "ssc32"}, [&] {
    output_of({"explore", "--body", "hardness", "--explorations", "1", "-o", "train.mcap"});
    write("study.toml",
          "[study]\nname = 'small'\nlabel = 'material'\nseeds = 1\n"
          "[module.depth]\ntype = 'channel'\nchannel = 'potentiometer'\n"
          "[module.end]\ntype = 'last'\ninput = 'depth'\n"
          "[module.map]\ntype = 'som'\ninput = 'end'\nrows = 2\ncolumns = 2\niterations = 20\n");
    output_of({"run", "study.toml", "--data", "train.mcap", "--out", "out"});
    const Words live{"live", "--model", "out/system.somato", "--unattended"};
    const auto refused = [&](const Words& more, const Words& says) {
      Words words = live;
      words.insert(words.end(), more.begin(), more.end());
      expect_refused(2, words, says);
    };
    refused({"--device", "d.toml"}, {"hardness", "has servos", "--unattended"});
    refused({"--body", "hardness"}, {"--unattended", "--device FILE"});
    refused({"--device", "d.toml", "--object", "bark"}, {"--object", "no person"});
    write("skin.toml", without_servos(read("d.toml")));
    const std::string lines = output_of({"live", "--model", "out/system.somato", "--unattended",
                                         "--device", "skin.toml", "--explorations", "2"});
    const auto last = nlohmann::json::parse(lines.substr(lines.rfind('\n', lines.size() - 2) + 1));
    EXPECT_EQ(last["exploration"], 2);
    EXPECT_EQ(last["final"], true);
    EXPECT_FALSE(last.contains("right")) << last;
  });
}

}  // namespace
}  // namespace somato
