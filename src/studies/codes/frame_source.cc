#include "studies/codes/frame_source.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "somato/graph/evaluation.h"
#include "somato/graph/system.h"
#include "studies/codes/rounding.h"

namespace somato {
namespace {

constexpr std::size_t kLongestName = 24;  // so that names with codes have at most 100 characters
constexpr double kOnsetShare = 0.2;
constexpr double kLeastSpread = 0.05;
constexpr std::size_t kLeastFrames = 8;

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

// Names with these words could be those of a code of another channel.
bool is_usable(const std::string& name) {
  if (name.empty() || name.size() > kLongestName || name == "map" || name == "vector") return false;
  return std::ranges::all_of(name, is_plain) && name.find("_of_") == std::string::npos &&
         name.find("_times_") == std::string::npos && name.find("_from_") == std::string::npos;
}

bool may_miss_values(const Recording& recording, std::size_t channel) {
  return std::ranges::any_of(recording.explorations, [&](const Exploration& exploration) {
    return !exploration.channels[channel].valid.empty();
  });
}

Value::List lengths_of(const Channel& channel) {
  Value::List lengths;
  for (const std::size_t length : channel.frame_shape()) {
    lengths.push_back({static_cast<std::int64_t>(length)});
  }
  return lengths;
}

Value::List names_of_elements(const Channel& channel) {
  Value::List names;
  for (const std::string& name : channel.element_names) names.push_back({name});
  return names;
}

// Columns of a table with names, which other tables may have in another order.
bool are_columns(const Recording& recording, std::size_t channel) {
  const std::vector<std::string>& names =
      recording.explorations.front().channels[channel].element_names;
  const std::set<std::string> different(names.begin(), names.end());
  return !names.empty() && different.size() == names.size() && may_mix_units(recording, channel);
}

// The mean of the valid values of each element, 0 if there are none.
Value::List known_means(const Recording& recording, std::size_t channel) {
  const std::size_t elements = recording.explorations.front().channels[channel].frames.columns();
  std::vector<double> sums(elements, 0.0);
  std::vector<double> counts(elements, 0.0);
  for (const Exploration& exploration : recording.explorations) {
    const Channel& frames = exploration.channels[channel];
    for (std::size_t row = 0; row < frames.frames.rows(); ++row) {
      for (std::size_t i = 0; i < elements; ++i) {
        if (!frames.valid.empty() && frames.valid(row, i) == 0) continue;
        sums[i] += double{frames.frames(row, i)};
        counts[i] += 1.0;
      }
    }
  }
  Value::List means;
  for (std::size_t i = 0; i < elements; ++i) {
    means.push_back({plain(static_cast<float>(sums[i] / std::max(counts[i], 1.0)))});
  }
  return means;
}

// The change of any element since the first frame.
double change_in(const Matrix<float>& frames, std::size_t row) {
  double change = 0.0;
  for (std::size_t i = 0; i < frames.columns(); ++i) {
    change = std::max(change, std::fabs(double{frames(row, i)} - double{frames(0, i)}));
  }
  return change;
}

double largest_change(const Matrix<float>& frames) {
  double change = 0.0;
  for (std::size_t row = 0; row < frames.rows(); ++row) {
    change = std::max(change, change_in(frames, row));
  }
  return change;
}

// The first frame that changed as much as that, or the number of frames.
std::size_t onset_of(const Matrix<float>& frames, double threshold) {
  std::size_t row = 0;
  while (row < frames.rows() && change_in(frames, row) < threshold) ++row;
  return row;
}

template <typename T>
T median_of(std::vector<T> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

Exploration with_frames(const System& system, const Activations& activations,
                        const std::vector<std::size_t>& outputs, std::size_t exploration) {
  Exploration frames;
  for (const std::size_t output : outputs) {
    const Sequence& sequence = *activations.find(output, exploration);
    Channel channel;
    channel.name = system.modules()[output].name;
    channel.rate = sequence.rate;
    channel.frames = Matrix<float>(sequence.values.count(), sequence.values.size());
    for (std::size_t row = 0; row < sequence.values.count(); ++row) {
      write_dense(sequence.values[row], channel.frames.row(row));
    }
    frames.channels.push_back(std::move(channel));
  }
  return frames;
}

}  // namespace

std::vector<std::string> module_names(const std::vector<std::string>& channels) {
  std::set<std::string> used;
  std::vector<std::string> names;
  for (const std::string& channel : channels) {
    const bool usable = is_usable(channel) && !channel.starts_with("channel_");
    std::string name = usable ? channel : "channel_" + std::to_string(names.size() + 1);
    if (!used.insert(name).second) name = "channel_" + std::to_string(names.size() + 1);
    names.push_back(std::move(name));
  }
  return names;
}

bool has_several_frames(const Recording& recording, std::size_t channel) {
  return std::ranges::any_of(recording.explorations, [&](const Exploration& exploration) {
    return exploration.channels[channel].frames.rows() > 1;
  });
}

bool may_mix_units(const Recording& recording, std::size_t channel) {
  const Channel& first = recording.explorations.front().channels[channel];
  return first.unit.empty() && first.frames.columns() > 1 &&
         !has_several_frames(recording, channel);
}

FrameSource channel_source(const std::string& module, const Recording& recording,
                           std::size_t channel) {
  const Channel& first = recording.explorations.front().channels[channel];
  std::vector<SystemBuilder::Setting> settings{{"channel", {first.name}}};
  if (are_columns(recording, channel)) {
    settings.push_back({"elements", {names_of_elements(first)}});
  } else {
    settings.push_back({"shape", {lengths_of(first)}});
  }
  if (may_miss_values(recording, channel)) {
    if (has_several_frames(recording, channel)) {
      settings.push_back({"invalid", {std::string("hold")}});
    }
    settings.push_back({"fill", {known_means(recording, channel)}});
  }
  return {SystemBuilder("").module(module, "channel", settings).description().modules, {module}};
}

FrameSource from_onset(const FrameSource& source, const Onset& onset) {
  FrameSource aligned = source;
  const std::string name = source.outputs.front() + "_from_onset";
  const auto window =
      SystemBuilder("").module(name, "onset_window",
                               {{"input", {source.outputs.front()}},
                                {"quantity", {std::string("change")}},
                                {"threshold", {onset.threshold}},
                                {"length", {static_cast<std::int64_t>(onset.length)}}});
  aligned.modules.push_back(window.description().modules.front());
  aligned.outputs.front() = name;
  return aligned;
}

Result<Recording> frames_of(const Recording& recording, const FrameSource& source,
                            std::size_t threads) {
  SOMATO_TRY(const auto system,
             System::build({"frames", source.modules, {}}, layout_of(recording)));
  std::vector<std::size_t> outputs;
  for (const std::string& name : source.outputs) {
    SOMATO_TRY(const std::size_t output, system.find(name));
    outputs.push_back(output);
  }
  std::vector<std::size_t> all(recording.explorations.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  Activations activations(system.modules().size(), all.size());
  SOMATO_TRY_VOID(evaluate(system, recording, all, outputs, threads, activations));
  Recording frames;
  for (const std::size_t exploration : all) {
    frames.explorations.push_back(with_frames(system, activations, outputs, exploration));
  }
  return frames;
}

std::optional<Onset> find_varying_onset(const Recording& frames) {
  std::vector<double> changes;
  std::vector<std::size_t> lengths;
  for (const Exploration& exploration : frames.explorations) {
    changes.push_back(largest_change(exploration.channels.front().frames));
    lengths.push_back(exploration.channels.front().frames.rows());
  }
  const double threshold = rounded(kOnsetShare * median_of(changes));
  if (threshold <= 0.0 || *std::ranges::min_element(changes) < threshold) return std::nullopt;
  std::vector<std::size_t> onsets;
  std::size_t length = lengths.front();
  for (std::size_t i = 0; i < lengths.size(); ++i) {
    onsets.push_back(onset_of(frames.explorations[i].channels.front().frames, threshold));
    length = std::min(length, lengths[i] - onsets.back());
  }
  const auto [least, most] = std::ranges::minmax_element(onsets);
  const double spread = kLeastSpread * static_cast<double>(median_of(lengths));
  if (static_cast<double>(*most - *least) <= spread || length < kLeastFrames) return std::nullopt;
  return Onset{threshold, length};
}

}  // namespace somato
