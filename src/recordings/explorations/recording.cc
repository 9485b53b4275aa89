#include "somato/recording/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "recordings/explorations/recording_outline.h"
#include "somato/core/parameter.h"

namespace somato {
namespace {

template <typename Named>
std::vector<std::string> names_of(const std::vector<Named>& all) {
  std::vector<std::string> names;
  names.reserve(all.size());
  for (const Named& named : all) names.push_back(named.name);
  return names;
}

template <typename Named>
Result<const Named*> find_named(const std::vector<Named>& all, std::string_view kind,
                                std::string_view name, const std::string& where) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Named& named) { return named.name == name; });
  if (found != all.end()) return &*found;
  return fail(unknown_name(kind, name, where, names_of(all)));
}

std::string place(const Recording& recording, std::size_t index) {
  const std::string& source = recording.explorations[index].source;
  return source.empty() ? fmt::format("exploration {}", index + 1) : source;
}

tl::unexpected<Error> bad_data(std::string what, std::string advice = {}) {
  return fail(ErrorKind::kData, std::move(what), {}, std::move(advice));
}

Result<void> check_names(std::string_view kind, const std::vector<std::string>& names) {
  std::set<std::string> seen;
  for (const std::string& name : names) {
    if (name.empty()) return bad_data(fmt::format("a {} has no name", kind));
    if (!seen.insert(name).second) {
      return bad_data(fmt::format("there are two {}s '{}'", kind, name), "rename one of them");
    }
  }
  return {};
}

Result<void> check_times(const Channel& channel) {
  const std::vector<double>& times = channel.times;
  if (times.empty()) return {};
  if (times.size() != channel.frames.rows()) {
    return bad_data(fmt::format("channel '{}' has {} times for {} frames", channel.name,
                                times.size(), channel.frames.rows()),
                    "use one time per frame, or none");
  }
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!std::isfinite(times[i]) || (i > 0 && times[i] < times[i - 1])) {
      return bad_data(
          fmt::format("channel '{}', frame {}: the time {} s is not finite or "
                      "precedes that of the preceding frame",
                      channel.name, i + 1, times[i]));
    }
  }
  return {};
}

Result<void> check_rate(const Channel& channel) {
  if (!std::isfinite(channel.rate) || channel.rate < 0.0) {
    return bad_data(fmt::format("channel '{}' has a rate of {} Hz", channel.name, channel.rate),
                    "use a rate above 0, or none");
  }
  if (channel.rate == 0.0 || channel.times.empty()) return {};
  return bad_data(fmt::format("channel '{}' has both times and a rate", channel.name),
                  "keep one of them");
}

Result<void> check_shape(const Channel& channel) {
  std::size_t elements = 1;
  for (const std::size_t length : channel.shape) {
    if (length == 0 || elements > channel.frames.columns()) break;
    elements *= length;
  }
  if (elements == channel.frames.columns() || channel.shape.empty()) return {};
  return bad_data(
      fmt::format("channel '{}' has frames of {} elements, which do not fill its shape "
                  "{}",
                  channel.name, channel.frames.columns(), fmt::join(channel.shape, " x ")));
}

Result<void> check_mask(const Channel& channel) {
  const Matrix<std::uint8_t>& valid = channel.valid;
  if (valid.empty()) return {};
  if (valid.rows() != channel.frames.rows() || valid.columns() != channel.frames.columns()) {
    return bad_data(fmt::format("channel '{}' has {} x {} validity marks for {} x {} values",
                                channel.name, valid.rows(), valid.columns(), channel.frames.rows(),
                                channel.frames.columns()));
  }
  for (std::size_t i = 0; i < valid.values().size(); ++i) {
    if (valid.values()[i] <= 1 && (valid.values()[i] == 1 || channel.frames.values()[i] == 0.0F)) {
      continue;
    }
    return bad_data(
        fmt::format("channel '{}', frame {}, element {}: a validity mark must be 0 or 1, "
                    "and an invalid value must be 0",
                    channel.name, i / valid.columns() + 1, i % valid.columns() + 1));
  }
  return {};
}

Result<void> check_values(const Channel& channel) {
  for (std::size_t frame = 0; frame < channel.frames.rows(); ++frame) {
    for (std::size_t element = 0; element < channel.frames.columns(); ++element) {
      const float value = channel.frames(frame, element);
      if (std::isfinite(value)) continue;
      return bad_data(fmt::format("channel '{}', frame {}, element {}: {} is not a finite number",
                                  channel.name, frame + 1, element + 1, value),
                      "leave the exploration out, or repair it");
    }
  }
  return {};
}

