#include "studies/inference/recording_statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>

#include "base/core/contains.h"
#include "base/text/text.h"
#include "somato/core/value.h"
#include "systems/signals/channel_features.h"
#include "systems/signals/mean_and_spread.h"

namespace somato {
namespace {

constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
constexpr double kSameRate = 0.01;    // as a share
constexpr double kLeastScale = 0.01;  // as a share of the spread of all values

std::size_t feature_count(const ComparedTouch& compared) {
  std::size_t count = 0;
  for (const FeaturedChannel& channel : compared.channels)
    count += channel_feature_names(channel).size();
  return count;
}

// The column of the first feature of each channel.
std::vector<std::size_t> first_features(const ComparedTouch& compared) {
  std::vector<std::size_t> first;
  std::size_t count = 0;
  for (const FeaturedChannel& channel : compared.channels) {
    first.push_back(count);
    count += channel_feature_names(channel).size();
  }
  return first;
}

std::size_t groups_of(const ComparedTouch& compared) {
  return std::max<std::size_t>(compared.things.size(), 1);
}

// The standard deviation between explorations of the same thing, over things that were explored at
// least twice.
double spread_between(const TouchFeatures& touch, const std::vector<std::size_t>& rows,
                      std::size_t column) {
  std::map<std::size_t, MeanAndSpread> things;
  for (const std::size_t row : rows) things[touch.same[row]].add(touch.features(row, column));
  double squares = 0.0;
  double degrees = 0.0;
  for (const auto& [thing, moments] : things) {
    if (moments.count() < 2) continue;
    squares += moments.squares();
    degrees += static_cast<double>(moments.count() - 1);
  }
  return degrees > 0.0 ? std::sqrt(squares / degrees) : kNoValue;
}

// Over explorations; 0 if one does not vary, and nothing of fewer than three.
double correlation_of(const TouchFeatures& touch, const std::vector<std::size_t>& rows,
                      std::size_t a, std::size_t b) {
  MeanAndSpread of_a;
  MeanAndSpread of_b;
  const auto measured = [&](std::size_t row) {
    return std::isfinite(touch.features(row, a)) && std::isfinite(touch.features(row, b));
  };
  for (const std::size_t row : rows) {
    if (!measured(row)) continue;
    of_a.add(touch.features(row, a));
    of_b.add(touch.features(row, b));
  }
  if (of_a.count() < 3) return kNoValue;
  double products = 0.0;
  for (const std::size_t row : rows) {
    if (!measured(row)) continue;
    products += (touch.features(row, a) - of_a.mean()) * (touch.features(row, b) - of_b.mean());
  }
  const double scale = std::sqrt(of_a.squares() * of_b.squares());
  return scale > 0.0 ? products / scale : 0.0;
}

bool is_correlation(const Statistic& statistic) {
  return statistic.measure.starts_with("correlation");
}

std::vector<std::size_t> without(const std::vector<std::size_t>& rows, std::size_t position) {
  std::vector<std::size_t> others = rows;
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(position));
  return others;
}

// The squared standard error times the number of explorations, from values without each of them.
double squared_scale(const MeanAndSpread& values) {
  if (values.count() < 2) return kNoValue;
  return static_cast<double>(values.count() - 1) * values.squares();
}

// The deviations of all values of each channel, between and within explorations.
std::vector<double> channel_spreads(const ComparedTouch& compared, const TouchFeatures& touch,
                                    const std::vector<std::size_t>& rows) {
  std::vector<double> spreads;
  for (const std::size_t first : first_features(compared)) {
    MeanAndSpread means;
    MeanAndSpread variances;
    for (const std::size_t row : rows) {
      const double spread = touch.features(row, first + kSpreadFeature);
      means.add(touch.features(row, first + kMeanFeature));
      variances.add(spread * spread);
    }
    spreads.push_back(std::sqrt(means.variance() + variances.mean()));
  }
  return spreads;
}

// 1 for two channels, which have a correlation.
double spread_of(const ComparedTouch& compared, const std::vector<double>& spreads,
                 const std::string& channel) {
  for (std::size_t c = 0; c < spreads.size(); ++c) {
    if (compared.channels[c].name == channel) return spreads[c];
  }
  return 1.0;
}

// The statistics without each of the explorations in turn, if it is among those they are about.
std::vector<MeanAndSpread> values_without_each(const ComparedTouch& compared,
                                               const TouchFeatures& touch,
                                               const std::vector<std::size_t>& rows) {
  const std::size_t features = touch.features.columns();
  std::vector<MeanAndSpread> all(statistic_names(compared).size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::vector<double> values = statistics_of(compared, touch, without(rows, i));
    for (std::size_t k = 0; k < values.size(); ++k) {
      const bool is_about =
          k >= groups_of(compared) * features || k / features == touch.thing[rows[i]];
      if (is_about) all[k].add(values[k]);
    }
  }
  return all;
}

std::string label_of(const Recording& real, const Recording& simulated) {
  for (const char* name : {"object", "material"}) {
    if (find_label(real.explorations.front(), name) &&
        find_label(simulated.explorations.front(), name))
      return name;
  }
  return "";
}

Result<void> take_things(const Recording& real, const Recording& simulated,
                         const MatchParameters& parameters, ComparedTouch& compared) {
  compared.label = parameters.label.empty() ? label_of(real, simulated) : parameters.label;
  if (compared.label.empty()) return {};
  SOMATO_TRY(const auto real_things, label_values(real, compared.label));
  SOMATO_TRY(const auto simulated_things, label_values(simulated, compared.label));
  for (const std::string& thing : real_things) {
    if (contains(simulated_things, thing)) compared.things.push_back(thing);
  }
  return {};
}

double rate_of(const Recording& recording, const std::string& channel) {
  return (*find_channel(recording.explorations.front(), channel))->frame_rate();
}

std::size_t least_frames(const Recording& recording, const std::string& channel) {
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const Exploration& exploration : recording.explorations) {
    const auto found = find_channel(exploration, channel);
    if (found) least = std::min(least, (*found)->frames.rows());
  }
  return least;
}

