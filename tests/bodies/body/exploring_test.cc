#include "somato/bodies/exploring.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <chrono>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "somato/core/check.h"

namespace somato {
namespace {

using Names = std::vector<std::string>;

Exploration exploration_named(std::size_t item, std::size_t trial) {
  return Exploration{{{"name", fmt::format("{}.{}", item, trial)}}, "", {}};
}

std::string name_of(const Exploration& exploration) {
  return exploration.labels.front().value;
}

// Explores by a function.
class FunctionExplorer : public SimulatedExplorer {
 public:
  FunctionExplorer(std::size_t items, Explore explore)
      : SimulatedExplorer(std::vector<ExploredThing>(items), ""), explore_(std::move(explore)) {}

 protected:
  Result<Exploration> simulate(std::size_t thing, std::size_t trial,
                               const ExploreOptions&) const override {
    return explore_(thing, trial);
  }

 private:
  Explore explore_;
};

struct Plan {
  std::size_t items = 0;
  std::size_t each = 1;
  std::size_t threads = 1;
};

Result<ExploringOutcome> explore_all(const Plan& plan, const Explore& explore,
                                     const ExplorationSink& sink, const Progress& progress = {}) {
  return somato::explore_all(FunctionExplorer(plan.items, explore), {plan.each}, plan.threads, {},
                             sink, progress);
}

// Keeps the names of what comes.
struct Keeper {
  Names names;
  ExplorationSink sink() {
    return [this](Exploration&& exploration) -> Result<void> {
      names.push_back(name_of(exploration));
      return {};
    };
  }
};

// Those of items x each in order, up to `count`.
Names in_order(std::size_t count, std::size_t each) {
  Names names;
  for (std::size_t i = 0; i < count; ++i)
    names.push_back(name_of(exploration_named(i / each, i % each)));
  return names;
}

// Lets the other threads go on. A number of yields would take minutes beside busy processes, each
// of which runs for some milliseconds before it yields.
void yield_for(std::chrono::milliseconds duration) {
  const auto end = std::chrono::steady_clock::now() + duration;
  do {
    std::this_thread::yield();
  } while (std::chrono::steady_clock::now() < end);
}

// Explorations that finish in another order than they began: the first of four waits for the other
// ones, as far as threads allow.
Result<Exploration> uneven(std::size_t item, std::size_t trial) {
  yield_for(std::chrono::milliseconds((item + trial) % 4 == 0 ? 1 : 0));
  return exploration_named(item, trial);
}

TEST(ExploreAllThreads, HandOnInOrderWhateverTheirNumber) {
  for (std::size_t threads = 1; threads <= 4; ++threads) {
    Keeper keeper;
    const auto outcome = explore_all({7, 5, threads}, uneven, keeper.sink());
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->recorded, 35U);
    EXPECT_TRUE(outcome->failures.empty());
    EXPECT_EQ(keeper.names, in_order(35, 5));
  }
}

TEST(ExploreAllThreads, EachIsExploredOnce) {
  std::array<std::atomic<int>, 12> times{};
  Keeper keeper;
  ASSERT_TRUE(explore_all(
      {4, 3, 3},
      [&](std::size_t item, std::size_t trial) -> Result<Exploration> {
        ++times[item * 3 + trial];
        return exploration_named(item, trial);
      },
      keeper.sink()));
  for (const auto& count : times) EXPECT_EQ(count, 1);
}

TEST(ExploreAll, NothingToDoIsDone) {
  Keeper keeper;
  for (const Plan& plan : {Plan{0, 5, 2}, {5, 0, 2}}) {
    const auto outcome = explore_all(plan, uneven, keeper.sink());
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->recorded, 0U);
  }
  EXPECT_TRUE(keeper.names.empty());
}

TEST(ExploreAllThreads, AFailureIsListedAndNotRecorded) {
  for (std::size_t threads = 1; threads <= 4; ++threads) {
    Keeper keeper;
    const auto outcome = explore_all(
        {4, 3, threads},
        [](std::size_t item, std::size_t trial) -> Result<Exploration> {
          if ((item * 3 + trial) % 5 != 0) return uneven(item, trial);
          return fail(ErrorKind::kData, fmt::format("it flew away {} {}", item, trial));
        },
        keeper.sink());
    ASSERT_TRUE(outcome);
    EXPECT_EQ(keeper.names, (Names{"0.1", "0.2", "1.0", "1.1", "2.0", "2.1", "2.2", "3.0", "3.2"}));
    EXPECT_EQ(outcome->recorded, 9U);
    ASSERT_EQ(outcome->failures.size(), 3U);
    EXPECT_EQ(outcome->failures[0].error.what, "it flew away 0 0");
    EXPECT_EQ(outcome->failures[1].thing, 1U);
    EXPECT_EQ(outcome->failures[1].trial, 2U);
    EXPECT_EQ(outcome->failures[2].error.what, "it flew away 3 1");
  }
}

