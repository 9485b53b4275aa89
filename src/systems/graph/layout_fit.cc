#include "systems/graph/layout_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/text/text.h"

namespace somato {
namespace {

Result<void> check_channel(const ChannelLayout& channel, const ChannelLayout& then) {
  if (!channel.unit.empty() && !then.unit.empty() && channel.unit != then.unit) {
    return fail(ErrorKind::kData,
                fmt::format("channel '{}' is in '{}', but was in '{}' in training", channel.name,
                            channel.unit, then.unit),
                {}, "convert the recording, or train on one with this unit");
  }
  const std::vector<std::string>& names = channel.element_names;
  if (names.empty() || then.element_names.empty() || names == then.element_names) return {};
  return fail(ErrorKind::kData,
              fmt::format("channel '{}' has the elements {}, but had {} in training", channel.name,
                          shown_list(names), shown_list(then.element_names)),
              {}, "record or import its elements in the order of the training");
}

bool reads(const System& system, const std::string& channel) {
  const auto is_read = [&](const SystemModule& module) {
    const auto* source = dynamic_cast<const Source*>(module.module.get());
    return source != nullptr && source->channel() == channel;
  };
  return std::any_of(system.modules().begin(), system.modules().end(), is_read);
}

// The channels that the system reads: values of another element or unit are no input for it.
Result<void> check_channels(const System& trained, const RecordingLayout& layout) {
  for (const ChannelLayout& then : trained.layout().channels) {
    for (const ChannelLayout& channel : layout.channels) {
      if (channel.name != then.name || !reads(trained, then.name)) continue;
      SOMATO_TRY_VOID(check_channel(channel, then));
    }
  }
  return {};
}

}  // namespace

Result<void> check_layout(const System& trained, const RecordingLayout& layout) {
  SOMATO_TRY_VOID(check_channels(trained, layout));
  SOMATO_TRY(const auto other, System::build(trained.description(), layout));
  for (std::size_t i = 0; i < other.modules().size(); ++i) {
    const SystemModule& module = other.modules()[i];
    const PortType& then = trained.modules()[i].output;
    if (module.output.shape == then.shape) continue;
    return fail(ErrorKind::kData,
                fmt::format("module '{}' gives {}, but gave {} in training", module.name,
                            to_string(module.output), to_string(then)));
  }
  return {};
}

}  // namespace somato
