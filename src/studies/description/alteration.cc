#include "somato/studies/alteration.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "somato/core/random.h"
#include "studies/description/exploration_samples.h"

namespace somato {
namespace {

constexpr const char* kTables = "altered";

Error misplaced(const Table::Entry& entry) {
  return {ErrorKind::kUsage, "an alteration must be a named table", entry.where,
          "write [altered.NAME] on a separate line, its keys below"};
}

bool changes_nothing(const Alteration& alteration) {
  return alteration.swapped.empty() && alteration.noisy.empty() && alteration.missing.empty() &&
         alteration.first == 1.0;
}

Result<Alteration> read_alteration(const Table::Entry& entry) {
  const auto* table = std::get_if<Table>(&entry.content);
  if (!table) return fail(misplaced(entry));
  SOMATO_TRY(auto alteration, read_parameters<Alteration>(*table));
  alteration.name = entry.name;
  alteration.where = table->where;
  if (changes_nothing(alteration)) {
    return fail(ErrorKind::kUsage, "the alteration '" + entry.name + "' changes nothing",
                table->where, "set 'swapped', 'noisy', 'missing' or 'first'");
  }
  if (table->find("noise") && alteration.noisy.empty()) {
    return fail(ErrorKind::kUsage, "'noise' has no effect without channels",
                table->find("noise")->where, "name them: noisy = [\"...\"]");
  }
  return alteration;
}

Result<std::size_t> channel_index(const Exploration& exploration, const std::string& name,
                                  const std::string& where) {
  const auto channel = find_channel(exploration, name);
  if (!channel) {
    Error error = channel.error();
    error.where = where;
    return fail(std::move(error));
  }
  return static_cast<std::size_t>(*channel - exploration.channels.data());
}

// The readings of `other` with the number of frames and the times of `own`.
Channel readings_of(const Channel& other, const Channel& own) {
  if (own.rate > 0.0) return other;
  Channel channel = own;
  const std::size_t frames = own.frames.rows();
  for (std::size_t frame = 0; frame < frames; ++frame) {
    const std::size_t from = frame * other.frames.rows() / frames;
    std::copy_n(other.frames.row(from).begin(), other.frames.columns(),
                channel.frames.row(frame).begin());
  }
  channel.valid = {};
  return channel;
}

Channel first_frames(const Channel& channel, double share) {
  const std::size_t frames = channel.frames.rows();
  const auto kept = std::max<std::size_t>(
      1, static_cast<std::size_t>(std::ceil(share * static_cast<double>(frames))));
  const auto cut = [&]<typename T>(const Matrix<T>& matrix) {
    const auto begin = matrix.values().begin();
    const auto end = begin + static_cast<std::ptrdiff_t>(kept * matrix.columns());
    return Matrix<T>(kept, matrix.columns(), std::vector<T>(begin, end));
  };
  Channel first = channel;
  first.frames = cut(channel.frames);
  if (!channel.valid.empty()) first.valid = cut(channel.valid);
  if (!channel.times.empty()) first.times.resize(kept);
  return first;
}

// Standard deviations of a channel's elements over all frames of the recording.
std::vector<double> deviations(const Recording& recording, std::size_t channel) {
  const std::size_t elements = recording.explorations.front().channels[channel].frames.columns();
  std::vector<double> sums(elements);
  std::vector<double> squares(elements);
  double frames = 0.0;
  for (const Exploration& exploration : recording.explorations) {
    const Matrix<float>& values = exploration.channels[channel].frames;
    frames += static_cast<double>(values.rows());
    for (std::size_t frame = 0; frame < values.rows(); ++frame) {
      for (std::size_t i = 0; i < elements; ++i) {
        const double value = static_cast<double>(values.row(frame)[i]);
        sums[i] += value;
        squares[i] += value * value;
      }
    }
  }
  for (std::size_t i = 0; i < elements; ++i) {
    const double mean = sums[i] / frames;
    sums[i] = std::sqrt(std::max(0.0, squares[i] / frames - mean * mean));
  }
  return sums;
}

void add_noise(Matrix<float>& frames, const std::vector<double>& scales, Random& random) {
  for (std::size_t frame = 0; frame < frames.rows(); ++frame) {
    for (std::size_t i = 0; i < frames.columns(); ++i) {
      frames.row(frame)[i] += static_cast<float>(scales[i] * random.normal());
    }
  }
}

// Alters explorations one after the other; channels are resolved and measured once.
class Alterer {
 public:
  static Result<Alterer> make(const Recording& recording, const Alteration& alteration,
                              const std::string& label) {
    Alterer alterer(recording, alteration);
    const auto resolve = [&](const std::vector<std::string>& names,
                             std::vector<std::size_t>& channels) -> Result<void> {
      for (const std::string& name : names) {
        SOMATO_TRY(const std::size_t index,
                   channel_index(recording.explorations.front(), name, alteration.where));
        channels.push_back(index);
      }
      return {};
    };
    SOMATO_TRY_VOID(resolve(alteration.swapped, alterer.swapped_));
    SOMATO_TRY_VOID(resolve(alteration.noisy, alterer.noisy_));
    SOMATO_TRY_VOID(resolve(alteration.missing, alterer.missing_));
    for (const std::size_t channel : alterer.noisy_) {
      std::vector<double> scales = deviations(recording, channel);
      for (double& scale : scales) scale *= alteration.noise;
      alterer.scales_.push_back(std::move(scales));
    }
    if (alteration.swapped.empty()) return alterer;
    SOMATO_TRY_VOID(alterer.find_classes(label));
    return alterer;
  }

