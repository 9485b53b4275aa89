#include "somato/studies/vectors.h"

#include <utility>

namespace somato {
namespace {

void append_frames(const Matrix<float>& frames, FrameChoice choice, std::vector<float>& vector) {
  const auto first = frames.row(0);
  const auto last = frames.row(frames.rows() - 1);
  for (std::size_t i = 0; i < frames.columns(); ++i) {
    if (choice == FrameChoice::kFirst) vector.push_back(first[i]);
    if (choice == FrameChoice::kLast) vector.push_back(last[i]);
    if (choice == FrameChoice::kChange) vector.push_back(last[i] - first[i]);
  }
}

void append_names(const Channel& channel, std::vector<std::string>& names) {
  for (std::size_t i = 0; i < channel.frames.columns(); ++i) {
    const std::string element =
        channel.element_names.empty() ? std::to_string(i + 1) : channel.element_names[i];
    names.push_back(channel.name + "." + element);
  }
}

}  // namespace

Result<Vectors> make_vectors(const Recording& recording, const VectorParameters& parameters) {
  Vectors vectors;
  std::vector<Signal> signals;
  for (const Exploration& exploration : recording.explorations) {
    std::vector<float> vector;
    for (const std::string& name : parameters.channels) {
      Result<const Channel*> channel = find_channel(exploration, name);
      if (!channel) return fail(std::move(channel.error()));
      append_frames((*channel)->frames, parameters.frames, vector);
      if (signals.empty()) append_names(**channel, vectors.element_names);
    }
    signals.push_back(Signal::dense(std::move(vector)));
  }
  vectors.samples = Samples::from_signals(signals);
  return vectors;
}

}  // namespace somato
