#include "systems/walk/walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <utility>

#include "base/core/contains.h"
#include "base/core/memory.h"
#include "somato/core/check.h"
#include "systems/modules/finite.h"

namespace somato {

Walk::Walk(const System& system, const std::vector<std::size_t>& wanted, Outputs outputs,
           const std::function<bool(std::size_t)>& is_known)
    : system_(system),
      plan_(system, wanted, outputs, is_known),
      places_(system.modules().size()),
      frames_(plan_.streams()) {
  for (std::size_t module = 0; module < places_.size(); ++module) {
    places_[module].source = dynamic_cast<const Source*>(at(module).module.get());
    places_[module].inputs.resize(at(module).inputs.size());
  }
}

Result<void> Walk::start(const Exploration* exploration, const Known& known) {
  std::fill(frames_.begin(), frames_.end(), std::size_t{0});
  steps_ = 0;
  is_settled_ = false;
  for (std::size_t module = 0; module < places_.size(); ++module) {
    places_[module].frames = kNoLimit;
    if (plan_.is_known(module)) places_[module].known = known(module);
  }
  for (const Part& part : plan_.parts()) {
    restart(part);
    SOMATO_TRY_VOID(open(part.modules.front(), exploration));
  }
  return {};
}

Result<void> Walk::open(std::size_t module, const Exploration* exploration) {
  Place& place = places_[module];
  if (!place.source) return {};
  place.dropped = 0;
  require(exploration != nullptr, "a walk over channels needs an exploration");
  Result<const Channel*> found = find_channel(*exploration, place.source->channel());
  if (!found) return fail(system_.at_module(std::move(found.error()), module));
  const std::size_t elements = (*found)->frames.columns();
  if (!(*found)->frames.empty() && elements != place.source->channel_elements()) {
    Error error{ErrorKind::kData,
                fmt::format("channel '{}' has {} elements, but the system requires {}",
                            (*found)->name, elements, place.source->channel_elements()),
                {},
                {}};
    return fail(system_.at_module(std::move(error), module));
  }
  place.channel = *found;
  place.channel_number = static_cast<std::size_t>(*found - exploration->channels.data());
  return {};
}

void Walk::restart(const Part& part) {
  for (const std::size_t module : part.modules) {
    Place& place = places_[module];
    if (plan_[module].is_kept) discard_kept(module);
    const Module& walked = *at(module).module;
    if (!place.source && walked.is_stepped()) place.runner = walked.start();
  }
}

// An error, of memory that an output takes too, has the name of the module.
template <typename Work>
Result<void> Walk::at_module(std::size_t module, const Work& work) {
  Result<void> done;
  try {
    done = work();
  } catch (const std::bad_alloc&) {
    done = fail(ErrorKind::kSystem,
                fmt::format("there is not enough memory for its output of {}",
                            to_string(at(module).output)),
                {}, "reduce the number of its elements");
  }
  if (!done) return fail(system_.at_module(std::move(done.error()), module));
  return done;
}

Result<void> Walk::run() {
  SOMATO_TRY_VOID(count_frames());
  for (std::size_t stream = 0; stream < frames_.size(); ++stream) {
    const std::size_t frames = frames_in(stream);
    while (frames_[stream] < frames) {
      SOMATO_TRY_VOID(step_stream(stream, frames_[stream]));
    }
  }
  return settle();
}

std::size_t Walk::frames_in(std::size_t stream) const {
  std::size_t frames = 0;
  for (const Part& part : plan_.parts()) {
    if (part.group == stream) frames = std::max(frames, places_[part.modules.front()].frames);
  }
  return frames;
}

Result<void> Walk::follow(std::span<const std::size_t> frames,
                          std::span<const std::size_t> dropped) {
  std::vector<std::size_t> come(frames_.size(), kNoLimit);
  for (std::size_t module = 0; module < places_.size(); ++module) {
    if (!plan_[module].is_walked || !places_[module].source) continue;
    std::size_t& least = come[plan_[module].group];
    least = std::min(least, frames[places_[module].channel_number]);
    if (!dropped.empty()) places_[module].dropped = dropped[places_[module].channel_number];
  }
  for (std::size_t stream = 0; stream < frames_.size(); ++stream) {
    while (frames_[stream] < come[stream]) {
      SOMATO_TRY_VOID(step_stream(stream, frames_[stream]));
    }
  }
  return {};
}

Result<void> Walk::step(std::size_t row) {
  ++steps_;
  for (std::size_t stream = 0; stream < frames_.size(); ++stream) {
    SOMATO_TRY_VOID(step_stream(stream, row));
  }
  return {};
}

Result<void> Walk::step_stream(std::size_t stream, std::size_t row) {
  const std::size_t frame = frames_[stream]++;
  is_settled_ = false;
  for (const Part& part : plan_.parts()) {
    if (part.group != stream || frame >= places_[part.modules.front()].frames) continue;
    SOMATO_TRY_VOID(step_part(part, frame, row));
  }
  return {};
}

Result<void> Walk::step_part(const Part& part, std::size_t frame, std::size_t row) {
  for (const std::size_t module : part.modules) {
    SOMATO_TRY_VOID(step_module(module, part, frame, row));
  }
  return {};
}

Result<void> Walk::step_module(std::size_t module, const Part& part, std::size_t frame,
                               std::size_t row) {
  const bool gives_value = gives_frames(module) || !part.takes_frames;
  return at_module(module, [&] {
    Result<void> computed = compute(module, part, frame, row);
    if (computed && gives_value) computed = check_finite(places_[module].now.view());
    if (!computed && part.takes_frames && !places_[module].source) {
      computed.error().what += fmt::format(" (frame {})", frame + 1);
    }
    return computed && gives_value && plan_[module].is_kept ? keep(module) : computed;
  });
}

Result<void> Walk::compute(std::size_t module, const Part& part, std::size_t frame,
                           std::size_t row) {
  Place& place = places_[module];
  if (place.source) {
    return place.source->read(*place.channel, row - place.dropped, frame == 0, place.now);
  }
  if (plan_[module].delays_loop) {
    take_delayed(module, frame == 0);
    return {};
  }
  const std::vector<std::size_t>& inputs = at(module).inputs;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    place.inputs[i] = view_of(inputs[i], part.group, frame);
  }
  return place.runner->step(place.inputs, place.now);
}

