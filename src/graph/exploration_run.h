#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "somato/core/result.h"
#include "somato/graph/system.h"
#include "somato/recording/recording.h"

namespace somato {

/// Modules of a system computed for one exploration as a whole.
class ExplorationRun {
 public:
  /// What is known already: the sequence of a module, or nullptr.
  using Known = std::function<const Sequence*(std::size_t module)>;

  /// `exploration` is where sources read; it may be nullptr when all they give is known.
  ExplorationRun(const System& system, const Exploration* exploration, Known known);

  /// Computes the modules of which `wanted` is true, and whatever they depend on that is not known.
  /// Errors (kData) name the module.
  Result<void> compute(const std::vector<bool>& wanted);

  /// What was computed or known.
  const Sequence* find(std::size_t module) const;

  /// What comes in at a module, each of which was computed or known.
  std::vector<const Sequence*> inputs_of(std::size_t module) const;

  /// What was computed, to keep.
  std::shared_ptr<const Sequence> take(std::size_t module) { return computed_[module]; }

 private:
  Result<void> compute_group(const std::vector<std::size_t>& group);
  Result<Sequence> compute_module(std::size_t module) const;
  Result<void> compute_loop(const std::vector<std::size_t>& group);

  const System& system_;
  const Exploration* exploration_;
  Known known_;
  std::vector<std::shared_ptr<const Sequence>> computed_;
};

/// The modules that `wanted` depends on, itself included, as far as `is_known` does not say that
/// they are known.
std::vector<bool> needed_for(const System& system, const std::vector<bool>& wanted,
                             const std::function<bool(std::size_t)>& is_known);

}  // namespace somato
