#include "graph/frame_walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "graph/finite.h"

namespace somato {

FrameWalk::FrameWalk(const System& system, const std::vector<std::size_t>& modules,
                     const std::vector<std::size_t>& listeners)
    : system_(system),
      walked_(modules.size()),
      listeners_(modules),
      places_(system.modules().size(), modules.size()),
      outside_(system.modules().size()),
      outputs_(modules.size()),
      before_(modules.size()) {
  listeners_.insert(listeners_.end(), listeners.begin(), listeners.end());
  for (std::size_t place = 0; place < modules.size(); ++place) places_[modules[place]] = place;
  for (std::size_t place = 0; place < modules.size(); ++place) {
    walked_[place].module = modules[place];
    for (const std::size_t input : system.modules()[modules[place]].inputs) {
      if (is_walked(input) && places_[input] >= place) walked_[place].delays_loop = true;
    }
  }
}

Result<void> FrameWalk::start(const Outside& outside) {
  next_ = 0;
  has_frames_ = false;
  for (const std::size_t module : listeners_) {
    if (auto heard = listen(module, outside); !heard) return heard;
  }
  for (Walked& walked : walked_) walked.stepper = system_.modules()[walked.module].module->start();
  std::fill(before_.begin(), before_.end(), std::nullopt);
  std::fill(outputs_.begin(), outputs_.end(), std::nullopt);
  return {};
}

Result<void> FrameWalk::listen(std::size_t module, const Outside& outside) {
  for (const std::size_t input : system_.modules()[module].inputs) {
    if (is_walked(input)) continue;
    outside_[input] = outside(input);
    const std::size_t frames = outside_[input]->values.count();
    if (has_frames_ && frames != frames_) {
      Error error{ErrorKind::kData,
                  fmt::format("{} frames come in where there are {} elsewhere", frames, frames_),
                  {},
                  "record the channels together, frame by frame"};
      return fail(system_.at_module(std::move(error), module));
    }
    has_frames_ = true;
    frames_ = frames;
    rate_ = outside_[input]->rate;
  }
  return {};
}

Result<void> FrameWalk::step() {
  std::swap(before_, outputs_);
  frame_ = next_++;
  for (std::size_t place = 0; place < walked_.size(); ++place) {
    Walked& walked = walked_[place];
    if (walked.delays_loop) {
      outputs_[place] = delayed(walked);
      continue;
    }
    Result<Signal> output = walked.stepper->step(inputs_of(walked.module));
    if (output) {
      if (auto finite = check_finite(output->view()); !finite) output = fail(finite.error());
    }
    if (!output) {
      output.error().what += fmt::format(" (frame {})", frame_ + 1);
      return fail(system_.at_module(std::move(output.error()), walked.module));
    }
    outputs_[place] = std::move(*output);
  }
  return {};
}

std::vector<SignalView> FrameWalk::inputs_of(std::size_t module) const {
  std::vector<SignalView> views;
  const std::vector<std::size_t>& inputs = system_.modules()[module].inputs;
  views.reserve(inputs.size());
  for (const std::size_t input : inputs) views.push_back(view_of(input));
  return views;
}

SignalView FrameWalk::view_of(std::size_t module) const {
  if (is_walked(module)) return outputs_[places_[module]]->view();
  return outside_[module]->values[frame_];
}

// What its input gave with the frame before; zeros at the start.
Signal FrameWalk::delayed(const Walked& walked) const {
  const SystemModule& module = system_.modules()[walked.module];
  const auto& before = before_[places_[module.inputs.front()]];
  if (!before) {
    return Signal::dense(module.output.shape, std::vector<float>(module.output.size()));
  }
  return before->is_sparse() ? Signal::dense(module.output.shape, before->to_dense()) : *before;
}

}  // namespace somato