// The input of a delay that closes a loop runs later, so that it holds the frame before.
void Walk::take_delayed(std::size_t module, bool is_first) {
  std::vector<float>& out = places_[module].now.begin_dense(at(module).output.size());
  if (is_first) {
    std::fill(out.begin(), out.end(), 0.0F);
  } else {
    write_dense(places_[at(module).inputs.front()].now.view(), out);
  }
}

SignalView Walk::view_of(std::size_t input, std::size_t group, std::size_t frame) const {
  const Place& from = places_[input];
  if (from.known) return from.known->values[gives_frames(input) ? frame : 0];
  const bool is_present = plan_[input].group == group || !gives_frames(input);
  return is_present ? from.now.view() : from.sequence.values[frame];
}

Result<void> Walk::keep(std::size_t module) {
  const SignalView now = places_[module].now.view();
  places_[module].kept.add(now);
  const std::size_t bytes = now.values.size_bytes() + now.indices.size_bytes();
  places_[module].kept_bytes += bytes;
  kept_ += bytes;
  if (kept_ <= most_kept_) return {};
  return fail(ErrorKind::kData,
              fmt::format("a module that follows needs all its frames of an exploration, and they "
                          "take more memory than the permitted {}",
                          memory_text(static_cast<double>(most_kept_))));
}

void Walk::discard_kept(std::size_t module) {
  kept_ -= std::exchange(places_[module].kept_bytes, 0);
  places_[module].kept = SampleCollector();
}

Result<void> Walk::settle() {
  if (is_settled_) return {};
  for (const Part& part : plan_.parts()) {
    SOMATO_TRY_VOID(part.advances ? finish(part) : settle_part(part));
  }
  is_settled_ = true;
  return {};
}

// The sum of frames, and their rate.
Result<void> Walk::finish(const Part& part) {
  give_sequence(part);
  const std::size_t module = part.modules.front();
  if (gives_frames(module)) return {};
  Place& place = places_[module];
  return at_module(module, [&]() -> Result<void> {
    place.runner->value(place.now);
    SOMATO_TRY_VOID(check_finite(place.now.view()));
    if (!plan_[module].is_kept) return {};
    discard_kept(module);
    SOMATO_TRY_VOID(keep(module));
    place.sequence = {place.kept.samples(), place.rate};
    return {};
  });
}

Result<void> Walk::settle_part(const Part& part) {
  if (!at(part.modules.front()).module->is_stepped()) return run_whole(part.modules.front());
  if (!part.takes_frames) {
    if (plan_[part.modules.front()].is_kept) discard_kept(part.modules.front());
    SOMATO_TRY_VOID(step_part(part, 0, 0));
    give_sequence(part);
    return {};
  }
  restart(part);
  SOMATO_TRY(const auto frames, common_frames(part));
  for (std::size_t frame = 0; frame < frames; ++frame) {
    SOMATO_TRY_VOID(step_part(part, frame, 0));
  }
  return finish(part);
}