FeaturedChannel compared_channel(const Recording& real, const Recording& simulated,
                                 const Channel& channel) {
  const std::size_t frames = least_frames(real, channel.name);
  FeaturedChannel compared{channel.name, channel.frames.columns(), false, 0};
  compared.is_series =
      frames >= kLeastSeriesFrames && least_frames(simulated, channel.name) >= kLeastSeriesFrames;
  const double rate = rate_of(real, channel.name);
  const bool same_rate =
      rate > 0.0 && std::abs(rate_of(simulated, channel.name) - rate) <= kSameRate * rate;
  if (!compared.is_series || !same_rate || frames < kLeastSpectrumFrames) return compared;
  compared.spectrum_frames = kLeastSpectrumFrames;
  while (2 * compared.spectrum_frames <= std::min(frames, kMostSpectrumFrames))
    compared.spectrum_frames *= 2;
  return compared;
}

std::string why_ignored(const Channel& real, const Exploration& simulated) {
  const auto found = find_channel(simulated, real.name);
  if (!found) return "the simulated body does not have it";
  if ((*found)->frame_shape() != real.frame_shape())
    return "it has another shape in the simulation";
  if (!real.unit.empty() && !(*found)->unit.empty() && real.unit != (*found)->unit)
    return "its unit is " + (*found)->unit + " in the simulation and " + real.unit + " here";
  return "";
}

Result<void> check_channels(const Recording& real, const MatchParameters& parameters) {
  for (const std::string& name : parameters.channels) {
    SOMATO_TRY_VOID(find_channel(real.explorations.front(), name));
  }
  return {};
}

