#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "somato/core/result.h"
#include "somato/graph/system.h"

namespace somato {

/// Some modules of a system computed frame by frame, loops included.
class FrameWalk {
 public:
  /// What comes in from outside: the sequence of a module that is not walked.
  using Outside = std::function<const Sequence*(std::size_t module)>;

  /// `modules` in the order in which they run; all are stepped. `listeners` are others that want to
  /// know what comes in at them.
  FrameWalk(const System& system, const std::vector<std::size_t>& modules,
            const std::vector<std::size_t>& listeners = {});

  /// Goes to the start of an exploration. Errors (kData): sequences of different lengths.
  Result<void> start(const Outside& outside);

  /// Frames of the exploration, and each a second.
  std::size_t frames() const { return frames_; }
  double rate() const { return rate_; }

  /// Computes the next frame of all modules. Errors (kData) name the module.
  Result<void> step();

  /// What a walked module gave for the present frame.
  const Signal& output(std::size_t module) const { return *outputs_[places_[module]]; }

  /// What came in at a walked module or a listener with the present frame; valid until the next
  /// step.
  std::vector<SignalView> inputs_of(std::size_t module) const;

 private:
  struct Walked {
    std::size_t module = 0;
    bool delays_loop = false;  ///< Listens to a walked module that comes later.
    std::unique_ptr<Stepper> stepper;
  };

  Result<void> listen(std::size_t module, const Outside& outside);
  bool is_walked(std::size_t module) const { return places_[module] < walked_.size(); }
  SignalView view_of(std::size_t module) const;
  Signal delayed(const Walked& walked) const;

  const System& system_;
  std::vector<Walked> walked_;
  std::vector<std::size_t> listeners_;  ///< The walked ones too.
  std::vector<std::size_t> places_;     ///< Of a module among the walked ones.
  std::vector<const Sequence*> outside_;
  std::vector<std::optional<Signal>> outputs_;
  std::vector<std::optional<Signal>> before_;  ///< The outputs of the frame before.
  bool has_frames_ = false;
  std::size_t frames_ = 0;
  std::size_t frame_ = 0;  ///< The present one.
  std::size_t next_ = 0;
  double rate_ = 0.0;
};

}  // namespace somato
