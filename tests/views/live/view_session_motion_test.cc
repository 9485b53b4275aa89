// A real body moves after a viewer's press of Start only, whatever else happens in the
// view.

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "views/live/sessions.h"
#include "views/live/view_session.h"
#include "views/live/view_systems.h"
#include "views/live/viewing.h"

namespace somato {
namespace {

using testing::command;
using testing::eventually;
using testing::state_of;

constexpr const char* kStart = R"({"command":"explore"})";

// The movements of a body, which outlive it.
struct Moves {
  std::atomic<std::size_t> begun = 0;
  std::atomic<std::size_t> resumed = 0;
  std::size_t steps = 0;                  // unprotected: its line belongs to one thread at a time
  std::atomic<std::size_t> failures = 0;  // so many of the next explorations end with a fault
  std::atomic<bool> holds = false;        // a body that has a fault holds
  std::atomic<bool> may_end = true;       // then it ends
};

// A real body that counts its movements.
class RealBody : public Explorer {
 public:
  RealBody(std::shared_ptr<Moves> moves, std::size_t steps)
      : Explorer(testing::FakeExplorer().things(), ""), moves_(std::move(moves)), fake_(steps) {}

  bool is_stopped() const override { return is_stopped_; }
  void resume() override {
    if (is_stopped_) ++moves_->resumed;
    is_stopped_ = false;
  }

 protected:
  Result<Exploration> explore_thing(std::size_t thing, std::size_t trial,
                                    const ExploreOptions& options) override {
    ++moves_->begun;
    ExploreOptions counting = options;
    counting.observer.on_step = [&](const ExplorationStep& step) {
      ++moves_->steps;
      return options.observer.on_step(step);
    };
    auto explored = fake_.explore(thing, trial, counting);
    if (!explored || moves_->failures == 0) return explored;
    --moves_->failures;
    moves_->holds = true;
    while (!moves_->may_end) std::this_thread::yield();
    is_stopped_ = true;
    return fail(ErrorKind::kData, "the servo is stuck");
  }

 private:
  std::shared_ptr<Moves> moves_;
  testing::FakeExplorer fake_;
  bool is_stopped_ = false;
};

class MotionThread : public ::testing::Test {
 protected:
  ViewSource source(std::size_t steps = 10) {
    ViewSource source;
    source.name = "a real hand";
    source.explorer = std::make_unique<RealBody>(moves_, steps);
    return source;
  }

  ViewSource planned() {
    ViewSource planned = source();
    planned.plan = {{0, 0}, {1, 0}, {0, 1}};
    return planned;
  }

  // As fast as it can be shown, to a viewer.
  static ViewSettings viewed() { return {true, 100.0, 0.0, 0.0}; }

  // All that was to begin before has begun: the session does one thing after the other.
  static void settle(ViewSession& session) {
    for (int i = 0; i < 3; ++i) ASSERT_TRUE(session.state());
  }

  static std::size_t explored(ViewSession& session) {
    return state_of(session)["explorations"].size();
  }

  // A page opens, is reloaded, and a second one comes.
  static void come_and_go(ViewSession& session) {
    for (int i = 0; i < 3; ++i) {
      const auto first = session.hub().subscribe(4);
      settle(session);
      const auto second = session.hub().subscribe(4);
      settle(session);
    }
    settle(session);
  }

