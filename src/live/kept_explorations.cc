#include "live/kept_explorations.h"

#include <utility>

namespace somato::live {

KeptExplorations::KeptExplorations(Recording& recording, const ExplorationSink& sink)
    : recording_(recording), sink_(sink), scenes_(count()), saved_(count()) {}

Result<void> KeptExplorations::add(Exploration exploration, std::shared_ptr<ScenePlayer> scene) {
  Recording single{{std::move(exploration)}};
  const Exploration& first =
      count() == 0 ? single.explorations[0] : recording_.explorations.front();
  auto valid =
      validate(single).and_then([&] { return check_alike(single.explorations[0], first); });
  if (!valid) {
    discard_next();
    return valid;
  }
  recording_.explorations.push_back(std::move(single.explorations[0]));
  scenes_.push_back(std::move(scene));
  return {};
}

// After an error the next ones are tried, too.
Result<void> KeptExplorations::save_before(std::size_t end) {
  Result<void> saved;
  for (; saved_ < end; ++saved_) {
    if (!sink_) continue;
    Exploration exploration = recording_.explorations[saved_];
    exploration.labels = names_.labels(saved_, std::move(exploration.labels));
    const auto taken = sink_(std::move(exploration));
    if (!taken) saved = taken;
  }
  return saved;
}

Result<void> KeptExplorations::name(std::size_t index, const Label& given) {
  if (sink_ && index < saved_) {
    return fail(ErrorKind::kUsage,
                "this exploration is saved already; only the last one can be named");
  }
  names_.give(index, given);
  return {};
}

}  // namespace somato::live
