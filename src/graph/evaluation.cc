#include "somato/graph/evaluation.h"

#include <fmt/format.h>

#include <atomic>
#include <mutex>
#include <optional>

#include "graph/exploration_run.h"
#include "somato/core/memory.h"
#include "somato/core/threads.h"

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

// What is kept of all explorations must fit into the memory that was free at the start: a system
// that takes more would end the program without a word.
class MemoryBudget {
 public:
  Result<void> take(const System& system, std::size_t module, const Sequence& output) {
    const std::size_t taken = taken_ += output.values.bytes();
    if (taken <= free_) return {};
    is_spent_ = true;
    return fail(system.at_module(
        {ErrorKind::kSystem,
         fmt::format("what is kept of its output and others takes more than {} of memory, all that "
                     "was free",
                     memory_text(static_cast<double>(free_))),
         {},
         "give it fewer elements, or use fewer explorations"},
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
  std::vector<bool> is_wanted(system.modules().size(), false);
  for (const std::size_t module : wanted) is_wanted[module] = true;
  FirstError first;
  MemoryBudget budget;
  for_each_task(explorations.size(), threads, [&](std::size_t task) {
    if (budget.is_spent()) return;
    const std::size_t exploration = explorations[task];
    ExplorationRun run(system, &recording.explorations[exploration],
                       [&](std::size_t module) { return activations.find(module, exploration); });
    if (auto computed = run.compute(is_wanted); !computed) {
      Error error = std::move(computed.error());
      error.where = place_of(recording, exploration) + ", " + error.where;
      first.keep(exploration, std::move(error));
      return;
    }
    for (const std::size_t module : wanted) {
      if (activations.find(module, exploration)) continue;
      auto output = run.take(module);
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
  auto evaluated =
      evaluate(system, recording, explorations, fixed_inputs(system, also), threads, activations);
  if (!evaluated) return fail(std::move(evaluated.error()));
  return activations;
}

}  // namespace somato
