#include "studies/results/next_steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

#include "base/files/toml_file.h"
#include "somato/core/value.h"
#include "somato/recording/format.h"
#include "studies/results/main_result.h"

namespace somato {
namespace {

constexpr const char* kOfBaseline = "docs/below-the-baseline.md";
constexpr const char* kOfContinual = "docs/continual.md";
constexpr const char* kOfSuggestions = "docs/suggest.md";
constexpr const char* kOfLive = "docs/live.md";
constexpr const char* kOfData = "docs/your-data.md";

// As a word of a shell's command.
std::string word(const std::string& text) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./-+=:,@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string listed(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value.content)) return *text;
  const auto* list = std::get_if<Value::List>(&value.content);
  if (!list) return to_toml(value);
  std::string items;
  for (const Value& item : *list) items += (items.empty() ? "" : ",") + listed(item);
  return items;
}

// The flags that select the rows and columns of a table as the study did; empty for a recording.
std::string table_flags(const PartResults& part) {
  const auto file = parse_toml(part.study, "study");
  const Table* table = file ? table_in(*file, "recording") : nullptr;
  const auto recording = table ? read_parameters<RecordingParameters>(*table)
                               : Result<RecordingParameters>(RecordingParameters());
  if (!recording) return {};
  std::string flags;
  for (const auto& parameter : RecordingParameters::declarations().all()) {
    const Value value = parameter.read(*recording);
    const std::string& name = parameter.info.name;
    if (name == "format" || value == parameter.read(RecordingParameters{})) continue;
    std::string flag = name;
    std::ranges::replace(flag, '_', '-');
    flags += " --" + flag + " ";
    if (name == "missing") {
      flags += "mean";
    } else if (name == "header") {
      flags += *recording->header ? "yes" : "no";
    } else {
      flags += word(listed(value));
    }
  }
  return flags;
}

std::vector<std::string> commands_of_suggestion(const std::string& data, const std::string& label,
                                                const std::string& of_table) {
  const bool is_default = label == "object" || !of_table.empty();
  const std::string of_label = is_default ? of_table : " --label " + word(label);
  return {fmt::format("somato suggest {}{} -o suggested.toml", word(data), of_label),
          fmt::format("somato run suggested.toml --data {} --out out/suggested", word(data))};
}

// Makes the proposals for one result.
class Proposals {
 public:
  Proposals(const PartResults& part, const MainResult& result, ResultFiles files)
      : part_(part),
        protocol_(part.protocols[result.protocol]),
        result_(result),
        files_(std::move(files)) {
    if (files_.data.empty() && !part.recordings.empty()) files_.data = part.recordings[0].name;
  }

  std::vector<NextStep> make() {
    add_neurons();
    const double below = far_below_baseline(protocol_).value_or(0.0);
    const double missed_by_neighbour = 1.0 - result_.baseline.value_or(1.0);
    if (missed_by_neighbour > std::max(1.0 - kPoor, below)) add_other_code(is_near_chance());
    if (below > 0.0) add_settings(below);
    add_repetitions();
    add_view();
    add_application();
    return std::move(steps_);
  }

 private:
  static constexpr double kLittle = 0.1;  // of what is above chance
  static constexpr double kPoor = 0.9;
  static constexpr std::size_t kFew = 10;

  bool is_near_chance() const {
    return result_.accuracy - result_.chance < kLittle * (1.0 - result_.chance);
  }

  void add_other_code(bool is_near_chance) {
    const std::string reason = is_near_chance
                                   ? "The accuracy is hardly above chance"
                                   : "The nearest neighbour does not classify all samples either";
    const bool is_suggested = part_.system == "suggested";
    steps_.push_back(
        {reason + ": the vectors are the reason, more than the map. " +
             (is_suggested ? "Codes of these channels were compared already; add another sensor, "
                             "or explore longer."
                           : "Compare codes and combinations of the channels."),
         is_suggested ? std::vector<std::string>()
                      : commands_of_suggestion(files_.data, protocol_.label, table_flags(part_)),
         is_suggested ? kOfData : kOfSuggestions});
  }

  void add_neurons() {
    const auto collapsed = collapsed_map(protocol_);
    if (!collapsed) return;
    steps_.push_back(
        {fmt::format("The map has fewer winners ({}) than there are classes ({}), which it cannot "
                     "separate. A map that grows needs a higher activity_threshold or by_names = "
                     "true, another map more neurons.",
                     collapsed->winners, collapsed->classes),
         {},
         kOfBaseline});
  }

  void add_settings(double below) {
    if (protocol_.protocol == "object_after_object") return add_replay();
    steps_.push_back(
        {fmt::format("The map is {:.0f} points below the nearest neighbour. In [module.map] of the "
                     "study, set more iterations, a smaller radius_end or more neurons.",
                     100.0 * below),
         {},
         kOfBaseline});
  }

  void add_replay() {
    steps_.push_back(
        {"What is learned later replaces what was learned before. Set replay_per_object of the "
         "study, so that explorations of earlier objects are learned again.",
         {},
         kOfContinual});
  }

  void add_repetitions() {
    std::map<std::string, std::size_t> counts;
    for (const std::string& label : protocol_.runs.front().labels) ++counts[label];
    const auto fewest = std::min_element(
        counts.begin(), counts.end(),
        [](const auto& one, const auto& other) { return one.second < other.second; });
    if (fewest == counts.end() || fewest->second >= kFew) return;
    steps_.push_back(
        {fmt::format("There are only {} samples of '{}'; one of all {} is {:.1f} points of the "
                     "accuracy. Record more explorations.",
                     fewest->second, fewest->first, protocol_.samples,
                     100.0 / static_cast<double>(protocol_.samples)),
         {},
         kOfData});
  }

  void add_view() {
    const auto most = confusions(protocol_, 1);
    const std::string model = files_.model.empty() ? "" : " --model " + word(files_.model);
    const std::string reason =
        most.empty()
            ? std::string("Play the recording with the readings of the map.")
            : fmt::format("Play explorations of '{}' and '{}', and compare their readings.",
                          most[0].label, most[0].predicted);
    steps_.push_back(
        {reason, {fmt::format("somato view {}{}", word(files_.data), model)}, kOfLive});
  }

  void add_application() {
    if (files_.model.empty()) return;
    steps_.push_back(
        {"Classify new explorations by the saved system, in a file of your own "
         "instead of this recording.",
         {fmt::format("somato apply {} {}", word(files_.model), word(files_.data))},
         ""});
  }

  const PartResults& part_;
  const ProtocolResults& protocol_;
  const MainResult& result_;
  ResultFiles files_;
  std::vector<NextStep> steps_;
};

}  // namespace

std::vector<NextStep> next_steps(const PartResults& part, const ResultFiles& files) {
  const bool is_given = !part.recordings.empty() && part.recordings.front().source == "given";
  const auto result = main_result(part);
  if (!is_given || !result) return {};
  return Proposals(part, *result, files).make();
}

}  // namespace somato