  std::shared_ptr<Moves> moves_ = std::make_shared<Moves>();
};

// All that a page can send, but for the command that starts.
const std::vector<std::string> kOthers{
    R"({"command":"play"})",
    R"({"command":"pause"})",
    R"({"command":"step","frames":1})",
    R"({"command":"step","frames":-1})",
    R"({"command":"seek","exploration":0,"frame":0})",
    R"({"command":"speed","speed":2})",
    R"({"command":"thing","name":"cube"})",
    R"({"command":"placement","x":1,"y":1,"turn":1})",
    R"({"command":"name","label":"object","value":"ball"})",
    R"({"command":"undo_name","id":0,"label":"object","value":"cup"})",
    R"({"command":"plan","each":2})",
    R"({"command":"system","name":"first"})",
    R"({"command":"train"})",
    R"({"command":"stop_training"})",
    R"({"command":"dismiss"})"};

TEST_F(MotionThread, NothingMovesBeforeStart) {
  for (const bool is_planned : {false, true}) {
    ViewSource body = is_planned ? planned() : source();
    body.systems = {testing::view_system(testing::crossed_system(), "first")};
    ViewSession session(std::move(body), viewed());
    session.start();
    come_and_go(session);
    const auto viewer = session.hub().subscribe(4);
    for (const std::string& other : kOthers) {
      static_cast<void>(session.command(other));
      settle(session);
      EXPECT_EQ(state_of(session)["awaits_start"], true) << other;
      EXPECT_EQ(moves_->begun, 0U) << other;
    }
    come_and_go(session);
    session.stop();  // and what had begun nevertheless would be counted now
    EXPECT_EQ(moves_->begun, 0U);
    EXPECT_EQ(moves_->steps, 0U);
  }
}

TEST_F(MotionThread, StartBeginsOneExplorationAndNothingBeginsTheNext) {
  ViewSession session(source(), viewed());
  session.start();
  const auto viewer = session.hub().subscribe(4);
  command(session, kStart);
  EXPECT_EQ(state_of(session)["awaits_start"], false);
  ASSERT_TRUE(eventually([&] { return explored(session) == 1; }));
  come_and_go(session);
  for (const std::string& other : kOthers) static_cast<void>(session.command(other));
  come_and_go(session);
  EXPECT_EQ(moves_->begun, 1U);
  command(session, kStart);
  ASSERT_TRUE(eventually([&] { return explored(session) == 2; }));
  session.stop();
  EXPECT_EQ(moves_->begun, 2U);
  EXPECT_EQ(moves_->steps, 20U);
}

TEST_F(MotionThread, StartBeginsThePlanWhichThenGoesOn) {
  ViewSession session(planned(), viewed());
  session.start();
  EXPECT_FALSE(session.command(R"({"command":"play"})"));
  command(session, kStart);
  EXPECT_TRUE(eventually([&] { return explored(session) == 3; }));
  EXPECT_FALSE(session.command(kStart)) << "the plan is fixed";
  session.stop();
  EXPECT_EQ(moves_->begun, 3U);
}

// The command line said so.
TEST_F(MotionThread, WithoutAViewItBeginsAtOnce) {
  ViewSession session(planned(), {false, kFastest});
  session.start();
  EXPECT_TRUE(eventually([&] { return explored(session) == 3; }));
}

TEST_F(MotionThread, APauseHoldsABodyUntilACommand) {
  ViewSession session(source(1000), viewed());
  session.start();
  command(session, kStart);
  ASSERT_TRUE(eventually([&] { return state_of(session)["live"] == true; }));
  command(session, R"({"command":"pause"})");
  settle(session);
  const auto frame = testing::frame_of(session);
  come_and_go(session);
  for (const std::string other : {R"({"command":"speed","speed":2})", R"({"command":"dismiss"})",
                                  R"({"command":"name","label":"object","value":"ball"})"}) {
    command(session, other);
  }
  settle(session);
  EXPECT_EQ(testing::frame_of(session), frame);
  session.stop();
  EXPECT_EQ(moves_->begun, 1U);
}

TEST_F(MotionThread, NothingMovesAfterAFaultUntilAViewerStartsAgain) {
  moves_->failures = 1;
  ViewSession session(planned(), viewed());
  session.start();
  const auto viewer = session.hub().subscribe(4);
  command(session, kStart);
  ASSERT_TRUE(eventually([&] { return state_of(session)["problem"] != nullptr; }));
  come_and_go(session);
  for (const std::string& other : kOthers) static_cast<void>(session.command(other));
  come_and_go(session);
  EXPECT_EQ(state_of(session)["awaits_start"], true);
  EXPECT_EQ(moves_->begun, 1U);
  EXPECT_EQ(moves_->resumed, 0U);
  command(session, kStart);
  EXPECT_TRUE(eventually([&] { return explored(session) == 2; })) << "the rest of the plan";
  session.stop();
  EXPECT_EQ(moves_->begun, 3U);
  EXPECT_EQ(moves_->resumed, 1U);
}

// While the body holds, the page does not show the fault yet: this press was not meant for it.
TEST_F(MotionThread, APressOfStartBeforeTheFaultIsShownPermitsNothing) {
  moves_->failures = 1;
  moves_->may_end = false;
  ViewSession session(source(), viewed());
  session.start();
  const auto viewer = session.hub().subscribe(4);
  command(session, kStart);
  ASSERT_TRUE(eventually([&] { return moves_->holds.load(); }));
  command(session, kStart);
  moves_->may_end = true;
  EXPECT_TRUE(eventually([&] { return state_of(session)["problem"] != nullptr; }));
  come_and_go(session);
  EXPECT_EQ(state_of(session)["awaits_start"], true);
  EXPECT_EQ(moves_->resumed, 0U);
  EXPECT_EQ(moves_->begun, 1U);
  session.stop();
}

// Two viewers who press at once: one after the other is done, and one thread has the line.
TEST_F(MotionThread, TwoViewersThatStartAtOnceMoveOneBody) {
  ViewSession session(source(200), viewed());
  session.start();
  std::vector<std::thread> viewers;
  for (int viewer = 0; viewer < 2; ++viewer) {
    viewers.emplace_back([&] {
      for (int i = 0; i < 20; ++i) static_cast<void>(session.command(kStart));
    });
  }
  for (std::thread& viewer : viewers) viewer.join();
  ASSERT_TRUE(eventually([&] { return explored(session) >= 1; }));
  session.stop();
  EXPECT_GE(moves_->begun, 1U);
  EXPECT_LE(moves_->begun, 40U);
}

// It moves without real hands.
TEST_F(MotionThread, ASimulatedBodyBeginsWithTheFirstViewer) {
  ViewSession session(testing::body_source(), viewed());
  session.start();
  EXPECT_EQ(state_of(session)["awaits_start"], false);
  const auto viewer = session.hub().subscribe(1);
  EXPECT_TRUE(eventually([&] { return explored(session) == 1; }));
}

}  // namespace
}  // namespace somato