Result<void> Walk::run_whole(std::size_t module) {
  std::vector<const Sequence*> inputs;
  for (const std::size_t input : at(module).inputs) {
    inputs.push_back(places_[input].known ? places_[input].known : &places_[input].sequence);
  }
  return at_module(module, [&]() -> Result<void> {
    SOMATO_TRY(Sequence output, at(module).module->run(inputs));
    SOMATO_TRY_VOID(check_finite(output));
    Place& place = places_[module];
    place.rate = output.rate;
    place.sequence = std::move(output);
    place.now.assign(place.sequence.values[place.sequence.values.count() - 1]);
    return {};
  });
}

// All frames that were kept, at the rate at which they come in.
void Walk::give_sequence(const Part& part) {
  for (const std::size_t module : part.modules) {
    Place& place = places_[module];
    if (!plan_[module].is_kept && !plan_.is_costly()) continue;
    if (place.source) {
      place.rate = place.channel->frame_rate();
    } else if (part.outer_input) {
      const Place& from = places_[*part.outer_input];
      place.rate = from.known ? from.known->rate : from.rate;
    }
    if (plan_[module].is_kept) place.sequence = {place.kept.samples(), place.rate};
  }
}

Result<void> Walk::count_frames() {
  for (const Part& part : plan_.parts()) {
    if (!part.advances) continue;
    const Place& first = places_[part.modules.front()];
    SOMATO_TRY(const auto frames,
               first.source ? first.channel->frames.rows() : common_frames(part));
    for (const std::size_t module : part.modules) places_[module].frames = frames;
  }
  return {};
}

// The number of frames that come into a part, which all its inputs must have.
Result<std::size_t> Walk::common_frames(const Part& part) const {
  std::optional<std::size_t> common;
  for (const std::size_t module : part.modules) {
    for (const std::size_t input : at(module).inputs) {
      if (contains(part.modules, input)) continue;
      const std::size_t frames = frames_of(input);
      if (common.value_or(frames) != frames) {
        Error error{ErrorKind::kData,
                    fmt::format("{} frames arrive at one port, but {} at another", *common, frames),
                    {},
                    "record the channels together, frame by frame"};
        return fail(system_.at_module(std::move(error), module));
      }
      common = frames;
    }
  }
  return common.value_or(0);
}

std::size_t Walk::frames_of(std::size_t module) const {
  const Place& place = places_[module];
  if (place.known) return place.known->values.count();
  return place.frames == kNoLimit ? place.sequence.values.count() : place.frames;
}

bool Walk::has_frames() const {
  return std::all_of(frames_.begin(), frames_.end(), [](std::size_t frames) { return frames > 0; });
}

std::vector<std::vector<std::string>> Walk::channels() const {
  std::vector<std::vector<std::string>> channels(frames_.size());
  for (const Part& part : plan_.parts()) {
    const Source* source = places_[part.modules.front()].source;
    if (!source) continue;
    std::vector<std::string>& together = channels[part.group];
    if (!contains(together, source->channel())) together.push_back(source->channel());
  }
  return channels;
}

std::optional<SignalView> Walk::output(std::size_t module) const {
  const WalkPlan::Role& role = plan_[module];
  if (!role.is_walked || !has_frames()) return {};
  const bool is_there = (role.group < frames_.size() && gives_frames(module)) || is_settled_;
  if (!is_there) return {};
  return places_[module].now.view();
}

Result<std::size_t> Walk::frames() {
  SOMATO_TRY_VOID(count_frames());
  const std::size_t first = frames_.empty() ? 0 : frames_in(0);
  for (std::size_t stream = 1; stream < frames_.size(); ++stream) {
    if (frames_in(stream) == first) continue;
    return fail(ErrorKind::kData,
                fmt::format("channels that learn after every frame have {} and {} frames", first,
                            frames_in(stream)),
                {}, "record the channels together, frame by frame, or remove 'of'");
  }
  return first;
}

Result<std::size_t> Walk::frames_into(std::size_t module) {
  SOMATO_TRY_VOID(count_frames());
  return common_frames({{module}, {}, true, true, 0});
}

std::vector<SignalView> Walk::inputs_of(std::size_t module) const {
  std::vector<SignalView> views;
  views.reserve(at(module).inputs.size());
  for (const std::size_t input : at(module).inputs) {
    const Sequence* known = places_[input].known;
    const std::size_t frame = gives_frames(input) && steps_ > 0 ? steps_ - 1 : 0;
    views.push_back(known ? known->values[frame] : places_[input].now.view());
  }
  return views;
}

Sequence Walk::take(std::size_t module) {
  return std::move(places_[module].sequence);
}

}  // namespace somato
