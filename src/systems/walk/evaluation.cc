#include "somato/graph/evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <optional>
#include <utility>

#include "base/core/memory.h"
#include "base/core/threads.h"
#include "systems/walk/walk.h"

namespace somato {
namespace {

std::string place_of(const Recording& recording, std::size_t exploration) {
  const std::string& source = recording.explorations[exploration].source;
  return source.empty() ? fmt::format("exploration {}", exploration + 1) : source;
}

// The error of the exploration that comes first, whichever thread was first to fail.
class FirstError {
 public:
  void keep(std::size_t exploration, Error error) {
    const std::scoped_lock lock(mutex_);
    if (error_ && exploration_ < exploration) return;
    exploration_ = exploration;
    error_ = std::move(error);
  }
  const std::optional<Error>& error() const { return error_; }

 private:
  std::mutex mutex_;
  std::size_t exploration_ = 0;
  std::optional<Error> error_;
};

// The stored outputs of all explorations must fit into the memory that was free at the start;
// otherwise the program could be killed without a message.
class MemoryBudget {
 public:
  Result<void> take(const System& system, std::size_t module, const Sequence& output) {
    const std::size_t taken = taken_ += output.values.bytes();
    if (taken <= free_) return {};
    is_spent_ = true;
    return fail(system.at_module({ErrorKind::kSystem,
                                  fmt::format("its output, with that of other modules, needs more "
                                              "than the {} of memory that were free",
                                              memory_text(static_cast<double>(free_))),
                                  {},
                                  "reduce the number of its elements, or use fewer explorations"},
                                 module));
  }

  bool is_spent() const { return is_spent_; }

 private:
  std::size_t free_ = free_memory();
  std::atomic<bool> is_spent_ = false;
  std::atomic<std::size_t> taken_ = 0;
};

}  // namespace

Result<void> evaluate(const System& system, const Recording& recording,
                      std::span<const std::size_t> explorations,
                      const std::vector<std::size_t>& wanted, std::size_t threads,
                      Activations& activations) {
  FirstError first;
  MemoryBudget budget;
  for_each_task(explorations.size(), threads, [&](std::size_t task) {
    if (budget.is_spent()) return;
    const std::size_t exploration = explorations[task];
    const auto known = [&](std::size_t module) { return activations.find(module, exploration); };
    Walk walk(system, wanted, Outputs::kAll,
              [&](std::size_t module) { return known(module) != nullptr; });
    auto walked = walk.start(&recording.explorations[exploration], known);
    if (walked) walked = walk.run();
    if (!walked) {
      Error error = std::move(walked.error());
      error.where = place_of(recording, exploration) + ", " + error.where;
      first.keep(exploration, std::move(error));
      return;
    }
    for (const std::size_t module : wanted) {
      if (activations.find(module, exploration)) continue;
      auto output = std::make_shared<const Sequence>(walk.take(module));
      if (auto fits = budget.take(system, module, *output); !fits) {
        first.keep(exploration, std::move(fits.error()));
        return;
      }
      activations.set(module, exploration, std::move(output));
    }
  });
  if (first.error()) return fail(*first.error());
  return {};
}

std::vector<std::size_t> ExplorationValues::places_of(std::span<const std::size_t> wanted) const {
  std::vector<std::size_t> places;
  places.reserve(wanted.size());
  for (const std::size_t one : wanted) {
    const auto place = std::lower_bound(explorations.begin(), explorations.end(), one);
    places.push_back(static_cast<std::size_t>(place - explorations.begin()));
  }
  return places;
}

const ExplorationValues& Activations::values_of(std::size_t module) {
  std::vector<std::size_t> explorations;
  for (std::size_t exploration = 0; exploration < known_[module].size(); ++exploration) {
    if (known_[module][exploration]) explorations.push_back(exploration);
  }
  auto& values = values_[module];
  if (values && values->explorations == explorations) return *values;
  std::vector<Signal> signals;
  signals.reserve(explorations.size());
  for (const std::size_t exploration : explorations) {
    signals.push_back(Signal::copy_of(known_[module][exploration]->values[0]));
  }
  values = std::make_shared<const ExplorationValues>(
      ExplorationValues{std::move(explorations), Samples::from_signals(signals)});
  return *values;
}

std::vector<std::size_t> fixed_inputs(const System& system, const std::vector<std::size_t>& also) {
  std::vector<bool> is_wanted(system.modules().size(), false);
  for (const std::size_t module : also) is_wanted[module] = system.is_fixed(module);
  for (std::size_t module = 0; module < system.modules().size(); ++module) {
    if (system.is_fixed(module)) continue;
    for (const std::size_t input : system.modules()[module].inputs) {
      is_wanted[input] = is_wanted[input] || system.is_fixed(input);
    }
  }
  std::vector<std::size_t> wanted;
  for (std::size_t module = 0; module < is_wanted.size(); ++module) {
    if (is_wanted[module]) wanted.push_back(module);
  }
  return wanted;
}

Result<Activations> evaluate_fixed(const System& system, const Recording& recording,
                                   const std::vector<std::size_t>& also, std::size_t threads) {
  std::vector<std::size_t> explorations(recording.explorations.size());
  for (std::size_t i = 0; i < explorations.size(); ++i) explorations[i] = i;
  Activations activations(system.modules().size(), explorations.size());
  SOMATO_TRY_VOID(
      evaluate(system, recording, explorations, fixed_inputs(system, also), threads, activations));
  return activations;
}

}  // namespace somato
