#include "studies/suggestion/suggestion.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "base/files/toml_file.h"
#include "somato/core/value.h"
#include "studies/description/changed_keys.h"
#include "studies/suggestion/suggested_system.h"

namespace somato {
namespace {

using Json = nlohmann::ordered_json;

// A name from a recording, in quotes and without line ends.
std::string quoted(const std::string& name) {
  return to_toml(Value{name});
}

std::string names_of(const SuggestedGroup& group) {
  std::string text = quoted(group.channels.front());
  for (std::size_t i = 1; i < group.channels.size(); ++i) text += " x " + quoted(group.channels[i]);
  return text;
}

std::string plural(std::size_t count, const std::string& thing) {
  return fmt::format("{} {}{}", count, thing, count == 1 ? "" : "s");
}

const SuggestedPart* part_of(const Suggestion& suggestion, std::size_t group) {
  const auto found = std::ranges::find(suggestion.parts, group, &SuggestedPart::group);
  return found == suggestion.parts.end() ? nullptr : &*found;
}

const SuggestedCode& code_of(const Suggestion& suggestion, const SuggestedPart& part) {
  return suggestion.groups[part.group].codes[part.code];
}

std::string verdict_of(const Suggestion& suggestion, std::size_t group) {
  const SuggestedGroup& about = suggestion.groups[group];
  switch (about.role) {
    case ChannelRole::kConstant:
      return "not used: it has the same value in all frames";
    case ChannelRole::kSetting:
      return "not used as a sense: it does not change during any exploration";
    case ChannelRole::kUnrelated:
      return "not used: it is not predicted better than by chance, and predicts nothing";
    case ChannelRole::kSense:
      break;
  }
  if (const SuggestedPart* part = part_of(suggestion, group)) {
    return fmt::format("used: {}, weight {}", code_of(suggestion, *part).module, part->weight);
  }
  return "not used: it does not lower the score of the other parts";
}

// The module of a code without that of its scaling.
std::string base_of(const SuggestedCode& code) {
  return code.scaling == "none" || code.code == "product"
             ? code.module
             : code.module.substr(code.scaling.size() + 1);
}

// "unit 0.120", or the score of an unscaled code.
std::string score_text(const SuggestedCode& code) {
  const std::string scaling = code.scaling == "none" ? "" : code.scaling + " ";
  return scaling + fmt::format("{:.3f}", code.score);
}

// The scores of a code in all its scalings, or the reason if it was compared in none.
std::string line_of(std::span<const SuggestedCode> scalings) {
  std::string text;
  for (const SuggestedCode& code : scalings) {
    if (!code.failure.empty()) continue;
    text += (text.empty() ? "" : ", ") + score_text(code);
  }
  const SuggestedCode& first = scalings.front();
  return fmt::format("#     {}: {}\n", base_of(first),
                     text.empty() ? "not compared: " + first.failure : text);
}

// A line for each code.
std::string lines_of(const SuggestedGroup& group) {
  std::string text;
  const std::span<const SuggestedCode> codes = group.codes;
  for (std::size_t first = 0, next = 0; first < codes.size(); first = next) {
    while (next < codes.size() && base_of(codes[next]) == base_of(codes[first])) ++next;
    text += line_of(codes.subspan(first, next - first));
  }
  return text;
}

// Scores are those of predicting the senses, which an unrelated channel is not.
std::string about_group(const Suggestion& suggestion, std::size_t group) {
  const SuggestedGroup& about = suggestion.groups[group];
  const std::string heading =
      fmt::format("#   {}: {}\n", names_of(about), verdict_of(suggestion, group));
  return heading + (about.role == ChannelRole::kSense ? lines_of(about) : "");
}

std::string about_parts(const Suggestion& suggestion) {
  std::string text;
  for (const SuggestedPart& part : suggestion.parts) {
    text += fmt::format("#   {} {} with weight {}: score {:.3f}\n", text.empty() ? " " : "+",
                        code_of(suggestion, part).module, part.weight, part.score);
  }
  return text;
}

std::string about_comparisons(const Suggestion& suggestion) {
  if (suggestion.comparisons.empty()) return {};
  std::string text =
      "# The plain vector is replaced only by a combination that is better by more than one\n"
      "# standard error, and Euclidean by Manhattan distance likewise:\n";
  for (const SuggestedComparison& each : suggestion.comparisons) {
    text += fmt::format("#   {}: score {:.3f}{}\n", each.name, each.score,
                        each.is_chosen ? ", chosen" : "");
  }
  return text + "#\n";
}

std::string about_size(const Suggestion& suggestion) {
  if (suggestion.size.checks.empty()) return {};
  std::string text =
      "# Neurons, and the mean distance of each fifth exploration from a map of the others; the "
      "map "
      "has\n"
      "# the least number than which the best one is not better by more than one standard error:\n";
  for (const SizeCheck& check : suggestion.size.checks) {
    text += fmt::format("#   {}: {:.4g}\n", plural(check.neurons, "neuron"), check.error);
  }
  return text + "#\n";
}

std::string names_of_senses(const Suggestion& suggestion) {
  std::string names;
  for (const std::string& sense : suggestion.senses) {
    names += (names.empty() ? "" : ", ") + quoted(sense);
  }
  return names;
}

std::string heading_of(const Suggestion& suggestion) {
  const std::string compared =
      suggestion.compared == suggestion.explorations
          ? ""
          : fmt::format(" ({} of them, drawn at random, were compared)", suggestion.compared);
  std::string text = fmt::format(
      "# Suggested by 'somato suggest' from {}{}, without labels.\n"
      "#\n"
      "# The score of a vector measures whether explorations that are similar in it are similar "
      "for\n"
      "# every sense: the mean information imbalance, near 0 if nearest neighbours agree, about 1 "
      "by\n"
      "# chance. A sense is predicted from whole explorations of other senses, and from the other\n"
      "# half of its own frames. The senses are {}.\n#\n",
      plural(suggestion.explorations, "exploration"), compared, names_of_senses(suggestion));
  if (suggestion.nothing_related) {
    text +=
        "# No sense is predicted better than by chance, so that nothing could be selected: the\n"
        "# senses that differ between explorations are combined with equal weights. More\n"
        "# explorations are required.\n#\n";
  }
  text += fmt::format("# Parts, after {}:\n", plural(suggestion.combinations, "combination")) +
          about_parts(suggestion) + "#\n" + about_comparisons(suggestion) + about_size(suggestion) +
          "# Channels and the scores of their codes:\n";
  for (std::size_t group = 0; group < suggestion.groups.size(); ++group) {
    text += about_group(suggestion, group);
  }
  return text;
}

// The values of a table, without the tables in it.
std::string values_of(const Table& table, const std::vector<std::string>& except) {
  std::string text;
  for (const Table::Entry& entry : table.entries) {
    const auto* value = std::get_if<Value>(&entry.content);
    if (!value || std::ranges::find(except, entry.name) != except.end()) continue;
    text += entry.name + " = " + to_toml(*value) + "\n";
  }
  return text;
}

std::string own_settings(const Suggestion& suggestion) {
  const bool leave_out = suggestion.explorations <= kMostLeftOut;
  return fmt::format(
      "label = {}  # measures accuracy; it did not affect the suggestion\nprotocols = [\"{}\"]\n{}",
      quoted(suggestion.parameters.label), leave_out ? "leave_one_out" : "k_folds",
      leave_out ? ""
                : fmt::format(
                      "folds = {}\nfold_choice = \"blocks\"  # consecutive explorations together\n",
                      kFolds));
}

std::string study_of(const Suggestion& suggestion, const Table& like) {
  const Table* study = table_in(like, "study");
  return "\n[study]\nname = " + quoted(suggestion.parameters.name) + "\n" +
         (study ? values_of(*study, {"name", "map"}) : own_settings(suggestion));
}

std::string recording_of(const RecordingParameters& recording) {
  if (recording == RecordingParameters{}) return {};
  std::string text = "\n" + changed_keys_to_toml("recording", recording);
  text.pop_back();
  return text;
}

std::string explore_of(const Table& like) {
  const Table* explore = table_in(like, "explore");
  if (!explore) return {};
  std::string text = "\n[explore]\n" + values_of(*explore, {});
  for (const Table::Entry& entry : explore->entries) {
    const auto* table = std::get_if<Table>(&entry.content);
    if (table) text += "\n[explore." + entry.name + "]\n" + values_of(*table, {});
  }
  return text;
}

// Tables of modules, without the table of the system's name.
std::string modules_of(const Suggestion& suggestion) {
  const std::string text = to_toml(suggestion.system);
  return text.substr(text.find("\n[module."));
}

Json json_of(const SuggestedCode& code, const std::vector<std::string>& senses) {
  Json json = {{"code", code.code},
               {"scaling", code.scaling},
               {"module", code.module},
               {"elements", code.elements}};
  if (!code.failure.empty()) json["failure"] = code.failure;
  if (code.imbalances.empty()) return json;
  json["score"] = code.score;
  for (std::size_t i = 0; i < senses.size(); ++i) json["predicts"][senses[i]] = code.imbalances[i];
  return json;
}

Json json_of(const Suggestion& suggestion, const SuggestedGroup& group) {
  Json codes = Json::array();
  for (const SuggestedCode& code : group.codes) {
    codes.push_back(json_of(code, suggestion.senses));
  }
  return {{"channels", group.channels}, {"role", choice_name(group.role)}, {"codes", codes}};
}

Json json_of(const Suggestion& suggestion, const SuggestedPart& part) {
  return {{"channels", suggestion.groups[part.group].channels},
          {"module", code_of(suggestion, part).module},
          {"weight", part.weight},
          {"factor", part.factor},
          {"score", part.score}};
}

}  // namespace

std::string to_toml(const Suggestion& suggestion, const Table& like,
                    const RecordingParameters& recording) {
  return heading_of(suggestion) + study_of(suggestion, like) + recording_of(recording) +
         explore_of(like) + modules_of(suggestion);
}

std::string to_json(const Suggestion& suggestion) {
  Json json = {{"version", 1},
               {"explorations", suggestion.explorations},
               {"compared", suggestion.compared},
               {"combinations", suggestion.combinations},
               {"nothing_related", suggestion.nothing_related},
               {"senses", suggestion.senses}};
  for (const SuggestedPart& part : suggestion.parts) {
    json["parts"].push_back(json_of(suggestion, part));
  }
  for (const SuggestedComparison& each : suggestion.comparisons) {
    json["comparisons"].push_back(
        {{"name", each.name}, {"score", each.score}, {"chosen", each.is_chosen}});
  }
  for (const SizeCheck& check : suggestion.size.checks) {
    json["sizes"].push_back({{"neurons", check.neurons}, {"error", check.error}});
  }
  json["similarity"] = choice_name(suggestion.similarity);
  for (const SuggestedGroup& group : suggestion.groups) {
    json["groups"].push_back(json_of(suggestion, group));
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace somato