void take_channels(const Recording& real, const Recording& simulated,
                   const MatchParameters& parameters, ComparedTouch& compared) {
  for (const Channel& channel : real.explorations.front().channels) {
    if (channel.name.starts_with("true_")) continue;
    std::string reason = why_ignored(channel, simulated.explorations.front());
    if (reason.empty() && !parameters.channels.empty() &&
        !contains(parameters.channels, channel.name))
      reason = "it is not among the given channels";
    if (reason.empty()) {
      compared.channels.push_back(compared_channel(real, simulated, channel));
    } else {
      compared.ignored.push_back({channel.name, reason});
    }
  }
  for (const Channel& channel : simulated.explorations.front().channels) {
    if (channel.name.starts_with("true_") || find_channel(real.explorations.front(), channel.name))
      continue;
    compared.ignored.push_back({channel.name, "the given recording does not have it"});
  }
}

std::string ignored_text(const ComparedTouch& compared) {
  std::string text;
  for (const IgnoredChannel& channel : compared.ignored)
    text += (text.empty() ? "'" : "; '") + channel.name + "': " + channel.reason;
  return text;
}

// The number of its thing; nothing if it is not compared.
std::optional<std::size_t> thing_of(const ComparedTouch& compared, const std::string& value) {
  if (compared.things.empty()) return 0;
  const auto found = std::find(compared.things.begin(), compared.things.end(), value);
  if (found == compared.things.end()) return {};
  return static_cast<std::size_t>(found - compared.things.begin());
}

Result<std::string> value_of_label(const ComparedTouch& compared, const Exploration& exploration) {
  if (compared.label.empty()) return std::string();
  return find_label(exploration, compared.label);
}

Result<void> add_features(const ComparedTouch& compared, const Exploration& exploration,
                          std::span<double> row) {
  auto to = row.begin();
  for (const FeaturedChannel& channel : compared.channels) {
    SOMATO_TRY(const auto* found, find_channel(exploration, channel.name));
    if (found->frames.columns() != channel.elements) {
      return fail(ErrorKind::kData,
                  fmt::format("the channel '{}' has {} elements and elsewhere {}", channel.name,
                              found->frames.columns(), channel.elements),
                  exploration.source, "use recordings of one body");
    }
    to = std::ranges::copy(channel_features(channel, *found), to).out;
  }
  return {};
}

}  // namespace

const Declarations<MatchParameters>& MatchParameters::declarations() {
  using P = MatchParameters;
  static const auto declared =
      Declarations<P>()
          .add("label", &P::label, "", Range::any(),
               "Label of the things that were explored. Things that both recordings have are "
               "compared one by one. Default: object, or else material, if both have it.")
          .add("channels", &P::channels, "", Range::any(),
               "Channels to compare. Default: all that both recordings have.");
  return declared;
}

Result<ComparedTouch> compared_touch(const Recording& real, const Recording& simulated,
                                     const MatchParameters& parameters) {
  ComparedTouch compared;
  SOMATO_TRY_VOID(check_channels(real, parameters));
  SOMATO_TRY_VOID(take_things(real, simulated, parameters, compared));
  take_channels(real, simulated, parameters, compared);
  if (!compared.channels.empty()) return compared;
  return fail(ErrorKind::kData, "the recordings have no common channel: " + ignored_text(compared),
              real.explorations.front().source,
              "give the channels the same names, shapes and units, as with 'somato import'");
}

std::vector<Statistic> statistic_names(const ComparedTouch& compared) {
  std::vector<Statistic> names;
  for (std::size_t group = 0; group < groups_of(compared); ++group) {
    const std::string thing = compared.things.empty() ? "" : compared.things[group];
    for (const FeaturedChannel& channel : compared.channels) {
      for (std::string& name : channel_feature_names(channel))
        names.push_back({channel.name, std::move(name), thing});
    }
  }
  for (const FeaturedChannel& channel : compared.channels)
    names.push_back({channel.name, "spread between explorations of a thing", ""});
  for (std::size_t a = 0; a < compared.channels.size(); ++a) {
    for (std::size_t b = a + 1; b < compared.channels.size(); ++b) {
      names.push_back({compared.channels[a].name + ", " + compared.channels[b].name,
                       "correlation between explorations", ""});
    }
  }
  return names;
}

