#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "somato/core/signal.h"
#include "somato/maps/som.h"
#include "somato/maps/som_learner.h"

namespace somato {

/// An input to learn.
struct OnlineInput {
  SignalView values;
  std::optional<std::size_t> item;  ///< Its number among the samples that a map learns by their
                                    ///< inner products.
};

/// The result of learning several inputs.
struct Learned {
  std::size_t inputs = 0;  ///< The number of learned inputs, from the first.
  std::size_t winner = 0;  ///< The winner of the last of them.
};

/// A map while it learns online, in one arithmetic: dense, sparse or by inner products. SomLearner
/// chooses, and is what everybody else uses. A kind of map that answers or moves in another way is
/// one more class of these.
class OnlineMap {
 public:
  OnlineMap() = default;
  OnlineMap(const OnlineMap&) = delete;
  OnlineMap(OnlineMap&&) = delete;
  OnlineMap& operator=(const OnlineMap&) = delete;
  OnlineMap& operator=(OnlineMap&&) = delete;
  virtual ~OnlineMap() = default;

  /// Learns the first inputs, with a step each; none of them if the map lacks weights for the first
  /// one.
  virtual Learned learn(std::span<const OnlineInput> inputs,
                        std::span<const LearningStep> steps) = 0;

  /// Writes the activity for a known sample with everything learned so far, and returns true; false
  /// where the map has to be settled first.
  virtual bool write_activity(std::size_t /*sample*/, std::span<float> /*out*/) { return false; }

  /// Applies all deferred updates to the map.
  virtual void settle() = 0;

  /// The map as settle() would leave it; learning is not affected.
  virtual Som look() = 0;
};

}  // namespace somato
