#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/result.h"
#include "somato/core/signal.h"
#include "somato/graph/system_model.h"
#include "somato/recording/recording.h"
#include "systems/model/channel_planes.h"
#include "views/session/view_json.h"

namespace somato::live {

/// A trained system, and the explorations for its queries.
struct InquiredSystem {
  std::shared_ptr<const SystemModel> model;
  std::shared_ptr<const Recording> recording;
  std::size_t first = 0;  ///< The index of its first exploration.
};

/// Answers questions about a system that has learned, in JSON as docs/formats/view.md says. From
/// any thread, one at a time; what takes long is kept for the next question about the same system.
class Inquiries {
 public:
  /// `is_over` is called regularly during a query; if it returns true, there is no answer.
  explicit Inquiries(std::function<bool()> is_over = [] { return false; })
      : is_over_(std::move(is_over)) {}

  /// Describes a neuron of a map, and the explorations that are nearest to it, of the first two
  /// thousand that are kept. Errors (kUsage): no such map or neuron; all is over.
  Result<std::string> neuron(const InquiredSystem& system, const std::string& map,
                             std::size_t neuron);

  /// For each map the weights of its neurons for an element of the channel `touch`. Errors
  /// (kUsage): no map knows such an element.
  Result<std::string> taxel(const InquiredSystem& system, std::size_t element);

 private:
  struct ExplorationInput {
    std::size_t exploration = 0;  ///< Its index.
    Signal signal;
  };
  struct KnownMap {
    std::size_t module = 0;
    std::vector<ChannelPlanes> planes;
    std::size_t seen = 0;                 ///< The index after the last exploration in `inputs`.
    std::deque<ExplorationInput> inputs;  ///< None where they come with every frame.
  };

  void turn_to(const InquiredSystem& system);
  KnownMap* find(const std::string& map);
  Result<void> find_inputs(const InquiredSystem& inquired, KnownMap& map) const;
  static Json nearest(const InquiredSystem& system, const KnownMap& map, std::size_t neuron);

  std::function<bool()> is_over_;
  std::mutex mutex_;
  std::shared_ptr<const SystemModel> model_;  // of the last question
  std::size_t end_ = 0;                       // the index after the last exploration then
  std::vector<KnownMap> maps_;
};

}  // namespace somato::live
