#include "views/session/view_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "base/text/text.h"

namespace somato::live {
namespace {

using SortedJson = nlohmann::json;

constexpr double kMostFrames = 1e9;

// The fields of a command, taken one after the other; the first that is wrong is kept.
class CommandFields {
 public:
  explicit CommandFields(const SortedJson& json) : json_(json) {}

  double number(const std::string& name, double least, double most) {
    const SortedJson* field = take(name);
    if (!field) return least;
    const double value = field->is_number() ? field->get<double>() : least - 1.0;
    if (value >= least && value <= most) return value;
    keep(fmt::format("'{}' must be a number from {:g} to {:g}", name, least, most));
    return least;
  }

  double whole(const std::string& name, double least, double most) {
    const double value = number(name, least, most);
    if (value != std::floor(value)) keep(fmt::format("'{}' must be a whole number", name));
    return value;
  }

  std::size_t index(const std::string& name) {
    return static_cast<std::size_t>(whole(name, 0, kMostFrames));
  }
  std::optional<std::size_t> index_if_given(const std::string& name) {
    return json_.contains(name) ? std::optional(index(name)) : std::nullopt;
  }

  std::string text(const std::string& name) {
    const SortedJson* field = take(name);
    if (!field) return {};
    if (field->is_string() && field->get_ref<const std::string&>().size() <= kLongestName) {
      return field->get<std::string>();
    }
    keep(fmt::format("'{}' must be a text of at most {} bytes", name, kLongestName));
    return {};
  }

  // The name or value of a label.
  std::string word(const std::string& name) {
    std::string value = text(name);
    if (!is_name(value)) {
      keep(fmt::format("'{}' must be a text without line breaks and not empty", name));
    }
    return value;
  }

  // After all known fields.
  Result<void> finish() {
    for (const auto& [name, field] : json_.items()) {
      if (std::find(taken_.begin(), taken_.end(), name) == taken_.end()) {
        keep("the command has an unknown field");
      }
    }
    if (problem_.empty()) return {};
    return fail(ErrorKind::kUsage, problem_);
  }

 private:
  const SortedJson* take(const std::string& name) {
    taken_.push_back(name);
    const auto found = json_.find(name);
    if (found != json_.end()) return &*found;
    keep(fmt::format("'{}' is missing", name));
    return nullptr;
  }

  void keep(std::string problem) {
    if (problem_.empty()) problem_ = std::move(problem);
  }

  const SortedJson& json_;
  std::vector<std::string> taken_;
  std::string problem_;
};

ViewCommand step_of(CommandFields& fields) {
  return StepCommand{static_cast<std::int64_t>(fields.whole("frames", -kMostFrames, kMostFrames))};
}

ViewCommand seek_of(CommandFields& fields) {
  SeekCommand seek;
  seek.exploration = fields.index("exploration");
  seek.frame = fields.index("frame");
  return seek;
}

ViewCommand placement_of(CommandFields& fields) {
  PlacementCommand command;
  command.placement.x = fields.number("x", -Placement::kFarthest, Placement::kFarthest);
  command.placement.y = fields.number("y", -Placement::kFarthest, Placement::kFarthest);
  command.placement.turn = fields.number("turn", -360, 360);
  return command;
}

Label label_of(CommandFields& fields) {
  Label label;
  label.name = fields.word("label");
  label.value = fields.word("value");
  return label;
}

ViewCommand name_of(CommandFields& fields) {
  NameCommand command;
  command.label = label_of(fields);
  command.id = fields.index_if_given("id");
  return command;
}

ViewCommand undo_name_of(CommandFields& fields) {
  UndoNameCommand command;
  command.id = fields.index("id");
  command.label = label_of(fields);
  return command;
}

ViewCommand plan_of(CommandFields& fields) {
  return PlanCommand{static_cast<std::size_t>(fields.whole("each", 0, kMostPlanned))};
}

using Reader = ViewCommand (*)(CommandFields&);

const std::vector<std::pair<std::string, Reader>>& readers() {
  static const std::vector<std::pair<std::string, Reader>> all = {
      {"play", [](CommandFields&) -> ViewCommand { return PlayCommand{}; }},
      {"pause", [](CommandFields&) -> ViewCommand { return PauseCommand{}; }},
      {"step", step_of},
      {"seek", seek_of},
      {"speed",
       [](CommandFields& fields) -> ViewCommand {
         return SpeedCommand{fields.number("speed", 0.05, 100)};
       }},
      {"thing",
       [](CommandFields& fields) -> ViewCommand { return ThingCommand{fields.text("name")}; }},
      {"placement", placement_of},
      {"explore", [](CommandFields&) -> ViewCommand { return ExploreCommand{}; }},
      {"name", name_of},
      {"undo_name", undo_name_of},
      {"plan", plan_of},
      {"system",
       [](CommandFields& fields) -> ViewCommand { return SystemCommand{fields.text("name")}; }},
      {"train", [](CommandFields&) -> ViewCommand { return TrainCommand{}; }},
      {"stop_training", [](CommandFields&) -> ViewCommand { return StopTrainingCommand{}; }},
      {"dismiss", [](CommandFields&) -> ViewCommand { return DismissCommand{}; }}};
  return all;
}

// A command is flat; what is nested deeply only keeps a parser busy.
bool is_flat(std::string_view text) {
  return std::count_if(text.begin(), text.end(), [](char c) { return c == '{' || c == '['; }) <= 2;
}

}  // namespace

Result<ViewCommand> parse_view_command(std::string_view text) {
  const SortedJson json = is_flat(text) ? SortedJson::parse(text, nullptr, false) : SortedJson();
  if (!json.is_object()) return fail(ErrorKind::kUsage, "a command must be a JSON object");
  CommandFields fields(json);
  const std::string name = fields.text("command");
  for (const auto& [known, read] : readers()) {
    if (known != name) continue;
    ViewCommand command = read(fields);
    SOMATO_TRY_VOID(fields.finish());
    return command;
  }
  return fail(ErrorKind::kUsage, "unknown command");
}

}  // namespace somato::live
