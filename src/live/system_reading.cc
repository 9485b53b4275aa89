#include "live/system_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <span>

#include "somato/graph/evaluation.h"

namespace somato::live {
namespace {

constexpr std::size_t kMostNeuronsShown = 4096;

void scale_to_one(std::vector<float>& activity) {
  const float most = activity.empty() ? 0.0F : *std::max_element(activity.begin(), activity.end());
  if (!(most > 0.0F)) return;
  for (float& value : activity) value = std::max(0.0F, value / most);
}

std::vector<std::vector<std::size_t>> neurons_by_class(const SystemAnswer& answer) {
  std::vector<std::vector<std::size_t>> neurons(answer.classes.size());
  for (const std::size_t neuron : answer.labels.labelled()) {
    neurons[*answer.labels[neuron]].push_back(neuron);
  }
  return neurons;
}

}  // namespace

double Saying::confidence() const {
  if (candidates.size() < 2) return candidates.empty() ? 0.0 : 1.0;
  const double nearest = candidates[0].distance;
  const double next = candidates[1].distance;
  return next > 0.0 ? std::clamp(1.0 - nearest / next, 0.0, 1.0) : 0.0;
}

SystemReading::SystemReading(std::shared_ptr<const SystemModel> model, std::size_t map)
    : model_(std::move(model)), map_(map), neurons_of_class_(neurons_by_class(*model_->answer)) {}

Result<SystemReading> SystemReading::build(std::shared_ptr<const SystemModel> model) {
  if (!model->answer) {
    return fail(ErrorKind::kData, "the system has no map that answers", {},
                "take one that 'somato run' has saved");
  }
  auto map = model->system.find(model->answer->map);
  if (!map) return fail(std::move(map.error()));
  if (model->system.modules()[*map].output.rate == Rate::kFrame) {
    return fail(ErrorKind::kData, "the map that answers has frames coming in", {},
                "take a system that answers once an exploration");
  }
  SystemReading reading(std::move(model), *map);
  auto live = LiveSystem::build(reading.model_->system, *map, LiveModules::kAll);
  if (live) reading.live_.emplace(std::move(*live));
  return reading;
}

void SystemReading::start() {
  if (live_) live_->start();
  channels_.clear();
  followed_ = 0;
}

Result<void> SystemReading::follow(const Exploration& exploration,
                                   const std::vector<std::size_t>& frames) {
  if (live_) {
    if (auto found = find_channels(exploration); !found) return found;
    by_live_ = all_valid(exploration);
  }
  if (is_costly()) {
    followed_ = frames.empty() ? 0 : *std::min_element(frames.begin(), frames.end());
    return {};
  }
  std::size_t come = channels_.empty() ? 0 : frames[channels_.front()];
  for (const std::size_t channel : channels_) come = std::min(come, frames[channel]);
  for (; followed_ < come; ++followed_) {
    if (auto stepped = step(exploration, followed_); !stepped) return stepped;
  }
  return {};
}

// Whether every value of its channels was given; a live system cannot do without.
bool SystemReading::all_valid(const Exploration& exploration) const {
  return std::all_of(channels_.begin(), channels_.end(), [&](std::size_t channel) {
    return exploration.channels[channel].valid.empty();
  });
}

Result<void> SystemReading::find_channels(const Exploration& exploration) {
  channels_.clear();
  for (const std::string& name : live_->channels()) {
    const auto found = std::find_if(
        exploration.channels.begin(), exploration.channels.end(), [&](const Channel& channel) {
          return channel.name == name &&
                 (channel.frames.empty() || channel.frames.columns() == elements_of(name));
        });
    if (found == exploration.channels.end()) {
      return fail(ErrorKind::kData,
                  fmt::format("there is no channel '{}' of {} elements", name, elements_of(name)));
    }
    channels_.push_back(static_cast<std::size_t>(found - exploration.channels.begin()));
  }
  return {};
}

std::size_t SystemReading::elements_of(const std::string& channel) const {
  for (const SystemModule& module : model_->system.modules()) {
    const auto* source = dynamic_cast<const Source*>(module.module.get());
    if (source != nullptr && source->channel() == channel) return source->channel_elements();
  }
  return 0;
}

Result<void> SystemReading::step(const Exploration& exploration, std::size_t frame) {
  std::vector<std::span<const float>> values;
  values.reserve(channels_.size());
  for (const std::size_t channel : channels_) {
    values.push_back(exploration.channels[channel].frames.row(frame));
  }
  return live_->step(values);
}

Result<std::optional<Saying>> SystemReading::say(const std::function<Exploration()>& so_far) {
  if (followed_ == 0) return std::optional<Saying>{};
  if (!is_costly()) return std::optional<Saying>(say_live());
  return say_as_whole(so_far());
}

// The answer is the class of the labelled neuron that is most similar; the others follow by
// distance.
std::vector<Candidate> SystemReading::candidates_by(
    const std::function<std::size_t(std::span<const std::size_t>)>& winner_among,
    const std::function<double(std::size_t)>& distance) const {
  const NeuronLabels& labels = model_->answer->labels;
  if (labels.labelled().empty()) return {};
  const std::size_t answer = *labels[winner_among(labels.labelled())];
  std::vector<Candidate> candidates;
  for (std::size_t number = 0; number < neurons_of_class_.size(); ++number) {
    if (neurons_of_class_[number].empty()) continue;
    candidates.push_back({number, distance(winner_among(neurons_of_class_[number]))});
  }
  std::sort(candidates.begin(), candidates.end(), [&](const Candidate& a, const Candidate& b) {
    const auto key = [&](const Candidate& one) {
      return std::tuple(one.number != answer, one.distance, one.number);
    };
    return key(a) < key(b);
  });
  return candidates;
}

MapReading SystemReading::read_map(std::size_t module, const SignalView& input) const {
  const Som& som = *som_of(model_->system, module);
  SomWorkspace workspace;
  MapReading reading{som.winner(input, workspace), std::vector<float>(som.neurons())};
  som.activity(input, workspace, reading.activity);
  scale_to_one(reading.activity);
  return reading;
}

Saying SystemReading::say_live() {
  Saying saying;
  const auto& modules = model_->system.modules();
  for (std::size_t module = 0; module < modules.size(); ++module) {
    const auto output = live_->output(module);
    if (!output) continue;
    if (som_of(model_->system, module) == nullptr) {
      saying.modules.emplace_back(
          module, fold_signal(*output, modules[module].output.shape, kMostNeuronsShown));
    } else if (const auto input = live_->output(modules[module].inputs.front())) {
      saying.maps.emplace_back(module, read_map(module, *input));
    }
  }
  MapReading answer{live_->winner(), std::vector<float>(som_of(model_->system, map_)->neurons())};
  live_->activity(answer.activity);
  scale_to_one(answer.activity);
  saying.maps.emplace_back(map_, std::move(answer));
  saying.candidates = candidates_by(
      [&](std::span<const std::size_t> neurons) { return live_->winner_among(neurons); },
      [&](std::size_t neuron) { return live_->distance(neuron); });
  return saying;
}

Result<std::optional<Saying>> SystemReading::say_as_whole(Exploration exploration) const {
  const auto& modules = model_->system.modules();
  std::vector<std::size_t> all(modules.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  Activations activations(modules.size(), 1);
  Recording recording;
  recording.explorations.push_back(std::move(exploration));
  const std::array<std::size_t, 1> only{0};
  if (auto done = evaluate(model_->system, recording, only, all, 1, activations); !done) {
    return fail(std::move(done.error()));
  }
  const auto last = [&](std::size_t module) {
    const Samples& values = activations.find(module, 0)->values;
    return values[values.count() - 1];
  };
  Saying saying;
  for (const std::size_t module : all) {
    if (som_of(model_->system, module) == nullptr) {
      saying.modules.emplace_back(
          module, fold_signal(last(module), modules[module].output.shape, kMostNeuronsShown));
    } else {
      saying.maps.emplace_back(module, read_map(module, last(modules[module].inputs.front())));
    }
  }
  const Som& som = *som_of(model_->system, map_);
  const SignalView input = last(modules[map_].inputs.front());
  SomWorkspace workspace;
  saying.candidates = candidates_by(
      [&](std::span<const std::size_t> neurons) {
        return som.winner_among(neurons, input, workspace);
      },
      [&](std::size_t neuron) { return som.distance(input, neuron, workspace); });
  return std::optional<Saying>(std::move(saying));
}

}  // namespace somato::live
