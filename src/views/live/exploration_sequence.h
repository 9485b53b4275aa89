#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "somato/bodies/exploring.h"
#include "somato/core/result.h"
#include "views/session/view_source.h"

namespace somato::live {

/// Counts the rounds of a demonstration: its explorations are made in turn and then played again
/// until a viewer takes over.
class Demonstration {
 public:
  explicit Demonstration(bool runs) : runs_(runs) {}

  bool runs() const { return runs_; }

  /// The complete rounds, or nothing without a demonstration.
  std::optional<std::size_t> rounds() const {
    return runs_ ? std::optional<std::size_t>(rounds_) : std::nullopt;
  }

  void complete_round() { ++rounds_; }

  /// A viewer takes over.
  void end() { runs_ = false; }

 private:
  bool runs_;
  std::size_t rounds_ = 0;
};

/// The explorations of a body that follow: those of a plan, one after the other, or those that
/// viewers select. A demonstration is a plan that a viewer may end.
class ExplorationSequence {
 public:
  /// The next exploration; without a placement the object is placed at random.
  struct Next {
    std::size_t thing = 0;
    std::size_t trial = 0;
    std::optional<Placement> placement = {};
  };

  /// `thing` is selected first.
  ExplorationSequence(std::vector<PlannedExploration> plan, bool demonstrates, std::size_t thing)
      : plan_(std::move(plan)), demonstration_(demonstrates), thing_(thing) {}

  std::size_t thing() const { return thing_; }
  const Placement& placement() const { return placement_; }

  /// Whether there is a plan, which may have ended.
  bool is_planned() const { return !plan_.empty(); }

  /// Whether explorations of the plan have not begun yet.
  bool has_next() const { return planned_ < plan_.size(); }

  bool demonstrates() const { return demonstration_.runs(); }

  /// The complete rounds of a demonstration, or nothing without one.
  std::optional<std::size_t> rounds() const { return demonstration_.rounds(); }
  void complete_round() { demonstration_.complete_round(); }

  /// Ends a demonstration. Errors (kUsage): there is another plan, which is fixed.
  Result<void> take_over();

  /// Selects a thing, or its placement; after take_over().
  void select(std::size_t thing) { thing_ = thing; }
  void place(const Placement& placement) { placement_ = placement; }

  /// Begins the next exploration.
  Next next();

  /// No further exploration of the plan begins.
  void give_up() { planned_ = plan_.size(); }

 private:
  std::vector<PlannedExploration> plan_;
  Demonstration demonstration_;
  Placement placement_;
  std::size_t thing_;
  std::size_t trials_ = 0;
  std::size_t planned_ = 0;  // explorations of the plan that have begun
};

}  // namespace somato::live
