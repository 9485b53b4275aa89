#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/core/signal.h"
#include "somato/graph/system.h"
#include "somato/recording/recording.h"
#include "systems/walk/walk_plan.h"

namespace somato {

/// The execution of a system on one exploration. Evaluating a recording, training on frames and
/// live evaluation use the same walk, driven by a file, by a learner or by a clock, and give the
/// same bits.
///
/// With each frame the modules run that only require the frames so far. All others are run by
/// settle(), as if the frames so far were the whole exploration: memories output their current
/// state, and modules that require whole explorations run again on all frames so far. Only the
/// frames that such modules require are stored, and with Outputs::kAll those of the requested
/// modules.
class Walk {
 public:
  /// The sequence of a module where that is known already, or nullptr.
  using Known = std::function<const Sequence*(std::size_t module)>;

  /// A walk over the modules `wanted` and their dependencies, except for modules for which
  /// `is_known` is true. `system` must outlive the walk, and may change in the meantime only by
  /// learning of its modules.
  Walk(const System& system, const std::vector<std::size_t>& wanted, Outputs outputs,
       const std::function<bool(std::size_t)>& is_known = {});

  /// Begins an exploration. Channels are read from `exploration`, which may be nullptr if all of
  /// their outputs are known, and which may grow at its end during the walk. `known` returns the
  /// sequence of each module that is known. Both must outlive the walk through this exploration.
  /// Errors (kData): a channel is missing or has the wrong number of elements.
  Result<void> start(const Exploration* exploration, const Known& known = {});

  /// Walks through the whole exploration and settles. Errors (kData, kSystem) name the module and
  /// the frame.
  Result<void> run();

  /// Walks on until the channels have given `frames[i]` frames each, i being the number of a
  /// channel in the exploration. Channels whose frames are taken together wait for each other. The
  /// first `dropped[i]` of them, which were followed before, are no longer in the exploration;
  /// empty: all are. Errors as run().
  Result<void> follow(std::span<const std::size_t> frames,
                      std::span<const std::size_t> dropped = {});

  /// The most memory of the frames that modules store, in bytes. Above, an error (kData) names the
  /// module.
  void limit_memory(std::size_t most) { most_kept_ = most; }

  /// Processes one more frame of all inputs; the values of channels are in row `row` of their
  /// frames. Errors as run().
  Result<void> step(std::size_t row);

  /// Computes what depends on the exploration as a whole, as if the last frame so far were its end.
  /// Errors as run(), also where a module needs more frames than there are.
  Result<void> settle();

  /// Whether settle() runs modules again on all frames so far.
  bool is_costly() const { return plan_.is_costly(); }

  /// Whether every channel has given a frame.
  bool has_frames() const;

  /// The channels that are read, in groups whose frames are taken together.
  std::vector<std::vector<std::string>> channels() const;

  /// The output of a walked module for the last frame, or for the exploration, which requires
  /// settle(); valid until the walk continues. Empty before the first frame and for other modules.
  std::optional<SignalView> output(std::size_t module) const;

  /// The number of frames of the exploration. Errors (kData): channels that are not taken together
  /// have different numbers of frames.
  Result<std::size_t> frames();

  /// The number of frames that come in at a module, walked or not. Errors (kData): its inputs have
  /// different numbers of frames.
  Result<std::size_t> frames_into(std::size_t module);

  /// The input of a module, walked or not, at the last step, or for the exploration after settle();
  /// valid until the walk continues.
  std::vector<SignalView> inputs_of(std::size_t module) const;

  /// Moves out all outputs of a requested module; after run(), once, with Outputs::kAll.
  Sequence take(std::size_t module);

 private:
  static constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();
  using Part = WalkPlan::Part;

  // A module on its way.
  struct Place {
    const Source* source = nullptr;    // of a module that reads a channel
    const Channel* channel = nullptr;  // which it reads
    std::size_t channel_number = 0;    // in the exploration
    std::size_t dropped = 0;           // frames of the channel
    std::unique_ptr<Runner> runner;    // of any other stepped module
    const Sequence* known = nullptr;
    std::size_t frames = kNoLimit;   // that there are
    double rate = 0.0;               // frames per second
    SignalBuffer now;                // the output for the present frame, or for the exploration
    SampleCollector kept;            // all outputs so far, where they are kept
    std::size_t kept_bytes = 0;      // of them
    Sequence sequence;               // the same after settle(), or the output of a whole module
    std::vector<SignalView> inputs;  // of the present step
  };

  const SystemModule& at(std::size_t module) const { return system_.modules()[module]; }
  bool gives_frames(std::size_t module) const { return at(module).output.rate == Rate::kFrame; }

  Result<void> open(std::size_t module, const Exploration* exploration);
  void restart(const Part& part);
  Result<void> count_frames();
  std::size_t frames_in(std::size_t stream) const;
  Result<std::size_t> common_frames(const Part& part) const;
  std::size_t frames_of(std::size_t module) const;
  Result<void> step_stream(std::size_t stream, std::size_t row);
  Result<void> step_part(const Part& part, std::size_t frame, std::size_t row);
  Result<void> step_module(std::size_t module, const Part& part, std::size_t frame,
                           std::size_t row);
  Result<void> compute(std::size_t module, const Part& part, std::size_t frame, std::size_t row);
  void take_delayed(std::size_t module, bool is_first);
  SignalView view_of(std::size_t input, std::size_t group, std::size_t frame) const;
  Result<void> settle_part(const Part& part);
  Result<void> finish(const Part& part);
  Result<void> run_whole(std::size_t module);
  void give_sequence(const Part& part);
  Result<void> keep(std::size_t module);
  void discard_kept(std::size_t module);

  template <typename Work>
  Result<void> at_module(std::size_t module, const Work& work);

  const System& system_;
  WalkPlan plan_;
  std::vector<Place> places_;        // of each module
  std::vector<std::size_t> frames_;  // so far, of each stream
  std::size_t steps_ = 0;
  std::size_t most_kept_ = kNoLimit;  // bytes
  std::size_t kept_ = 0;              // bytes of the frames that are stored
  bool is_settled_ = false;
};

}  // namespace somato
