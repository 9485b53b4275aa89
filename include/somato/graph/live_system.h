#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/core/signal.h"
#include "somato/graph/system.h"

namespace somato {

/// Which modules of a system are at work.
enum class LiveModules {
  kNeeded,  ///< Those that the map's answer depends on.
  kAll,     ///< All but the map that can run live, to be looked at. The map answers the same.
};

/// A trained system at work on an exploration that goes on: after each frame its map answers as if
/// that frame had been the last one.
///
/// It answers as evaluating the exploration as far as it went would, up to rounding. Where sparse
/// frames are added up for the map, as in a tensor chain, the sum is never put together: what a
/// frame adds to the sum's inner products with the weights is, in double precision, so that a frame
/// costs its stored elements times the neurons whatever the number of elements. Channels, one-hot
/// codes, tensor products, concatenations, memories of dense frames, normalizations, T-MPSOMs and
/// maps allocate nothing once their memory has grown; other modules do.
class LiveSystem {
 public:
  /// For the map that is number `map` of the system, which must outlive this object and not change.
  /// What only `modules` asks for and cannot run live is left out. Errors (kUsage): a module that
  /// needs explorations as a whole, a loop, or channels whose frames are not taken together, before
  /// the map. Throws InvalidArgument when the module is no map, or has not learned.
  static Result<LiveSystem> build(const System& system, std::size_t map,
                                  LiveModules modules = LiveModules::kNeeded);

  LiveSystem(LiveSystem&&) noexcept;
  LiveSystem& operator=(LiveSystem&&) noexcept;
  LiveSystem(const LiveSystem&) = delete;
  LiveSystem& operator=(const LiveSystem&) = delete;
  ~LiveSystem();

  /// The channels that a frame is made of, in the order of step().
  const std::vector<std::string>& channels() const;

  /// Goes to the start of an exploration.
  void start();

  /// Takes a frame of each channel, all values of it valid. Errors (kData) name the module; then
  /// start() anew. Throws InvalidArgument for another number of channels or of their elements.
  Result<void> step(std::span<const std::span<const float>> frame);

  /// What the module gave with the last frame; a value that comes once an exploration as if that
  /// were the last one. Valid until the next step. Nothing before the first frame, for the map
  /// itself, and for a module that is not at work.
  std::optional<SignalView> output(std::size_t module) const;

  /// What the map says of the exploration so far, as Som::winner(), Som::winner_among(),
  /// Som::distance() and Som::activity(). They throw InvalidArgument before the first frame.
  std::size_t winner();
  std::size_t winner_among(std::span<const std::size_t> candidates);
  double distance(std::size_t neuron);
  void activity(std::span<float> out);

 private:
  struct State;
  explicit LiveSystem(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

}  // namespace somato