TEST(ExploreAllThreads, AnUnavailableBodyIsTheLastFailure) {
  for (std::size_t threads = 1; threads <= 4; ++threads) {
    Keeper keeper;
    const auto outcome = explore_all(
        {40, 3, threads},
        [](std::size_t item, std::size_t trial) -> Result<Exploration> {
          if (item == 0 && trial == 1) return fail(ErrorKind::kSystem, "it flew away");
          if (item > 0) return fail(ErrorKind::kUnavailable, "it is gone");
          return uneven(item, trial);
        },
        keeper.sink());
    ASSERT_TRUE(outcome);
    EXPECT_EQ(keeper.names, (Names{"0.0", "0.2"}));
    EXPECT_EQ(outcome->recorded, 2U);
    ASSERT_EQ(outcome->failures.size(), 2U);
    EXPECT_EQ(outcome->failures[0].error.what, "it flew away");
    EXPECT_EQ(outcome->failures[1].error.what, "it is gone");
  }
}

TEST(ExploreAllThreads, NoneIsBegunFarAheadOfTheSink) {
  for (std::size_t threads = 1; threads <= 4; ++threads) {
    std::atomic<std::size_t> taken = 0;
    std::atomic<std::size_t> furthest = 0;
    const auto outcome = explore_all(
        {40, 1, threads},
        [&](std::size_t item, std::size_t trial) {
          const std::size_t ahead = item - taken;
          std::size_t known = furthest;
          while (ahead > known && !furthest.compare_exchange_weak(known, ahead)) {
          }
          return uneven(item, trial);
        },
        [&](Exploration&&) -> Result<void> {
          ++taken;
          return {};
        });
    ASSERT_TRUE(outcome);
    // Counted in the sink before the queue knows, so that nothing looks further ahead than it was.
    EXPECT_LT(furthest, 2 * threads);
  }
}

// The first exploration ends only when others can go on no more: what is ahead of the sink fills
// up and waits. With 3 threads, 0 waits for 1 .. 5 to have ended.
TEST(ExploreAllThreads, ThoseAheadWaitForTheFirst) {
  std::atomic<std::size_t> ended = 0;
  std::atomic<std::size_t> most_before_first = 0;
  Keeper keeper;
  const auto outcome = explore_all(
      {30, 1, 3},
      [&](std::size_t item, std::size_t trial) -> Result<Exploration> {
        if (item == 0) {
          while (ended < 5) std::this_thread::yield();
          yield_for(std::chrono::milliseconds(5));
          most_before_first = ended.load();
        }
        ++ended;
        return exploration_named(item, trial);
      },
      keeper.sink());
  ASSERT_TRUE(outcome);
  EXPECT_EQ(most_before_first, 5U);
  EXPECT_EQ(keeper.names, in_order(30, 1));
}

TEST(ExploreAllThreads, AFailingSinkStopsAll) {
  for (std::size_t threads = 1; threads <= 4; ++threads) {
    Names names;
    std::atomic<std::size_t> begun = 0;
    const auto outcome = explore_all(
        {100, 1, threads},
        [&](std::size_t item, std::size_t trial) {
          ++begun;
          return uneven(item, trial);
        },
        [&](Exploration&& exploration) -> Result<void> {
          if (name_of(exploration) == "7.0") return fail(ErrorKind::kSystem, "the disk is full");
          names.push_back(name_of(exploration));
          return {};
        });
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.error().what, "the disk is full");
    EXPECT_EQ(names, in_order(7, 1));
    EXPECT_LE(begun, 7 + 2 * threads);
  }
}

TEST(ExploreAllThreads, ProgressComesInOrder) {
  for (std::size_t threads = 1; threads <= 4; ++threads) {
    std::vector<std::uint64_t> seen;
    Keeper keeper;
    const auto explore = [](std::size_t item, std::size_t trial) -> Result<Exploration> {
      if (item == 1) return fail(ErrorKind::kData, "it flew away");
      return uneven(item, trial);
    };
    ASSERT_TRUE(explore_all({3, 2, threads}, explore, keeper.sink(),
                            [&](std::uint64_t done, std::uint64_t total) {
                              seen.push_back(done);
                              EXPECT_EQ(total, 6U);
                              return true;
                            }));
    EXPECT_EQ(seen, (std::vector<std::uint64_t>{0, 1, 2, 3, 4, 5, 6}));
  }
}

TEST(ExploreAllThreads, InterruptedAllThatCameBeforeIsThere) {
  for (std::size_t threads = 1; threads <= 4; ++threads) {
    for (const std::uint64_t last : {0U, 1U, 9U}) {
      Keeper keeper;
      const auto outcome =
          explore_all({50, 1, threads}, uneven, keeper.sink(),
                      [&](std::uint64_t done, std::uint64_t) { return done < last; });
      ASSERT_FALSE(outcome);
      EXPECT_EQ(outcome.error().kind, ErrorKind::kInterrupted);
      EXPECT_EQ(keeper.names, in_order(last, 1));
    }
  }
}

TEST(ExploreAllThreads, AnExplorationThatIsInterruptedStopsAll) {
  Keeper keeper;
  const auto outcome = explore_all(
      {20, 1, 2},
      [](std::size_t item, std::size_t trial) -> Result<Exploration> {
        if (item == 4) return fail(ErrorKind::kInterrupted, "a stop was requested");
        return exploration_named(item, trial);
      },
      keeper.sink());
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().what, "a stop was requested");
  EXPECT_EQ(keeper.names, in_order(4, 1));
}

