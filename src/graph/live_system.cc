#include "somato/graph/live_system.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "graph/exploration_run.h"
#include "graph/finite.h"
#include "graph/modules/sum_of_frames.h"
#include "graph/sum_reading.h"
#include "graph/wiring.h"
#include "somato/core/check.h"
#include "somato/graph/system_model.h"

namespace somato {
namespace {

// A memory of more elements would be as large as all else.
constexpr std::size_t kMostFollowed = std::size_t{1} << 26;

template <typename Kind>
const Kind* as(const System& system, std::size_t module) {
  return dynamic_cast<const Kind*>(system.modules()[module].module.get());
}

// A sum of sparse frames that the map reads, divided by its norm or as it is.
struct FollowedSum {
  std::size_t frames = 0;  ///< The module whose frames are added.
  Norm norm = Norm::kNone;
};

std::optional<FollowedSum> followed_sum(const System& system, std::size_t map) {
  std::size_t module = system.modules()[map].inputs.front();
  FollowedSum sum;
  if (const auto* divided = as<modules::DividedByNorm>(system, module)) {
    sum.norm = divided->norm();
    module = system.modules()[module].inputs.front();
  }
  if (!as<modules::SumOfFrames>(system, module) || !SumReading::follows(sum.norm)) return {};
  sum.frames = system.modules()[module].inputs.front();
  const PortType& frames = system.modules()[sum.frames].output;
  if (!frames.sparse || frames.size() > kMostFollowed) return {};
  return sum;
}

// A module at work.
struct Working {
  std::size_t module = 0;
  const Source* source = nullptr;
  std::size_t channel = 0;  ///< Of a source.
  std::unique_ptr<Stepper> stepper;
  SignalBuffer taken;              ///< By a source.
  std::vector<SignalView> inputs;  ///< Of the present frame.
};

}  // namespace

struct LiveSystem::State {
  State(const System& its_system, std::size_t map)
      : system(its_system), som(*som_of(its_system, map)), outputs(its_system.modules().size()) {}

  const System& system;
  const Som& som;
  std::vector<std::string> channels;
  std::vector<std::size_t> elements;  // of each channel
  std::vector<Working> working;       // in the order in which they run
  std::vector<SignalView> outputs;    // of each module, for the present frame
  std::size_t last = 0;               // the module that brings what is read
  std::optional<SumReading> sum;      // reads a sum, or else
  SomWorkspace workspace;             // the map itself is asked
  bool has_frame = false;

