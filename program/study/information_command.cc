#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "base/files/whole_file.h"
#include "flags/commands.h"
#include "flags/result_output.h"
#include "recordings/study_data.h"
#include "som/data.h"
#include "somato/studies/information.h"
#include "somato/studies/own_systems.h"

namespace somato::program {
namespace {

std::string figure(const std::string& name, const std::optional<double>& value) {
  return value ? fmt::format("  {:<34}{:.3f}\n", name, *value) : std::string();
}

// The elements that differ most between the classes, in the order of their shares.
std::string ranking_of(const LabelInformation& about, const std::vector<std::string>& names) {
  constexpr std::size_t kMostShown = 12;
  std::vector<std::size_t> order(names.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t element) {
    return std::pair(-about.explained[element], element);
  });
  std::string text = "  share of the variance of an element between the classes\n";
  for (std::size_t i = 0; i < std::min(order.size(), kMostShown); ++i) {
    text += "  " + figure(names[order[i]], about.explained[order[i]]);
  }
  if (order.size() > kMostShown) {
    text += fmt::format("    and {} other elements\n", order.size() - kMostShown);
  }
  return text;
}

std::string text_of(const LabelInformation& about) {
  return fmt::format("\n{}: {} classes\n", about.label, about.classes) +
         figure("accuracy", about.accuracy) + figure("chance", about.chance) +
         figure("accuracy_new_individuals", about.accuracy_new_individuals) +
         figure("chance_new_individuals", about.chance_new_individuals) +
         figure("distance_ratio", about.distance_ratio);
}

std::string text_of(const OrderInformation& order, const InformationParameters& parameters) {
  std::string text =
      fmt::format("\norder by {}{}\n", parameters.order,
                  parameters.within.empty() ? "" : ", within each " + parameters.within);
  text += figure("correlation", order.correlation) + figure("shuffled", order.shuffled) +
          figure("shuffled_share", order.shuffled_share);
  if (parameters.within.empty()) return text;
  for (const OrderInformation::Group& group : order.groups) {
    text += figure(fmt::format("correlation of {} in {}", group.individuals, group.name),
                   group.correlation);
  }
  return text;
}

std::string text_of(const Information& information) {
  std::string text =
      fmt::format("{}: {} explorations, vectors of {} elements from '{}'\n", information.study,
                  information.explorations, information.elements, information.module);
  for (const LabelInformation& about : information.labels) {
    text += text_of(about) + ranking_of(about, information.element_names);
  }
  return text + (information.order ? text_of(*information.order, information.parameters) : "");
}

Result<StudyDescription> read_requested_study(const Arguments& arguments) {
  return read_file_or_own(arguments.text("STUDY")).and_then([](const NamedFile& file) {
    return read_study(file.content);
  });
}

Result<Information> measure(const Arguments& arguments) {
  SOMATO_TRY(auto parameters, read_flags<InformationParameters>(arguments));
  SOMATO_TRY(auto threads, read_threads(arguments));
  SOMATO_TRY(auto description, read_requested_study(arguments));
  if (!arguments.has("labels")) parameters.labels = {description.study.label};
  SOMATO_TRY(auto recording, read_study_data(description.recording, arguments.text("data")));
  auto information = measure_information(description, recording, parameters, threads);
  if (!information) return fail(with_place(std::move(information.error()), arguments.text("data")));
  return information;
}

Result<void> run_information(const Arguments& arguments) {
  SOMATO_TRY(auto information, measure(arguments));
  if (arguments.has("output")) {
    auto saved = save_whole(arguments.text("output"), to_json(information));
    if (!saved) return saved;
  }
  print_result(arguments, text_of(information), to_json(information));
  return {};
}

std::vector<KeySection> key_sections_of_information() {
  return {{"Information in the input vectors",
           "Flags of `somato information`; they are not keys of a file. "
           "[information.md](information.md) defines the measures.",
           {key_table<InformationParameters>("information")}}};
}

}  // namespace

Command information_command() {
  return {"information",
          "Measure the information in the input vectors of a study's map",
          {{"STUDY", "TOML file of the study, or a name listed by 'somato systems'", true, false,
            Role::kInput, own_file_names}},
          {input_flag("--data", "Recording: its file, or a folder of original files", true),
           threads_flag(), output_flag("-o,--output", "JSON file for the measures"), json_flag()},
          InformationParameters::declarations().infos(),
          run_information,
          {"information"},
          key_sections_of_information};
}

}  // namespace somato::program
