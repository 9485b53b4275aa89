#include "hardware/topics/topic_explorer.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>

#include "hardware/topics/topic_server.h"

namespace somato::topics {
namespace {

using testing::TopicServer;

// A robot that publishes a topic without end.
class Robot {
 public:
  explicit Robot(int port = 0) : server_(port) {
    server_.advertise(1, "/touch", "float32 value");
    sender_ = std::thread([this] {
      for (std::uint64_t message = 0; !stopping_; ++message) {
        server_.send_number(0, message * 10'000'000, 1.0F);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
    });
  }
  Robot(const Robot&) = delete;
  Robot(Robot&&) = delete;
  Robot& operator=(const Robot&) = delete;
  Robot& operator=(Robot&&) = delete;
  ~Robot() {
    stopping_ = true;
    sender_.join();
  }

  int port() const { return server_.port(); }

 private:
  TopicServer server_;
  std::atomic<bool> stopping_ = false;
  std::thread sender_;
};

std::unique_ptr<Explorer> explorer_of(int port) {
  ExploredThing cup;
  cup.name = "cup";
  TopicExploring exploring;
  exploring.address = "ws://127.0.0.1:" + std::to_string(port);
  exploring.sensors = {{"touch", "N", "/touch", {"value"}, {}}};
  exploring.duration = 0.05;
  exploring.patience = 0.5;
  return TopicExplorer::create({cup}, exploring).value();
}

// On a slow machine a robot may seem silent.
bool explores_at_last(Explorer& explorer) {
  for (int i = 0; i < 100; ++i) {
    if (explorer.explore(0, 0)) return true;
  }
  return false;
}

TEST(TopicExplorerThread, WaitsForARobotThatWasThere) {
  auto robot = std::make_unique<Robot>();
  const int port = robot->port();
  const auto explorer = explorer_of(port);
  ASSERT_TRUE(explores_at_last(*explorer));
  robot.reset();
  const auto lost = explorer->explore(0, 1);
  ASSERT_FALSE(lost);
  EXPECT_EQ(lost.error().kind, ErrorKind::kSystem);
  int looks = 0;
  const ExploreOptions until{.limits = {.should_continue = [&] { return ++looks < 3; }}};
  const auto stopped = explorer->explore(0, 2, until);
  ASSERT_FALSE(stopped);
  EXPECT_EQ(stopped.error().kind, ErrorKind::kInterrupted);
  robot = std::make_unique<Robot>(port);
  EXPECT_TRUE(explores_at_last(*explorer));
}

TEST(TopicExplorerThread, DoesNotWaitForARobotThatWasNeverThere) {
  int port = 0;
  {
    const TopicServer server;
    port = server.port();
  }
  const auto refused = explorer_of(port)->explore(0, 0);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kUnavailable);
}

}  // namespace
}  // namespace somato::topics
