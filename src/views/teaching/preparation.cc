#include "views/teaching/preparation.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <iterator>
#include <utility>

#include "base/core/threads.h"
#include "somato/bodies/exploring.h"
#include "views/teaching/map_training.h"

namespace somato::live {
namespace {

Result<Prepared> train(const ViewSystem& system, const Recording& explored, std::uint64_t seed,
                       const std::function<bool()>& should_continue) {
  Prepared prepared;
  prepared.recording = std::make_shared<const Recording>(explored);
  SOMATO_TRY(prepared.model,
             train_visibly(
                 system, *prepared.recording, seed,
                 [&](const TrainingSnapshot&) { return should_continue(); }, should_continue));
  return prepared;
}

// Each of the things once; those whose exploration fails are left out.
Result<Recording> explore(const PriorExplorations& explorations, std::size_t round,
                          const std::function<bool()>& should_continue) {
  Recording recording;
  ExploreOptions options;
  options.limits.should_continue = should_continue;
  SOMATO_TRY(auto outcome, explore_all(
                               *explorations.explorer, {1, round, explorations.things},
                               available_threads(), options,
                               [&](Exploration&& exploration) -> Result<void> {
                                 recording.explorations.push_back(std::move(exploration));
                                 return {};
                               },
                               [&](std::uint64_t, std::uint64_t) { return should_continue(); }));
  if (!recording.explorations.empty() || outcome.failures.empty()) return recording;
  return fail(std::move(outcome.failures.front().error));
}

// The view has a higher priority. The threads that this one starts have the same priority.
void yield_to_others() {
  constexpr int kNice = 10;
  ::setpriority(PRIO_PROCESS, 0, kNice);
}

}  // namespace

// An internal error must not end the program.
void Preparation::start(ViewSystem system, PriorExplorations explorations, std::uint64_t seed,
                        Done done) {
  thread_ = std::thread([this, seed, system = std::move(system),
                         explorations = std::move(explorations), done = std::move(done)] {
    try {
      yield_to_others();
      const auto prepared = prepare(system, explorations, seed, done);
      if (!prepared) done(fail(prepared.error()));
    } catch (const std::exception& error) {
      done(fail(ErrorKind::kData, fmt::format("the training failed: {}", error.what())));
    }
  });
}

Result<void> Preparation::prepare(const ViewSystem& system, const PriorExplorations& explorations,
                                  std::uint64_t seed, const Done& done) const {
  const std::function<bool()> should_continue = [this] { return !stopping_; };
  Recording explored;
  for (std::size_t round = 0; round < explorations.rounds; ++round) {
    SOMATO_TRY(auto more, explore(explorations, round, should_continue));
    std::move(more.explorations.begin(), more.explorations.end(),
              std::back_inserter(explored.explorations));
    SOMATO_TRY(auto prepared, train(system, explored, seed, should_continue));
    prepared.is_last = round + 1 == explorations.rounds;
    done(std::move(prepared));
  }
  return {};
}

void Preparation::stop() {
  stopping_ = true;
  if (thread_.joinable()) thread_.join();
}

}  // namespace somato::live
