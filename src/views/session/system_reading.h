#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/result.h"
#include "somato/graph/system_contributions.h"
#include "somato/graph/system_model.h"
#include "somato/recording/recording.h"
#include "systems/walk/answer_reader.h"
#include "systems/walk/walk.h"
#include "views/session/folded_signal.h"

namespace somato::live {

/// A map's answer to an input.
struct MapReading {
  std::size_t winner = 0;
  double distance = 0.0;        ///< The distance of the winner.
  std::vector<float> activity;  ///< A value a neuron; the greatest is 1, unless all are 0.
};

/// The contributions of all elements of a channel to a reading; NaN for those that are not read.
struct ChannelContributions {
  std::string channel;
  std::vector<float> values;
};

/// The contributions of channels to the choice between the nearest class and the next one.
struct ReadingContributions {
  std::size_t other = 0;  ///< The number of the next class.
  std::string unit;       ///< As ContributionReader::unit().
  std::vector<ChannelContributions> channels;
};

/// The reading of a system for an exploration up to a moment.
struct Reading {
  std::vector<std::pair<std::size_t, FoldedSignal>> modules;  ///< By numbers; maps are not here.
  std::vector<std::pair<std::size_t, MapReading>> maps;
  std::vector<NearestOfClass> candidates;  ///< The nearest, which is the answer, first; or none.
  std::optional<double> novelty = {};      ///< That of the nearest, if there is a threshold.
  std::optional<ReadingContributions> contributions = {};  ///< If there is a next class.

  /// The name that is read: that of the nearest class, or "unknown" if it is too far. There must be
  /// a candidate.
  std::string name(const std::vector<std::string>& classes) const;

  /// The lead of the nearest class over the next: 0 equally near, 1 far; 1 without a next.
  double confidence() const;
};

/// A trained system that follows an exploration and says after each moment what it would if that
/// were the last.
class SystemReading {
 public:
  /// Errors (kData): a system without a map that answers, or whose answer comes with every frame.
  static Result<SystemReading> build(std::shared_ptr<const SystemModel> model);

  /// Whether a reading costs as much as evaluating the exploration so far.
  bool is_costly() const { return walk_.is_costly(); }

  const SystemModel& model() const { return *model_; }
  std::size_t map() const { return map_; }

  /// Goes to the start of an exploration.
  void start();

  /// Follows the exploration, which has to stay where it is, until the channels have given so many
  /// frames each, of which the first `dropped`, followed before, are no longer there. Errors
  /// (kData) name channel or module.
  Result<void> follow(const Exploration& exploration, const std::vector<std::size_t>& frames,
                      const std::vector<std::size_t>& dropped = {});

  /// See Walk.
  void limit_memory(std::size_t most) { walk_.limit_memory(most); }

  /// The present reading; nothing before each channel gave a frame. Errors (kData): those of the
  /// modules, which may need more frames.
  Result<std::optional<Reading>> read();

 private:
  SystemReading(std::shared_ptr<const SystemModel> model, std::size_t map);

  SignalView input_of(std::size_t module) const;
  std::optional<ReadingContributions> contributions(
      const std::vector<NearestOfClass>& candidates) const;
  MapReading read_map(std::size_t module, const SignalView& input) const;

  std::shared_ptr<const SystemModel> model_;
  std::size_t map_;
  AnswerReader answers_;
  std::optional<ContributionReader> contributions_;  // of two classes or more
  Walk walk_;
  const Exploration* exploration_ = nullptr;  // that the walk goes through
};

}  // namespace somato::live
