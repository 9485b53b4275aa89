#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/core/samples.h"
#include "somato/graph/channel_planes.h"
#include "somato/graph/system_model.h"
#include "somato/recording/recording.h"

namespace somato::live {

/// A trained system, and the explorations that it is asked about.
struct InquiredSystem {
  std::shared_ptr<const SystemModel> model;
  std::shared_ptr<const Recording> recording;
};

/// Answers questions about a system that has learned, in JSON as docs/formats/view.md says. From
/// any thread, one at a time; what takes long is kept for the next question about the same system.
class Inquiries {
 public:
  /// What a neuron of a map stands for, and which explorations are nearest to it. Errors (kUsage):
  /// no such map or neuron.
  Result<std::string> neuron(const InquiredSystem& asked, const std::string& map,
                             std::size_t neuron);

  /// For each map the weights of its neurons for an element of the channel `touch`. Errors
  /// (kUsage): no map knows such an element.
  Result<std::string> taxel(const InquiredSystem& asked, std::size_t element);

 private:
  struct KnownMap {
    std::size_t module = 0;
    std::vector<ChannelPlanes> planes;
    bool has_inputs = false;
    Samples inputs;  ///< Of each exploration; none where they come with every frame.
  };

  void turn_to(const InquiredSystem& asked);
  KnownMap* find(const std::string& map);
  void find_inputs(KnownMap& map) const;

  std::mutex mutex_;
  InquiredSystem asked_;
  std::size_t explorations_ = 0;
  std::vector<KnownMap> maps_;
};

}  // namespace somato::live
