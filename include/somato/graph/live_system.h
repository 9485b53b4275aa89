#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/core/signal.h"
#include "somato/graph/system.h"

namespace somato {

/// A trained system that processes frames live, for a control loop: after each frame the map has a
/// winner, the same as in an evaluation of the exploration so far.
///
/// If the map's input is a sum of sparse frames, as in a tensor chain, the inner products of the
/// sum with the weights are updated with each frame, so that the cost of a frame is its stored
/// elements times the neurons, independent of the number of elements; the sum itself is only
/// computed if neurons are too close for rounding. Channels, codes, memories of dense frames,
/// normalizations, T-MPSOMs and maps do not allocate once their memory is large enough.
class LiveSystem {
 public:
  /// For the map with the number `map` in the system, which must outlive this object and not
  /// change. Errors (kUsage): the map depends on channels whose frames are not recorded together.
  /// Throws InvalidArgument if the module is not a map, or is not trained.
  static Result<LiveSystem> build(const System& system, std::size_t map);

  LiveSystem(LiveSystem&&) noexcept;
  LiveSystem& operator=(LiveSystem&&) noexcept;
  LiveSystem(const LiveSystem&) = delete;
  LiveSystem& operator=(const LiveSystem&) = delete;
  ~LiveSystem();

  /// The channels of a frame, in the order of step().
  const std::vector<std::string>& channels() const;

  /// The number of elements of each of these channels.
  const std::vector<std::size_t>& elements() const;

  /// Begins an exploration. `frame_rate` is its number of frames per second, or 0 if unknown.
  void start(double frame_rate = 0.0);

  /// Processes a frame of each channel, with all values valid. Errors (kData) name the module;
  /// start() is then required. Throws InvalidArgument if the number of channels or elements is
  /// wrong.
  Result<void> step(std::span<const std::span<const float>> frame);

  /// The winner of the map for the exploration so far. Errors (kData): a module before the map
  /// requires more frames. Throws InvalidArgument before the first frame.
  Result<std::size_t> winner();

  /// The most similar of these neurons, such as those that have a label. Errors as for winner().
  /// Throws InvalidArgument before the first frame, or if there are none.
  Result<std::size_t> winner_among(std::span<const std::size_t> neurons);

  /// The input of the map for the exploration so far; valid until the next call. Errors as for
  /// winner(). Throws InvalidArgument before the first frame.
  Result<SignalView> input();

 private:
  class Impl;
  explicit LiveSystem(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> impl_;
};

}  // namespace somato