  Exploration alter(std::size_t number) const {
    Exploration exploration = recording_.explorations[number];
    exploration.source += " (" + alteration_.name + ")";
    Random random(number, Stream::kAlterations);
    if (!swapped_.empty()) swap(exploration, number, random);
    for (std::size_t i = 0; i < noisy_.size(); ++i) {
      add_noise(exploration.channels[noisy_[i]].frames, scales_[i], random);
    }
    for (const std::size_t channel : missing_) silence(exploration.channels[channel]);
    if (alteration_.first < 1.0) {
      for (Channel& channel : exploration.channels) {
        channel = first_frames(channel, alteration_.first);
      }
    }
    return exploration;
  }

 private:
  Alterer(const Recording& recording, const Alteration& alteration)
      : recording_(recording), alteration_(alteration) {}

  Result<void> find_classes(const std::string& label) {
    SOMATO_TRY(auto classes, numbers_of(recording_, label));
    classes_ = std::move(classes);
    const bool differ = std::any_of(classes_.begin(), classes_.end(), [&](std::size_t its_class) {
      return its_class != classes_.front();
    });
    if (differ) return {};
    return fail(ErrorKind::kData, "every exploration has the same '" + label + "'",
                alteration_.where, "leave out 'swapped', or use another label");
  }

  void swap(Exploration& exploration, std::size_t number, Random& random) const {
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < classes_.size(); ++i) {
      if (classes_[i] != classes_[number]) others.push_back(i);
    }
    const Exploration& other = recording_.explorations[others[random.below(others.size())]];
    for (const std::size_t channel : swapped_) {
      exploration.channels[channel] =
          readings_of(other.channels[channel], exploration.channels[channel]);
    }
  }

  static void silence(Channel& channel) {
    channel.frames = Matrix<float>(channel.frames.rows(), channel.frames.columns());
    channel.valid = {};
  }

  const Recording& recording_;
  const Alteration& alteration_;
  std::vector<std::size_t> swapped_;
  std::vector<std::size_t> noisy_;
  std::vector<std::vector<double>> scales_;  // of each noisy channel
  std::vector<std::size_t> missing_;
  std::vector<std::size_t> classes_;
};

}  // namespace

const Declarations<Alteration>& Alteration::declarations() {
  using P = Alteration;
  static const auto declared =
      Declarations<P>()
          .add("swapped", &P::swapped, "", Range::any(),
               "Channels whose readings are those of a randomly drawn exploration of another "
               "class, so that they contradict the others.")
          .add("noisy", &P::noisy, "", Range::any(), "Channels to which noise is added.")
          .add("noise", &P::noise, "", Range::above(0.0),
               "Standard deviation of the noise, in standard deviations of each element over the "
               "recording.")
          .add("missing", &P::missing, "", Range::any(), "Channels whose readings are 0.")
          .add("first", &P::first, "", Range{0.0, 1.0, true},
               "Share of the frames of each channel that is used, from the first one on; at least "
               "one frame.");
  return declared;
}

Result<std::vector<Alteration>> read_alterations(const Table& file) {
  std::vector<Alteration> alterations;
  const Table::Entry* entry = file.find(kTables);
  if (!entry) return alterations;
  const auto* tables = std::get_if<Table>(&entry->content);
  if (!tables) return fail(misplaced(*entry));
  for (const Table::Entry& one : tables->entries) {
    SOMATO_TRY(auto alteration, read_alteration(one));
    alterations.push_back(std::move(alteration));
  }
  return alterations;
}

std::string to_toml(const std::vector<Alteration>& alterations) {
  std::string text;
  for (const Alteration& alteration : alterations) {
    text += std::string("[") + kTables + "." + alteration.name + "]\n";
    for (const auto& parameter : Alteration::declarations().all()) {
      const std::string value = to_toml(parameter.read(alteration));
      if (value != parameter.info.default_text) text += parameter.info.name + " = " + value + "\n";
    }
    text += "\n";
  }
  return text;
}

Result<std::vector<Exploration>> altered(const Recording& recording, const Alteration& alteration,
                                         const std::string& label) {
  SOMATO_TRY(const auto alterer, Alterer::make(recording, alteration, label));
  std::vector<Exploration> explorations;
  explorations.reserve(recording.explorations.size());
  for (std::size_t i = 0; i < recording.explorations.size(); ++i) {
    explorations.push_back(alterer.alter(i));
  }
  return explorations;
}

}  // namespace somato
