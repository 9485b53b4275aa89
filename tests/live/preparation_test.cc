#include "live/preparation.h"

#include <gtest/gtest.h>

#include <functional>
#include <future>
#include <thread>
#include <utility>
#include <vector>

#include "live/sessions.h"
#include "live/view_systems.h"
#include "live/viewing.h"

namespace somato {
namespace {

using testing::command;
using testing::crossed_system;
using testing::eventually;
using testing::state_of;

Recording labelled(std::size_t explorations) {
  return testing::hand_source(explorations).recording;
}

// The result of each round of a preparation that ends by itself.
std::vector<Result<live::Prepared>> prepared(PriorExplorations explorations) {
  std::vector<Result<live::Prepared>> rounds;
  std::promise<void> done;
  live::Preparation preparation;
  preparation.start(testing::view_system(crossed_system()), std::move(explorations), 1,
                    [&](const Result<live::Prepared>& result) {
                      rounds.push_back(result);
                      if (!result || result->is_last) done.set_value();
                    });
  done.get_future().wait();
  return rounds;
}

TEST(PreparationThread, TrainsTheSystemAfterEachRound) {
  const auto rounds = prepared({2, [](std::size_t round, const auto&) -> Result<Recording> {
                                  return labelled(4 + 2 * round);
                                }});
  ASSERT_EQ(rounds.size(), 2U);
  EXPECT_FALSE(rounds[0]->is_last);
  EXPECT_EQ(*rounds[0]->recording, labelled(4));
  Recording all = labelled(4);
  for (const Exploration& one : labelled(6).explorations) all.explorations.push_back(one);
  EXPECT_EQ(*rounds[1]->recording, all);
  const auto expected = testing::trained_model(crossed_system(), all);
  EXPECT_EQ(rounds[1]->model->answer->labels, expected->answer->labels);
}

TEST(PreparationThread, PassesErrorsOn) {
  const auto failed = prepared({2, [](std::size_t, const auto&) -> Result<Recording> {
                                  return fail(ErrorKind::kData, "too far away");
                                }});
  ASSERT_EQ(failed.size(), 1U);
  EXPECT_EQ(failed[0].error().what, "too far away");
  const auto single =
      prepared({1, [](std::size_t, const auto&) -> Result<Recording> { return labelled(1); }});
  EXPECT_FALSE(single[0]);
}

TEST(PreparationThread, EndsWhenItIsStopped) {
  live::Preparation preparation;
  std::promise<ErrorKind> done;
  const PriorExplorations explorations{
      1, [](std::size_t, const std::function<bool()>& should_continue) -> Result<Recording> {
        while (should_continue()) std::this_thread::yield();
        return fail(ErrorKind::kInterrupted, "stopped");
      }};
  preparation.start(
      testing::view_system(crossed_system()), explorations, 1,
      [&](const Result<live::Prepared>& result) { done.set_value(result.error().kind); });
  preparation.stop();
  EXPECT_EQ(done.get_future().get(), ErrorKind::kInterrupted);
}

// The system is used as soon as it is there; others learn from the same explorations.
TEST(PreparationThread, GivesAViewItsFirstSystem) {
  ViewSource source = testing::hand_source(2);
  source.prior_explorations = {
      1, [](std::size_t, const auto&) -> Result<Recording> { return labelled(6); }};
  source.systems = {testing::view_system(crossed_system(), "first"),
                    testing::view_system(testing::two_maps_system(), "second")};
  source.system = 0;
  ViewSession session(std::move(source), testing::at_once());
  session.start();
  ASSERT_TRUE(eventually([&] { return state_of(session)["training"] == false; }));
  EXPECT_EQ(state_of(session)["system_problem"], nullptr);
  EXPECT_EQ(state_of(session)["maps"][0]["classes"].size(), 2U);
  command(session, R"({"command":"system","name":"second"})");
  command(session, R"({"command":"train"})");
  ASSERT_TRUE(eventually([&] { return state_of(session)["training"] == false; }));
  EXPECT_EQ(state_of(session)["system_problem"], nullptr);
}

}  // namespace
}  // namespace somato
