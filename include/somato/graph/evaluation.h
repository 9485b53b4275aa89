#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "somato/core/result.h"
#include "somato/graph/system.h"
#include "somato/recording/recording.h"

namespace somato {

/// The output of one module for explorations, one value each.
struct ExplorationValues {
  std::vector<std::size_t> explorations;  ///< The numbers of the explorations, ascending.
  Samples samples;                        ///< One for each.

  /// The positions of `wanted`, which must all be included.
  std::vector<std::size_t> places_of(std::span<const std::size_t> wanted) const;
};

/// Known outputs of modules for explorations. Copies share the outputs.
class Activations {
 public:
  Activations() = default;
  Activations(std::size_t modules, std::size_t explorations)
      : known_(modules, std::vector<std::shared_ptr<const Sequence>>(explorations)),
        values_(modules) {}

  /// The module's output for the exploration, or nullptr.
  const Sequence* find(std::size_t module, std::size_t exploration) const {
    return known_[module][exploration].get();
  }

  void set(std::size_t module, std::size_t exploration, std::shared_ptr<const Sequence> sequence) {
    known_[module][exploration] = std::move(sequence);
  }

  /// The outputs of a module with the rate exploration for all explorations for which they are
  /// known. The samples are created once and shared by later copies, so that all maps share the
  /// quantities derived from them.
  const ExplorationValues& values_of(std::size_t module);

 private:
  std::vector<std::vector<std::shared_ptr<const Sequence>>> known_;
  std::vector<std::shared_ptr<const ExplorationValues>> values_;
};

/// Computes the outputs of the modules `wanted` for `explorations` of the recording, using known
/// outputs, and stores them in `activations`; intermediate outputs are not stored. All modules that
/// they depend on must be trained. The result is the same for any number of threads. Errors (kData)
/// name exploration and module.
Result<void> evaluate(const System& system, const Recording& recording,
                      std::span<const std::size_t> explorations,
                      const std::vector<std::size_t>& wanted, std::size_t threads,
                      Activations& activations);

/// The fixed modules that learning modules, or the modules `also`, directly depend on.
std::vector<std::size_t> fixed_inputs(const System& system, const std::vector<std::size_t>& also);

/// Outputs that do not depend on learning, computed once for all explorations of the recording:
/// those of the modules fixed_inputs().
Result<Activations> evaluate_fixed(const System& system, const Recording& recording,
                                   const std::vector<std::size_t>& also, std::size_t threads);

}  // namespace somato
