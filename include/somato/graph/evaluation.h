#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "somato/core/result.h"
#include "somato/graph/system.h"
#include "somato/recording/recording.h"

namespace somato {

/// What modules gave for explorations, as far as it is known. Copies share what they hold.
class Activations {
 public:
  Activations() = default;
  Activations(std::size_t modules, std::size_t explorations)
      : known_(modules, std::vector<std::shared_ptr<const Sequence>>(explorations)) {}

  /// What the module gave for the exploration, or nullptr.
  const Sequence* find(std::size_t module, std::size_t exploration) const {
    return known_[module][exploration].get();
  }

  void set(std::size_t module, std::size_t exploration, std::shared_ptr<const Sequence> sequence) {
    known_[module][exploration] = std::move(sequence);
  }

 private:
  std::vector<std::vector<std::shared_ptr<const Sequence>>> known_;
};

/// Computes what the modules `wanted` give for `explorations` of the recording, from what is known
/// already, and keeps it in `activations`; what is computed on the way there is not kept. All that
/// they depend on must have learned. The same for any number of threads.
/// Errors (kData) name exploration and module.
Result<void> evaluate(const System& system, const Recording& recording,
                      std::span<const std::size_t> explorations,
                      const std::vector<std::size_t>& wanted, std::size_t threads,
                      Activations& activations);

/// The modules that are fixed and that learning ones, or the modules `also` among them, build on.
std::vector<std::size_t> fixed_inputs(const System& system, const std::vector<std::size_t>& also);

/// What never depends on learning, computed once for all explorations of the recording: of
/// the modules fixed_inputs().
Result<Activations> evaluate_fixed(const System& system, const Recording& recording,
                                   const std::vector<std::size_t>& also, std::size_t threads);

}  // namespace somato
