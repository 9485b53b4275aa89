#include "views/teaching/preparation.h"

#include <gtest/gtest.h>

#include <functional>
#include <future>
#include <thread>
#include <utility>
#include <vector>

#include "views/live/sessions.h"
#include "views/live/view_systems.h"
#include "views/live/viewing.h"

namespace somato {
namespace {

using testing::command;
using testing::crossed_system;
using testing::eventually;
using testing::state_of;

Recording labelled(std::size_t explorations) {
  Recording recording = testing::hand_source(explorations).recording;
  for (Exploration& one : recording.explorations) one.source = "prior";
  return recording;
}

using Explore = std::function<Result<Exploration>(std::size_t thing, std::size_t round,
                                                  const std::function<bool()>& should_continue)>;

// Explores by a function.
class PriorExplorer : public SimulatedExplorer {
 public:
  PriorExplorer(std::size_t things, Explore explore)
      : SimulatedExplorer(std::vector<ExploredThing>(things), "prior"),
        explore_(std::move(explore)) {}

 protected:
  Result<Exploration> simulate(std::size_t thing, std::size_t trial,
                               const ExploreOptions& options) const override {
    return explore_(thing, trial, options.limits.should_continue);
  }

 private:
  Explore explore_;
};

PriorExplorations prior(std::size_t rounds, std::size_t things, Explore explore) {
  PriorExplorations explorations{
      rounds, std::make_shared<PriorExplorer>(things, std::move(explore)), {}};
  for (std::size_t i = 0; i < things; ++i) explorations.things.push_back(i);
  return explorations;
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
  const Recording all = labelled(8);
  const auto rounds = prepared(prior(2, 4, [&](std::size_t thing, std::size_t round, const auto&) {
    return Result<Exploration>(all.explorations[4 * round + thing]);
  }));
  ASSERT_EQ(rounds.size(), 2U);
  EXPECT_FALSE(rounds[0]->is_last);
  EXPECT_EQ(*rounds[0]->recording, labelled(4));
  EXPECT_EQ(*rounds[1]->recording, all);
  const auto expected = testing::trained_model(crossed_system(), all);
  EXPECT_EQ(rounds[1]->model->answer->labels, expected->answer->labels);
}

TEST(PreparationThread, ExploresTheGivenThingsOnly) {
  const Recording all = labelled(8);
  auto explorations = prior(1, 8, [&](std::size_t thing, std::size_t, const auto&) {
    return Result<Exploration>(all.explorations[thing]);
  });
  explorations.things = {1, 2, 5, 6};
  const auto rounds = prepared(std::move(explorations));
  ASSERT_EQ(rounds.size(), 1U);
  ASSERT_TRUE(rounds[0]) << to_string(rounds[0].error());
  ASSERT_EQ(rounds[0]->recording->explorations.size(), 4U);
  EXPECT_EQ(rounds[0]->recording->explorations[2], all.explorations[5]);
}

TEST(PreparationThread, PassesErrorsOn) {
  const auto failed = prepared(prior(2, 1, [](std::size_t, std::size_t, const auto&) {
    return Result<Exploration>(fail(ErrorKind::kData, "too far away"));
  }));
  ASSERT_EQ(failed.size(), 1U);
  EXPECT_EQ(failed[0].error().what, "too far away");
  const auto single = prepared(prior(1, 1, [](std::size_t, std::size_t, const auto&) {
    return Result<Exploration>(labelled(1).explorations[0]);
  }));
  EXPECT_FALSE(single[0]);
}

TEST(PreparationThread, EndsWhenItIsStopped) {
  live::Preparation preparation;
  std::promise<ErrorKind> done;
  const auto explorations =
      prior(1, 1, [](std::size_t, std::size_t, const auto& should_continue) -> Result<Exploration> {
        while (should_continue()) std::this_thread::yield();
        return fail(ErrorKind::kInterrupted, "stopped");
      });
  preparation.start(
      testing::view_system(crossed_system()), explorations, 1,
      [&](const Result<live::Prepared>& result) { done.set_value(result.error().kind); });
  preparation.stop();
  EXPECT_EQ(done.get_future().get(), ErrorKind::kInterrupted);
}

// The system is used as soon as it is there; others learn from the same explorations.
TEST(PreparationThread, GivesAViewItsFirstSystem) {
  ViewSource source = testing::hand_source(2);
  source.prior_explorations = prior(1, 6, [](std::size_t thing, std::size_t, const auto&) {
    return Result<Exploration>(labelled(6).explorations[thing]);
  });
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