Result<TouchFeatures> touch_features(const ComparedTouch& compared, const Recording& recording) {
  TouchFeatures touch{Matrix<double>(0, feature_count(compared)), {}, {}};
  std::map<std::string, std::size_t> numbers;
  for (const Exploration& exploration : recording.explorations) {
    SOMATO_TRY(const auto value, value_of_label(compared, exploration));
    const auto thing = thing_of(compared, value);
    if (!thing) continue;
    touch.thing.push_back(*thing);
    touch.same.push_back(numbers.emplace(value, numbers.size()).first->second);
    SOMATO_TRY_VOID(add_features(compared, exploration, touch.features.add_row()));
  }
  return touch;
}

std::vector<double> statistics_of(const ComparedTouch& compared, const TouchFeatures& touch,
                                  const std::vector<std::size_t>& rows) {
  const std::size_t features = touch.features.columns();
  std::vector<MeanAndSpread> means(groups_of(compared) * features);
  for (const std::size_t row : rows) {
    for (std::size_t f = 0; f < features; ++f)
      means[touch.thing[row] * features + f].add(touch.features(row, f));
  }
  std::vector<double> statistics;
  statistics.reserve(means.size());
  for (const MeanAndSpread& mean : means) statistics.push_back(mean.mean());
  const std::vector<std::size_t> first = first_features(compared);
  for (const std::size_t column : first)
    statistics.push_back(spread_between(touch, rows, column + kMeanFeature));
  for (std::size_t a = 0; a < first.size(); ++a) {
    for (std::size_t b = a + 1; b < first.size(); ++b)
      statistics.push_back(
          correlation_of(touch, rows, first[a] + kMeanFeature, first[b] + kMeanFeature));
  }
  return statistics;
}

std::vector<double> statistic_scales(const ComparedTouch& compared, const TouchFeatures& touch,
                                     const std::vector<std::size_t>& rows) {
  const std::vector<Statistic> names = statistic_names(compared);
  const std::size_t features = touch.features.columns();
  const std::size_t of_things = groups_of(compared) * features;
  const std::vector<MeanAndSpread> values = values_without_each(compared, touch, rows);
  const std::vector<double> spreads = channel_spreads(compared, touch, rows);
  std::vector<double> scales;
  for (std::size_t k = 0; k < names.size(); ++k) {
    double squares = squared_scale(values[k]);
    if (std::isnan(squares) && k < of_things) {
      MeanAndSpread others;
      for (std::size_t other = k % features; other < of_things; other += features)
        others.add(squared_scale(values[other]));
      squares = others.mean();
    }
    const double spread = spread_of(compared, spreads, names[k].channel);
    const double least = kLeastScale * (is_correlation(names[k]) ? 1.0 : spread);
    const double scale = std::sqrt(squares);
    scales.push_back(spread > 0.0 && scale < least ? least : scale);
  }
  return scales;
}

std::pair<std::vector<std::size_t>, std::vector<std::size_t>> halves_of(
    const TouchFeatures& touch) {
  std::map<std::size_t, std::vector<std::size_t>> things;
  std::size_t most = 0;
  for (std::size_t row = 0; row < touch.same.size(); ++row) {
    std::vector<std::size_t>& same = things[touch.same[row]];
    same.push_back(row);
    most = std::max(most, same.size());
  }
  if (most < 2) {
    std::vector<std::size_t> all;
    all.reserve(touch.same.size());
    for (std::size_t row = 0; row < touch.same.size(); ++row) all.push_back(row);
    things = {{0, all}};
  }
  std::pair<std::vector<std::size_t>, std::vector<std::size_t>> halves;
  for (const auto& [thing, rows] : things) {
    const auto middle = rows.begin() + static_cast<std::ptrdiff_t>((rows.size() + 1) / 2);
    halves.first.insert(halves.first.end(), rows.begin(), middle);
    halves.second.insert(halves.second.end(), middle, rows.end());
  }
  return halves;
}

}  // namespace somato
