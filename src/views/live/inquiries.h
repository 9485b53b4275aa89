#pragma once

#include <cstddef>
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
};

/// Answers questions about a system that has learned, in JSON as docs/formats/view.md says. From
/// any thread, one at a time; what takes long is kept for the next question about the same system.
class Inquiries {
 public:
  /// `is_over` is called regularly during a query; if it returns true, there is no answer.
  explicit Inquiries(std::function<bool()> is_over = [] { return false; })
      : is_over_(std::move(is_over)) {}

  /// Describes a neuron of a map, and the explorations that are nearest to it, of the first two
  /// thousand. Errors (kUsage): no such map or neuron; all is over.
  Result<std::string> neuron(const InquiredSystem& system, const std::string& map,
                             std::size_t neuron);

  /// For each map the weights of its neurons for an element of the channel `touch`. Errors
  /// (kUsage): no map knows such an element.
  Result<std::string> taxel(const InquiredSystem& system, std::size_t element);

 private:
  struct ExplorationInput {
    std::size_t exploration = 0;
    Signal signal;
  };
  struct KnownMap {
    std::size_t module = 0;
    std::vector<ChannelPlanes> planes;
    std::size_t seen = 0;                  ///< Explorations.
    std::vector<ExplorationInput> inputs;  ///< None where they come with every frame.
  };

  void turn_to(const InquiredSystem& system);
  KnownMap* find(const std::string& map);
  Result<void> find_inputs(KnownMap& map) const;
  Json nearest(const KnownMap& map, std::size_t neuron) const;

  std::function<bool()> is_over_;
  std::mutex mutex_;
  InquiredSystem current_;
  std::vector<KnownMap> maps_;
};

}  // namespace somato::live