  void add_all(std::size_t map);
  bool is_working(std::size_t module) const;
  Result<void> add(std::size_t module);
  Result<void> add_source(Working& added);
  void start();
  Result<void> step(std::span<const std::span<const float>> frame);
  Result<SignalView> output_of(Working& one, std::span<const std::span<const float>> frame);
  SignalView input() const {
    require(has_frame, "a live system has met no frame yet");
    return outputs[last];
  }
};

Result<void> LiveSystem::State::add(std::size_t module) {
  Working added{module, as<Source>(system, module), 0, nullptr, {}, {}};
  if (added.source) {
    if (auto opened = add_source(added); !opened) return opened;
  } else if (!system.modules()[module].module->start_live()) {
    return fail(system.at_module({ErrorKind::kUsage,
                                  "it needs explorations as a whole, and cannot run live",
                                  {},
                                  "put it out of what the map sees"},
                                 module));
  }
  added.inputs.resize(system.modules()[module].inputs.size());
  working.push_back(std::move(added));
  return {};
}

bool LiveSystem::State::is_working(std::size_t module) const {
  return std::any_of(working.begin(), working.end(),
                     [&](const Working& one) { return one.module == module; });
}

// Those that nothing needs, as far as they can run; what they listen to is at work before them.
void LiveSystem::State::add_all(std::size_t map) {
  for (const auto& group : system.wiring().groups()) {
    const std::size_t module = group.front();
    if (system.wiring().is_loop(group) || module == map || is_working(module)) continue;
    const std::vector<std::size_t>& inputs = system.modules()[module].inputs;
    const bool heard = std::all_of(inputs.begin(), inputs.end(),
                                   [&](std::size_t input) { return is_working(input); });
    if (heard) (void)add(module);
  }
}

Result<void> LiveSystem::State::add_source(Working& added) {
  const std::string& clock = system.modules()[added.module].output.clock;
  for (const Working& other : working) {
    if (!other.source || system.modules()[other.module].output.clock == clock) continue;
    return fail(system.at_module(
        {ErrorKind::kUsage,
         "its frames are not taken together with those of '" + other.source->channel() + "'",
         {},
         "record the channels together, frame by frame"},
        added.module));
  }
  const auto found = std::find(channels.begin(), channels.end(), added.source->channel());
  added.channel = static_cast<std::size_t>(found - channels.begin());
  if (found != channels.end()) return {};
  channels.push_back(added.source->channel());
  elements.push_back(added.source->channel_elements());
  return {};
}

void LiveSystem::State::start() {
  for (Working& one : working) {
    if (!one.source) one.stepper = system.modules()[one.module].module->start_live();
  }
  if (sum) sum->start();
  has_frame = false;
}

Result<void> LiveSystem::State::step(std::span<const std::span<const float>> frame) {
  require(frame.size() == channels.size(), "a frame needs the values of each channel");
  for (std::size_t i = 0; i < frame.size(); ++i) {
    require(frame[i].size() == elements[i], "a channel has another number of elements");
  }
  for (Working& one : working) {
    auto output = output_of(one, frame);
    if (output) {
      if (auto finite = check_finite(*output); !finite) output = fail(std::move(finite.error()));
    }
    if (!output) return fail(system.at_module(std::move(output.error()), one.module));
    outputs[one.module] = *output;
  }
  if (sum) sum->add(outputs[last]);
  has_frame = true;
  return {};
}

Result<SignalView> LiveSystem::State::output_of(Working& one,
                                                std::span<const std::span<const float>> frame) {
  if (one.source) {
    one.source->take(frame[one.channel], one.taken);
    return one.taken.view();
  }
  const std::vector<std::size_t>& inputs = system.modules()[one.module].inputs;
  for (std::size_t i = 0; i < inputs.size(); ++i) one.inputs[i] = outputs[inputs[i]];
  return one.stepper->advance(one.inputs);
}

Result<LiveSystem> LiveSystem::build(const System& system, std::size_t map, LiveModules modules) {
  const Som* som = som_of(system, map);
  require(som != nullptr && som->neurons() > 0, "a live system needs a map that has learned");
  auto state = std::make_unique<State>(system, map);
  const auto sum = followed_sum(system, map);
  state->last = sum ? sum->frames : system.modules()[map].inputs.front();
  if (sum) state->sum.emplace(*som, sum->norm);
  std::vector<bool> wanted(system.modules().size(), false);
  wanted[state->last] = true;
  const std::vector<bool> needed = needed_for(system, wanted, [](std::size_t) { return false; });
  for (const auto& group : system.wiring().groups()) {
    if (!needed[group.front()]) continue;
    if (system.wiring().is_loop(group)) {
      return fail(system.at_module(
          {ErrorKind::kUsage, "it is part of a loop, which does not run live", {}, {}},
          group.front()));
    }
    if (auto added = state->add(group.front()); !added) return fail(std::move(added.error()));
  }
  if (modules == LiveModules::kAll) state->add_all(map);
  state->start();
  return LiveSystem(std::move(state));
}

LiveSystem::LiveSystem(std::unique_ptr<State> state) : state_(std::move(state)) {}
LiveSystem::LiveSystem(LiveSystem&&) noexcept = default;
LiveSystem& LiveSystem::operator=(LiveSystem&&) noexcept = default;
LiveSystem::~LiveSystem() = default;

const std::vector<std::string>& LiveSystem::channels() const {
  return state_->channels;
}

void LiveSystem::start() {
  state_->start();
}

Result<void> LiveSystem::step(std::span<const std::span<const float>> frame) {
  return state_->step(frame);
}

std::optional<SignalView> LiveSystem::output(std::size_t module) const {
  if (!state_->has_frame || !state_->is_working(module)) return {};
  return state_->outputs[module];
}

std::size_t LiveSystem::winner() {
  const SignalView input = state_->input();
  return state_->sum ? state_->sum->winner() : state_->som.winner(input, state_->workspace);
}

std::size_t LiveSystem::winner_among(std::span<const std::size_t> candidates) {
  const SignalView input = state_->input();
  return state_->sum ? state_->sum->winner_among(candidates)
                     : state_->som.winner_among(candidates, input, state_->workspace);
}

double LiveSystem::distance(std::size_t neuron) {
  const SignalView input = state_->input();
  return state_->sum ? state_->sum->distance(neuron)
                     : state_->som.distance(input, neuron, state_->workspace);
}

void LiveSystem::activity(std::span<float> out) {
  const SignalView input = state_->input();
  if (state_->sum) return state_->sum->activity(out);
  state_->som.activity(input, state_->workspace, out);
}

}  // namespace somato
