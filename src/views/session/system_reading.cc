#include "views/session/system_reading.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "somato/graph/answers.h"

namespace somato::live {
namespace {

constexpr std::size_t kMostNeuronsShown = 4096;

void scale_to_one(std::vector<float>& activity) {
  const float most = activity.empty() ? 0.0F : *std::max_element(activity.begin(), activity.end());
  if (!(most > 0.0F)) return;
  for (float& value : activity) value = std::max(0.0F, value / most);
}

// All elements of the channel, so that they have the places of its frames.
ChannelContributions channel_contributions(const ContributionSource& source,
                                           const std::vector<double>& values) {
  std::size_t size = 1;
  for (const std::size_t length : source.shape) size *= length;
  ChannelContributions all{source.name,
                           std::vector<float>(size, std::numeric_limits<float>::quiet_NaN())};
  for (std::size_t i = 0; i < values.size(); ++i) {
    all.values[source.places[i]] = static_cast<float>(values[i]);
  }
  return all;
}

std::optional<ContributionReader> contribution_reader(
    const std::shared_ptr<const SystemModel>& model) {
  auto reader = ContributionReader::build(model);
  return reader ? std::optional(*std::move(reader)) : std::nullopt;
}

std::vector<std::size_t> all_modules(const System& system) {
  std::vector<std::size_t> all(system.modules().size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

}  // namespace

std::string Reading::name(const std::vector<std::string>& classes) const {
  return novelty && is_unknown(*novelty) ? std::string(kUnknownAnswer)
                                         : classes[candidates.front().number];
}

double Reading::confidence() const {
  if (candidates.size() < 2) return candidates.empty() ? 0.0 : 1.0;
  const double nearest = candidates[0].distance;
  const double next = candidates[1].distance;
  return next > 0.0 ? std::clamp(1.0 - nearest / next, 0.0, 1.0) : 0.0;
}

SystemReading::SystemReading(std::shared_ptr<const SystemModel> model, std::size_t map)
    : model_(std::move(model)),
      map_(map),
      answers_(*model_),
      contributions_(contribution_reader(model_)),
      walk_(model_->system, all_modules(model_->system), Outputs::kLatest) {}

Result<SystemReading> SystemReading::build(std::shared_ptr<const SystemModel> model) {
  SOMATO_TRY(const auto map, answering_map(*model));
  return SystemReading(std::move(model), map);
}

void SystemReading::start() {
  exploration_ = nullptr;
}

Result<void> SystemReading::follow(const Exploration& exploration,
                                   const std::vector<std::size_t>& frames,
                                   const std::vector<std::size_t>& dropped) {
  if (exploration_ != &exploration) {
    SOMATO_TRY_VOID(walk_.start(&exploration));
    exploration_ = &exploration;
  }
  return walk_.follow(frames, dropped);
}

std::optional<ReadingContributions> SystemReading::contributions(
    const std::vector<NearestOfClass>& candidates) const {
  if (!contributions_ || candidates.size() < 2) return {};
  const InputContributions read =
      contributions_->read(input_of(map_), {candidates[0].neuron, candidates[1].neuron});
  ReadingContributions all{read.other, contributions_->unit(), {}};
  const std::vector<ContributionSource>& sources = contributions_->sources();
  for (std::size_t i = 0; i < sources.size(); ++i) {
    if (!sources[i].is_channel || sources[i].places.size() > kMostNeuronsShown) continue;
    all.channels.push_back(channel_contributions(sources[i], read.values[i]));
  }
  return all;
}

MapReading SystemReading::read_map(std::size_t module, const SignalView& input) const {
  const Som& som = *som_of(model_->system, module);
  SomWorkspace workspace;
  MapReading reading{som.winner(input, workspace), 0.0, std::vector<float>(som.neurons())};
  reading.distance = som.distance(input, reading.winner, workspace);
  som.activity(input, workspace, reading.activity);
  scale_to_one(reading.activity);
  return reading;
}

Result<std::optional<Reading>> SystemReading::read() {
  if (exploration_ == nullptr || !walk_.has_frames()) return std::optional<Reading>{};
  SOMATO_TRY_VOID(walk_.settle());
  Reading reading;
  const auto& modules = model_->system.modules();
  for (std::size_t module = 0; module < modules.size(); ++module) {
    if (som_of(model_->system, module) == nullptr) {
      reading.modules.emplace_back(
          module,
          fold_signal(*walk_.output(module), modules[module].output.shape, kMostNeuronsShown));
    } else {
      reading.maps.emplace_back(module, read_map(module, input_of(module)));
    }
  }
  reading.candidates = answers_.classes(input_of(map_));
  reading.contributions = contributions(reading.candidates);
  if (!reading.candidates.empty()) {
    reading.novelty = answers_.novelty(input_of(map_), reading.candidates.front());
  }
  return std::optional<Reading>(std::move(reading));
}

SignalView SystemReading::input_of(std::size_t module) const {
  return *walk_.output(model_->system.modules()[module].inputs.front());
}

}  // namespace somato::live
