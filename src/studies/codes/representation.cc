#include "studies/codes/representation.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "somato/graph/evaluation.h"
#include "somato/graph/system.h"
#include "somato/graph/system_training.h"

namespace somato {
namespace {

std::vector<std::size_t> all_of(const Recording& recording) {
  std::vector<std::size_t> all(recording.explorations.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

// The code in all scalings, on the frames as channels.
SystemDescription described(const Recording& frames, const Code& code,
                            const std::vector<Scaling>& scalings) {
  SystemBuilder builder("codes");
  for (const Channel& channel : frames.explorations.front().channels) {
    builder.module(channel.name, "channel", {{"channel", {channel.name}}});
  }
  SystemDescription description = builder.description();
  const auto add = [&](const ModuleDescription& module) {
    const bool is_known = std::ranges::any_of(
        description.modules,
        [&](const ModuleDescription& known) { return known.name == module.name; });
    if (!is_known) description.modules.push_back(module);
  };
  for (const Scaling scaling : scalings) std::ranges::for_each(scaled(code, scaling).modules, add);
  return description;
}

Result<void> check_sizes(const System& system, std::size_t most_elements) {
  for (const SystemModule& module : system.modules()) {
    const std::size_t elements = module.output.size();
    if (elements <= most_elements) continue;
    return fail(
        ErrorKind::kData,
        fmt::format("'{}' has {} elements, more than {}", module.name, elements, most_elements), {},
        "raise 'elements'");
  }
  return {};
}

Result<System> trained(SystemDescription description, const Recording& frames,
                       std::size_t most_elements, std::size_t threads) {
  SOMATO_TRY(auto system, System::build(std::move(description), layout_of(frames)));
  SOMATO_TRY_VOID(check_sizes(system, most_elements));
  SOMATO_TRY(auto activations, evaluate_fixed(system, frames, {}, threads));
  SystemTraining training;
  training.threads = threads;
  SOMATO_TRY_VOID(train_system(system, frames, all_of(frames), training, activations));
  return system;
}

bool have_one_frame(const Recording& frames) {
  return std::ranges::all_of(frames.explorations, [](const Exploration& exploration) {
    return exploration.channels.front().frames.rows() < 2;
  });
}

// Explorations of one frame are divided by the elements of their vectors.
PerView<Samples> views_of_elements(const Samples& vectors) {
  PerView<Samples> views;
  for (const View view : kAllViews) views[view] = seen_in(vectors, view);
  return views;
}

}  // namespace

ViewedFrames all_views_of(const Recording& frames) {
  ViewedFrames views;
  for (const View view : kAllViews) views[view] = seen_in(frames, view);
  return views;
}

Result<std::vector<Representation>> represent(const ViewedFrames& frames, const Code& code,
                                              const std::vector<Scaling>& scalings,
                                              std::size_t most_elements, std::size_t threads) {
  const Recording& whole = frames[View::kWhole];
  SOMATO_TRY(const auto system,
             trained(described(whole, code, scalings), whole, most_elements, threads));
  std::vector<Representation> representations;
  std::vector<std::size_t> outputs;
  for (const Scaling scaling : scalings) {
    representations.push_back({scaled(code, scaling), scaling, {}});
    SOMATO_TRY(const std::size_t output, system.find(representations.back().code.output));
    outputs.push_back(output);
  }
  const bool one_frame = have_one_frame(whole);
  for (const View view : kAllViews) {
    if (one_frame && view != View::kWhole) continue;
    Activations activations(system.modules().size(), whole.explorations.size());
    SOMATO_TRY_VOID(evaluate(system, frames[view], all_of(whole), outputs, threads, activations));
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      representations[i].vectors[view] = activations.values_of(outputs[i]).samples;
    }
  }
  if (one_frame) {
    for (Representation& each : representations) {
      each.vectors = views_of_elements(each.vectors[View::kWhole]);
    }
  }
  return representations;
}

}  // namespace somato
