#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "live/folded_signal.h"
#include "somato/core/result.h"
#include "somato/graph/live_system.h"
#include "somato/graph/system_model.h"
#include "somato/recording/recording.h"

namespace somato::live {

/// A map's answer to an input.
struct MapReading {
  std::size_t winner = 0;
  std::vector<float> activity;  ///< A value a neuron; the greatest is 1, unless all are 0.
};

/// A class and how far its nearest neuron is.
struct Candidate {
  std::size_t number = 0;  ///< Of the class.
  double distance = 0.0;
};

/// What a system says of an exploration as far as it went.
struct Saying {
  std::vector<std::pair<std::size_t, FoldedSignal>> modules;  ///< By numbers; maps are not here.
  std::vector<std::pair<std::size_t, MapReading>> maps;
  std::vector<Candidate> candidates;  ///< The nearest, which is the answer, first; or none.

  /// How much nearer the nearest class is than the next: 0 equally near, 1 far; 1 without a next.
  double confidence() const;
};

/// A trained system that follows an exploration and says after each moment what it would if that
/// were the last. Where the system can run live it does; else the exploration as far as it went is
/// evaluated as a whole.
class SystemReading {
 public:
  /// Errors (kData): a system without a map that answers, or whose answer comes with every frame.
  static Result<SystemReading> build(std::shared_ptr<const SystemModel> model);

  /// Whether saying something costs as much as evaluating the exploration so far.
  bool is_costly() const { return !live_ || !by_live_; }

  const SystemModel& model() const { return *model_; }
  std::size_t map() const { return map_; }

  /// Goes to the start of an exploration.
  void start();

  /// Follows the exploration until the channels have given so many frames each.
  Result<void> follow(const Exploration& exploration, const std::vector<std::size_t>& frames);

  /// What there is to say; nothing before there was a frame. `so_far` is asked for the exploration
  /// as far as it went only when that is costly. Errors (kData): those of the modules; a costly
  /// system may need more of an exploration.
  Result<std::optional<Saying>> say(const std::function<Exploration()>& so_far);

 private:
  SystemReading(std::shared_ptr<const SystemModel> model, std::size_t map);

  bool all_valid(const Exploration& exploration) const;
  Result<void> find_channels(const Exploration& exploration);
  std::size_t elements_of(const std::string& channel) const;
  Result<void> step(const Exploration& exploration, std::size_t frame);
  Saying say_live();
  Result<std::optional<Saying>> say_as_whole(Exploration exploration) const;
  std::vector<Candidate> candidates_by(
      const std::function<std::size_t(std::span<const std::size_t>)>& winner_among,
      const std::function<double(std::size_t)>& distance) const;
  MapReading read_map(std::size_t module, const SignalView& input) const;

  std::shared_ptr<const SystemModel> model_;
  std::size_t map_;
  std::vector<std::vector<std::size_t>> neurons_of_class_;
  std::optional<LiveSystem> live_;
  bool by_live_ = true;                // whether it can follow this exploration
  std::vector<std::size_t> channels_;  // of the exploration, in the order of the live system
  std::size_t followed_ = 0;           // frames
};

}  // namespace somato::live
