#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/files/whole_file.h"
#include "flags/commands.h"
#include "flags/result_output.h"
#include "recordings/study_data.h"
#include "som/data.h"
#include "studies/suggestion/suggestion.h"
#include "study/table_data.h"
#include "terminal/terminal.h"

namespace somato::program {
namespace {

std::string summary_of(const Suggestion& suggestion, const std::string& path) {
  std::string text = fmt::format(
      "{}: {} of {} channels are senses, {} combinations compared\n", path,
      suggestion.senses.size(),
      std::ranges::count_if(suggestion.groups,
                            [](const SuggestedGroup& group) { return group.channels.size() == 1; }),
      suggestion.combinations);
  for (const SuggestedPart& part : suggestion.parts) {
    text +=
        fmt::format("  {:<48}weight {:<6}score {:.3f}\n",
                    suggestion.groups[part.group].codes[part.code].module, part.weight, part.score);
  }
  return text;
}

// The file does not depend on the recording's labels, so that a missing one is only mentioned.
std::string note_on_label(const Recording& recording, const std::string& label) {
  std::string known;
  for (const Label& each : recording.explorations.front().labels) {
    if (each.name == label) return {};
    known += (known.empty() ? "" : ", ") + each.name;
  }
  const std::string labels = known.empty() ? "has no labels" : "has only the labels " + known;
  return fmt::format(
      "The recording {}: before 'somato run', set 'label' in the file, or use --label.\n", labels);
}

// The file of the study whose tables are taken; empty without the flag.
Result<Table> read_like(const Arguments& arguments) {
  if (!arguments.has("study")) return Table{};
  return read_file_or_own(arguments.text("study")).map([](const NamedFile& file) {
    return file.content;
  });
}

// It replaces the label of the suggestion.
Result<void> check_label_given_once(const Arguments& arguments) {
  if (!arguments.has("study") || !arguments.has("label")) return {};
  return fail(ErrorKind::kUsage, "has no effect with --study", "--label", "omit it");
}

// The name is that of the column in other tables, too, where its number may be another.
void name_label_column(const Recording& table, RecordingParameters& how) {
  const Exploration& first = table.explorations.front();
  const bool has_names = !first.channels.front().element_names.empty();
  if (!how.label_column.empty() && has_names) how.label_column = first.labels.front().name;
}

Result<void> run_suggest(const Arguments& arguments) {
  SOMATO_TRY(auto parameters, read_flags<SuggestionParameters>(arguments));
  SOMATO_TRY_VOID(check_label_given_once(arguments));
  SOMATO_TRY(auto threads, read_threads(arguments));
  SOMATO_TRY(const auto like, read_like(arguments));
  const std::string path = arguments.text("RECORDING");
  RecordingParameters how;
  SOMATO_TRY_VOID(read_table_data(arguments, how));
  SOMATO_TRY(auto recording, read_study_data(how, path));
  if (!arguments.has("label")) {
    parameters.label = label_of_table(how, recording, parameters.label);
  }
  name_label_column(recording, how);
  auto found = suggest(recording, parameters, {threads, terminal_progress("comparing codes")});
  if (!found) return fail(with_place(std::move(found.error()), path));
  const std::string output = arguments.text("output");
  SOMATO_TRY_VOID(save_whole(output, to_toml(*found, like, how)));
  const std::string note = arguments.has("study") ? "" : note_on_label(recording, parameters.label);
  print_summary(arguments, summary_of(*found, output) + note, to_json(*found));
  return {};
}

std::vector<Flag> suggest_flags() {
  std::vector<Flag> flags = table_data_flags();
  flags.push_back(threads_flag());
  flags.push_back(
      input_flag("--study",
                 "Study whose tables [study] and [explore] the suggested one takes, so that "
                 "both are compared on the same recordings: its file, or a name"));
  flags.push_back(output_flag("-o,--output", "TOML file for the suggested study", true));
  flags.push_back(json_flag());
  return flags;
}

std::vector<KeySection> key_sections_of_suggestions() {
  return {{"Suggestions",
           "Flags of `somato suggest`; they are not keys of a file. "
           "[suggest.md](../mathematics/suggest.md) describes the search; none of these numbers is "
           "in the papers.",
           {key_table<SuggestionParameters>("suggestion")}}};
}

}  // namespace

Command suggest_command() {
  return {
      "suggest",
      "Select codes, weights and a combination of a recording's channels without labels",
      {{"RECORDING",
        "Recording: its file, a folder of original files, or a table of numbers (CSV, NPY, NPZ, "
        "MAT), whose rows are explorations"}},
      suggest_flags(),
      SuggestionParameters::declarations().infos(),
      run_suggest,
      {"suggestion"},
      key_sections_of_suggestions};
}

}  // namespace somato::program