TEST(ExploreAllThreads, AnExceptionIsRethrownWithoutWaiting) {
  for (std::size_t threads = 1; threads <= 4; ++threads) {
    Keeper keeper;
    const auto explore = [](std::size_t item, std::size_t trial) -> Result<Exploration> {
      if (item == 3) throw std::runtime_error("broken");
      return uneven(item, trial);
    };
    EXPECT_THROW((void)explore_all({60, 1, threads}, explore, keeper.sink()), std::runtime_error);
    EXPECT_LE(keeper.names.size(), 3U);
  }
}

// The others have filled what is ahead of the third one and wait for it when it throws.
TEST(ExploreAllThreads, AnExceptionWakesThoseWhoWait) {
  for (std::size_t threads = 2; threads <= 4; ++threads) {
    Keeper keeper;
    std::atomic<std::size_t> ended = 0;
    const auto explore = [&](std::size_t item, std::size_t trial) -> Result<Exploration> {
      if (item == 3) {
        while (ended < 2 + 2 * threads) std::this_thread::yield();
        yield_for(std::chrono::milliseconds(5));
        throw std::runtime_error("broken");
      }
      ++ended;
      return exploration_named(item, trial);
    };
    EXPECT_THROW((void)explore_all({60, 1, threads}, explore, keeper.sink()), std::runtime_error);
    EXPECT_EQ(keeper.names, in_order(3, 1));
  }
}

TEST(ExploreAll, NoSinkAndUnknownThingsAreMistakesOfTheCaller) {
  Keeper keeper;
  EXPECT_THROW((void)explore_all({1, 1, 1}, uneven, {}), InvalidArgument);
  EXPECT_THROW(
      (void)somato::explore_all(FunctionExplorer(2, uneven), {1, 0, {{2}}}, 1, {}, keeper.sink()),
      InvalidArgument);
}

TEST(ExploreAll, ExploresTheThingsAndTrialsOfThePlan) {
  Keeper keeper;
  const auto outcome =
      somato::explore_all(FunctionExplorer(5, uneven), {2, 7, {{3, 1}}}, 2, {}, keeper.sink());
  ASSERT_TRUE(outcome);
  EXPECT_EQ(keeper.names, (Names{"3.7", "3.8", "1.7", "1.8"}));
}

// Which thread explores is seen by a body that is used by one.
class OneThreadExplorer : public Explorer {
 public:
  OneThreadExplorer() : Explorer(std::vector<ExploredThing>(6), "") {}

  std::set<std::thread::id> threads;
  std::size_t explored = 0;  // unprotected, so that the thread sanitizer sees a second thread

 protected:
  Result<Exploration> explore_thing(std::size_t thing, std::size_t trial,
                                    const ExploreOptions&) override {
    threads.insert(std::this_thread::get_id());
    ++explored;
    return exploration_named(thing, trial);
  }
};

TEST(ExploreAllThreads, ABodyThatMayBeRealIsExploredByTheCallingThread) {
  OneThreadExplorer explorer;
  Keeper keeper;
  ASSERT_TRUE(somato::explore_all(explorer, {2}, {}, keeper.sink()));
  EXPECT_EQ(keeper.names, in_order(12, 2));
  EXPECT_EQ(explorer.explored, 12U);
  EXPECT_EQ(explorer.threads, std::set<std::thread::id>{std::this_thread::get_id()});
}

TEST(ExploreAll, AFunctionMayExploreInTurn) {
  OneThreadExplorer explorer;
  Keeper keeper;
  ASSERT_TRUE(explore_in_turn(
      explorer, {1, 3, {{4, 2}}},
      [&](std::size_t thing, std::size_t trial) { return explorer.explore(thing, trial); },
      keeper.sink()));
  EXPECT_EQ(keeper.names, (Names{"4.3", "2.3"}));
  EXPECT_EQ(explorer.threads, std::set<std::thread::id>{std::this_thread::get_id()});
  EXPECT_THROW((void)explore_in_turn(explorer, {}, {}, keeper.sink()), InvalidArgument);
}

// No call explores such a body in other threads, nor one that is constant: the types refuse it.
template <typename Explorer>
concept ExploredInThreads = requires(Explorer& explorer, const ExplorationSink& sink) {
  somato::explore_all(explorer, {}, std::size_t{2}, ExploreOptions{}, sink);
};
template <typename Explorer>
concept ExploredInTurn = requires(Explorer& explorer, const ExplorationSink& sink) {
  somato::explore_all(explorer, {}, ExploreOptions{}, sink);
};
static_assert(ExploredInThreads<const FunctionExplorer>);
static_assert(!ExploredInThreads<Explorer>);
static_assert(!ExploredInThreads<OneThreadExplorer>);
static_assert(ExploredInTurn<OneThreadExplorer>);
static_assert(!ExploredInTurn<const OneThreadExplorer>);

}  // namespace
}  // namespace somato
