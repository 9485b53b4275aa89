#include "recordings/bags/bag_description.h"

#include <fmt/format.h>

#include <set>

#include "base/text/text.h"
#include "recordings/ros/path_elements.h"

namespace somato {
namespace {

template <typename T>
Result<void> read_tables(const Table::Entry& entry, std::vector<T>& items) {
  const auto* tables = std::get_if<std::vector<Table>>(&entry.content);
  if (!tables) {
    return fail(ErrorKind::kUsage, fmt::format("'{}' must be a list of tables", entry.name),
                entry.where,
                fmt::format("write [[{}]] on a separate line, followed by its keys", entry.name));
  }
  for (const Table& table : *tables) {
    SOMATO_TRY(T item, read_parameters<T>(table));
    items.push_back(std::move(item));
  }
  return {};
}

Result<void> read_trials(const Table::Entry& entry, BagTrials& trials) {
  const auto* table = std::get_if<Table>(&entry.content);
  if (!table) {
    return fail(ErrorKind::kUsage, "'import' must be a table", entry.where,
                "write [import] on a separate line, followed by its keys");
  }
  SOMATO_TRY(trials, read_parameters<BagTrials>(*table));
  return {};
}

tl::unexpected<Error> inconsistent(std::string what, std::string where) {
  return fail(ErrorKind::kUsage, std::move(what), std::move(where));
}

Result<void> check_channels_of_bag(const std::vector<BagChannel>& channels) {
  std::set<std::string> names;
  for (const BagChannel& channel : channels) {
    const std::string where = fmt::format("channel {}", shown(channel.name));
    if (channel.name.empty() || channel.topic.empty() || channel.fields.empty()) {
      return inconsistent("a channel needs a name, a topic and fields", where);
    }
    if (!names.insert(channel.name).second) return inconsistent("there are two of them", where);
  }
  return {};
}

Result<void> check_labels_of_bag(const std::vector<BagLabel>& labels) {
  std::set<std::string> names;
  for (const BagLabel& label : labels) {
    const std::string where = fmt::format("label {}", shown(label.name));
    if (label.name.empty()) return inconsistent("a label needs a name", where);
    if (label.value.empty() == label.topic.empty() || label.topic.empty() != label.field.empty()) {
      return inconsistent("a label needs either a value, or a topic and a field", where);
    }
    if (!names.insert(label.name).second) return inconsistent("there are two of them", where);
  }
  return {};
}

// The parts in front of and behind the first `separator`; nothing if one of them is empty.
std::optional<std::pair<std::string, std::string>> halves(const std::string& text, char separator) {
  const std::size_t place = text.find(separator);
  if (place == std::string::npos || place == 0 || place + 1 == text.size()) return std::nullopt;
  return std::pair(text.substr(0, place), text.substr(place + 1));
}

Result<BagChannel> parse_bag_channel(const std::string& text) {
  const auto sides = halves(text, '=');
  const auto source = sides ? halves(sides->second, ':') : std::nullopt;
  if (!source) {
    return fail(ErrorKind::kUsage, fmt::format("{} is not a channel", shown(text)), "--channels",
                "write for example touch:counts=/xServTopic:sensors[*].taxels[*].z");
  }
  BagChannel channel;
  const std::size_t colon = std::min(sides->first.find(':'), sides->first.size());
  channel.name = sides->first.substr(0, colon);
  channel.unit = sides->first.substr(std::min(colon + 1, sides->first.size()));
  if (sides->first.find_first_of("[]") != std::string::npos) {
    return fail(ErrorKind::kUsage, fmt::format("{} has brackets before its topic", shown(text)),
                "--channels", "write a shape in a description: shape = [4, 4]");
  }
  channel.topic = source->first;
  channel.fields = split_outside_brackets(source->second, '+');
  return channel;
}

}  // namespace

const std::vector<std::pair<BagClock, std::string>>& Choices<BagClock>::all() {
  static const std::vector<std::pair<BagClock, std::string>> choices{
      {BagClock::kReceiver, "receiver"}, {BagClock::kHeader, "header"}};
  return choices;
}

const std::vector<std::pair<ClockJumps, std::string>>& Choices<ClockJumps>::all() {
  static const std::vector<std::pair<ClockJumps, std::string>> choices{
      {ClockJumps::kRefuse, "refuse"}, {ClockJumps::kCut, "cut"}};
  return choices;
}

const Declarations<BagTrials>& BagTrials::declarations() {
  using P = BagTrials;
  static const auto declared =
      Declarations<P>()
          .add("files", &P::files, "", Range::any(),
               "Pattern of the names of the bags, with labels in braces: {object}_{trial:number}. "
               "Empty: no labels from names.")
          .add("other_files", &P::other_files, "", Range::any(),
               "Treatment of bags whose names do not match.")
          .add("events", &P::events, "", Range::any(),
               "Topic whose messages begin an exploration, or topic:field; an empty text, 0 or "
               "false in the field only ends one.")
          .add("spans", &P::spans, "", Range::any(),
               "CSV file with the columns begin and end of the explorations, in seconds since the "
               "first message of the bag, and columns with labels.")
          .add("gap", &P::gap, "s", Range::at_least(0),
               "Time without frames after which another exploration begins; 0: gaps do not matter.")
          .add("clock", &P::clock, "", Range::any(),
               "Time of a frame: when the message was received, or the stamp of its header.")
          .add("jumps", &P::jumps, "", Range::any(),
               "Treatment of a clock that is set back: an error, or the exploration is cut there.")
          .add("definitions", &P::definitions, "", Range::any(),
               "Folder with .msg files, for bags without definitions (before ROS 2 Iron).");
  return declared;
}

const Declarations<BagChannel>& BagChannel::declarations() {
  using P = BagChannel;
  static const auto declared =
      Declarations<P>()
          .add("name", &P::name, "", Range::any(), "Name of the channel, such as touch. Required.")
          .add("unit", &P::unit, "", Range::any(),
               "Unit of its values after multiplication by the factor; empty for none.")
          .add("topic", &P::topic, "", Range::any(), "Its topic. Required.")
          .add("fields", &P::fields, "", Range::any(),
               "Its fields, such as sensors[*].taxels[*].z, position[elbow,wrist], sensors[*:32].z "
               "or wrench.force. Required.")
          .add("names", &P::names, "", Range::any(),
               "Fields of texts with the names of its elements, with + between; empty: those of a "
               "known type, or a field name, names or joint_names; without any, the elements have "
               "the names of their places.")
          .add("shape", &P::shape, "", Range::between(1, 1e9),
               "Arrangement of the values, row by row, such as [4, 4]; empty: a flat list.")
          .add("factor", &P::factor, "", Range::any(),
               "Factor by which every value is multiplied.");
  return declared;
}

const Declarations<BagLabel>& BagLabel::declarations() {
  using P = BagLabel;
  static const auto declared =
      Declarations<P>()
          .add("name", &P::name, "", Range::any(), "Name of the label, such as object. Required.")
          .add("value", &P::value, "", Range::any(), "Its value in all explorations.")
          .add("topic", &P::topic, "", Range::any(),
               "Instead of a value: the topic whose last message before the end of the exploration "
               "contains it.")
          .add("field", &P::field, "", Range::any(),
               "The field of that message, a text or a number.");
  return declared;
}

Result<void> check_bag_import(const BagImport& description) {
  const BagTrials& trials = description.trials;
  const int ways = static_cast<int>(!trials.events.empty()) +
                   static_cast<int>(!trials.spans.empty()) + static_cast<int>(trials.gap > 0.0);
  if (ways > 1) {
    return inconsistent("explorations are cut by two of events, spans and gap", "[import]");
  }
  SOMATO_TRY_VOID(check_channels_of_bag(description.channels));
  return check_labels_of_bag(description.labels);
}

Result<BagImport> read_bag_import(const Table& file) {
  BagImport description;
  for (const Table::Entry& entry : file.entries) {
    if (entry.name == "import") {
      SOMATO_TRY_VOID(read_trials(entry, description.trials));
    } else if (entry.name == "channel") {
      SOMATO_TRY_VOID(read_tables(entry, description.channels));
    } else if (entry.name == "label") {
      SOMATO_TRY_VOID(read_tables(entry, description.labels));
    } else {
      return fail(unknown_name("table", entry.name, entry.where, {"import", "channel", "label"}));
    }
  }
  auto checked = check_bag_import(description);
  if (!checked) {
    checked.error().where = fmt::format("{}: {}", file.where, checked.error().where);
    return fail(std::move(checked.error()));
  }
  return description;
}

Result<std::vector<BagChannel>> parse_bag_channels(const std::string& text) {
  std::vector<BagChannel> channels;
  for (const std::string& part : split_outside_brackets(text, ',')) {
    SOMATO_TRY(BagChannel channel, parse_bag_channel(part));
    channels.push_back(std::move(channel));
  }
  return channels;
}

Result<BagLabel> parse_bag_label(const std::string& text) {
  const auto sides = halves(text, '=');
  if (!sides) {
    return fail(ErrorKind::kUsage, fmt::format("{} is not a label", shown(text)), "--labels",
                "write for example object=cup or object=/events:data");
  }
  BagLabel label;
  label.name = sides->first;
  const auto source = sides->second.starts_with('/') ? halves(sides->second, ':') : std::nullopt;
  if (!source) {
    label.value = sides->second;
  } else {
    label.topic = source->first;
    label.field = source->second;
  }
  return label;
}

}  // namespace somato