Result<void> check_channel(const Channel& channel) {
  if (channel.frames.empty()) {
    return bad_data(fmt::format("channel '{}' has no frames", channel.name));
  }
  if (!channel.element_names.empty() && channel.element_names.size() != channel.frames.columns()) {
    return bad_data(fmt::format("channel '{}' has {} element names for {} elements", channel.name,
                                channel.element_names.size(), channel.frames.columns()),
                    "use one name per element, or none");
  }
  return check_times(channel)
      .and_then([&] { return check_rate(channel); })
      .and_then([&] { return check_shape(channel); })
      .and_then([&] { return check_mask(channel); })
      .and_then([&] { return check_values(channel); });
}

Result<void> check_separately(const Exploration& exploration) {
  if (exploration.channels.empty()) return bad_data("the exploration has no channels");
  Result<void> checked = check_names("label", names_of(exploration.labels)).and_then([&] {
    return check_names("channel", names_of(exploration.channels));
  });
  for (const Channel& channel : exploration.channels) {
    if (checked) checked = check_channel(channel);
  }
  return checked;
}

Result<void> check_same(std::string_view what, const std::vector<std::string>& names,
                        const std::vector<std::string>& first_names) {
  if (names == first_names) return {};
  return bad_data(fmt::format("its {} are '{}', but those of the first exploration are '{}'", what,
                              fmt::join(names, ", "), fmt::join(first_names, ", ")),
                  "record them separately, or leave the exploration out");
}

Result<void> check_like(const Channel& channel, const Channel& first) {
  if (channel.frames.columns() != first.frames.columns()) {
    return bad_data(fmt::format("channel '{}' has {} elements, but {} in the first exploration",
                                channel.name, channel.frames.columns(), first.frames.columns()));
  }
  if (channel.unit != first.unit) {
    return bad_data(fmt::format("channel '{}' is in '{}', but in '{}' in the first exploration",
                                channel.name, channel.unit, first.unit),
                    "convert one of them");
  }
  if (channel.frame_shape() != first.frame_shape()) {
    return bad_data(fmt::format("channel '{}' has the shape {}, but {} in the first exploration",
                                channel.name, fmt::join(channel.frame_shape(), " x "),
                                fmt::join(first.frame_shape(), " x ")));
  }
  return check_same(fmt::format("elements of channel '{}'", channel.name), channel.element_names,
                    first.element_names);
}

}  // namespace

std::vector<std::size_t> Channel::frame_shape() const {
  return shape.empty() ? std::vector<std::size_t>{frames.columns()} : shape;
}

double Channel::frame_rate() const {
  if (rate > 0.0 || times.size() < 2) return rate;
  std::vector<double> steps;
  steps.reserve(times.size() - 1);
  for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(times[i] - times[i - 1]);
  return detail::rate_of_steps(std::move(steps));
}

Result<const Channel*> find_channel(const Exploration& exploration, std::string_view name) {
  return find_named(exploration.channels, "channel", name, exploration.source);
}

Result<std::string> find_label(const Exploration& exploration, std::string_view name) {
  return find_named(exploration.labels, "label", name, exploration.source)
      .map([](const Label* label) { return label->value; });
}

Result<std::vector<std::string>> label_values(const Recording& recording, std::string_view name) {
  std::vector<std::string> values;
  for (const Exploration& exploration : recording.explorations) {
    SOMATO_TRY(const std::string value, find_label(exploration, name));
    if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
  }
  return values;
}

Result<void> check_alike(const Exploration& exploration, const Exploration& first) {
  Result<void> checked =
      check_same("labels", names_of(exploration.labels), names_of(first.labels)).and_then([&] {
        return check_same("channels", names_of(exploration.channels), names_of(first.channels));
      });
  for (std::size_t i = 0; checked && i < exploration.channels.size(); ++i) {
    checked = check_like(exploration.channels[i], first.channels[i]);
  }
  return checked;
}

Result<void> validate(const Recording& recording) {
  if (recording.explorations.empty()) return bad_data("the recording has no explorations");
  for (std::size_t i = 0; i < recording.explorations.size(); ++i) {
    const Exploration& exploration = recording.explorations[i];
    Result<void> checked = check_separately(exploration).and_then([&] {
      return check_alike(exploration, recording.explorations.front());
    });
    if (checked) continue;
    checked.error().where = place(recording, i);
    return checked;
  }
  return {};
}

}  // namespace somato
