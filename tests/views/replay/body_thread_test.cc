#include "views/replay/body_thread.h"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <optional>
#include <thread>
#include <vector>

#include "views/replay/fake_explorer.h"

namespace somato::live {
namespace {

constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();

class BodyThreadTest : public ::testing::Test {
 protected:
  // Does what the body posts until `holds`, or until nothing comes any more.
  template <typename Condition>
  bool wait_until(Condition holds) {
    while (!holds()) {
      const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(30);
      if (queue_.wait(patience) != TaskQueue::Woken::kTask) return false;
    }
    return true;
  }

  TaskQueue queue_;
  testing::FakeExplorer explorer_;
  std::vector<std::string> bodies_;
  std::vector<BodyStep> steps_;
  std::optional<Result<Exploration>> explored_;
  std::vector<std::thread::id> threads_;  // That were prepared, before their first step.
  BodyThread body_{
      queue_,
      {[this](const BodyDescription& body, const Scene&) { bodies_.push_back(body.name); },
       [this](BodyStep step) { steps_.push_back(std::move(step)); },
       [this](auto explored) { explored_ = explored.get(); },
       [this] { threads_.push_back(std::this_thread::get_id()); }}};
};

TEST_F(BodyThreadTest, WaitsAfterEachStepUntilItMayGoOn) {
  body_.start(explorer_, 1, 0, {}, kNoLimit);
  for (std::size_t step = 1; step <= 10; ++step) {
    ASSERT_TRUE(wait_until([&] { return steps_.size() == step; }));
    const auto soon = std::chrono::steady_clock::now() + std::chrono::milliseconds(5);
    EXPECT_EQ(queue_.wait(soon), TaskQueue::Woken::kTime);
    EXPECT_TRUE(body_.is_exploring());
    body_.go_on();
  }
  ASSERT_TRUE(wait_until([&] { return explored_.has_value(); }));
  EXPECT_FALSE(body_.is_exploring());
  EXPECT_EQ(bodies_, (std::vector<std::string>{"fake"}));
  EXPECT_EQ(steps_[1].readings, Readings::kRecorded);
  EXPECT_EQ(steps_[1].poses.at(0).position[0], 1.0);
  EXPECT_EQ(explored_->value().labels[0].value, "cube");
  EXPECT_EQ(explored_->value().channels[2].frames.row(0)[1], steps_[1].state.readings[2](0, 1));
}

TEST_F(BodyThreadTest, TheThreadOfAnExplorationIsPreparedOnceBeforeItsFirstStep) {
  body_.start(explorer_, 0, 0, {}, kNoLimit);
  ASSERT_TRUE(wait_until([&] { return steps_.size() == 1; }));
  ASSERT_EQ(threads_.size(), 1U);
  EXPECT_NE(threads_.front(), std::this_thread::get_id());
}

TEST_F(BodyThreadTest, EndsSoonWhenItIsStopped) {
  body_.start(explorer_, 0, 0, {}, kNoLimit);
  ASSERT_TRUE(wait_until([&] { return steps_.size() == 1; }));
  body_.stop();
  ASSERT_TRUE(wait_until([&] { return explored_.has_value(); }));
  EXPECT_EQ(explored_->error().kind, ErrorKind::kInterrupted);
  EXPECT_EQ(steps_.size(), 1U);
  // The next exploration is not stopped.
  explored_.reset();
  body_.start(explorer_, 0, 0, {}, kNoLimit);
  EXPECT_TRUE(wait_until([&] { return steps_.size() == 2; }));
}

TEST_F(BodyThreadTest, LeavesOutWhatComesAfterItWasStopped) {
  body_.start(explorer_, 0, 0, {}, kNoLimit);
  body_.stop();
  ASSERT_TRUE(wait_until([&] { return explored_.has_value(); }));
  EXPECT_TRUE(bodies_.empty());
  EXPECT_TRUE(steps_.empty());
}

TEST_F(BodyThreadTest, EndsWithTheQueue) {
  body_.start(explorer_, 0, 0, {}, kNoLimit);
  ASSERT_TRUE(wait_until([&] { return steps_.size() == 1; }));
  queue_.close();
  body_.join();
  EXPECT_FALSE(body_.is_exploring());
  EXPECT_FALSE(explored_.has_value());
}

}  // namespace
}  // namespace somato::live
