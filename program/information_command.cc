#include <fmt/format.h>

#include <optional>
#include <utility>

#include "commands.h"
#include "data.h"
#include "result_output.h"
#include "somato/files/whole_file.h"
#include "somato/studies/information.h"
#include "somato/studies/own_systems.h"
#include "study_data.h"

namespace somato::program {
namespace {

std::string figure(const std::string& name, const std::optional<double>& value) {
  return value ? fmt::format("  {:<34}{:.3f}\n", name, *value) : std::string();
}

std::string text_of(const LabelInformation& about) {
  return fmt::format("\n{}: {} classes\n", about.label, about.classes) +
         figure("accuracy", about.accuracy) + figure("chance", about.chance) +
         figure("accuracy_new_individuals", about.accuracy_new_individuals) +
         figure("chance_new_individuals", about.chance_new_individuals) +
         figure("distance_ratio", about.distance_ratio);
}

std::string text_of(const OrderInformation& order, const InformationParameters& asked) {
  std::string text = fmt::format("\norder by {}{}\n", asked.order,
                                 asked.within.empty() ? "" : ", within each " + asked.within);
  text += figure("correlation", order.correlation) + figure("shuffled", order.shuffled) +
          figure("shuffled_share", order.shuffled_share);
  if (asked.within.empty()) return text;
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
  for (const LabelInformation& about : information.labels) text += text_of(about);
  return text + (information.order ? text_of(*information.order, information.asked) : "");
}

Result<StudyDescription> read_asked_study(const Arguments& arguments) {
  return read_file_or_own(arguments.text("STUDY")).and_then([](const Table& file) {
    return read_study(file);
  });
}

Result<Information> measure(const Arguments& arguments) {
  auto asked = read_flags<InformationParameters>(arguments);
  if (!asked) return fail(std::move(asked.error()));
  auto threads = read_threads(arguments);
  if (!threads) return fail(std::move(threads.error()));
  auto description = read_asked_study(arguments);
  if (!description) return fail(std::move(description.error()));
  auto recording = read_study_data(description->recording.format, arguments.text("data"));
  if (!recording) return fail(std::move(recording.error()));
  auto information = measure_information(*description, *recording, *asked, *threads);
  if (!information) return fail(with_place(std::move(information.error()), arguments.text("data")));
  return information;
}

Result<void> run_information(const Arguments& arguments) {
  auto information = measure(arguments);
  if (!information) return fail(std::move(information.error()));
  if (arguments.has("output")) {
    auto saved = save_whole(arguments.text("output"), to_json(*information));
    if (!saved) return saved;
  }
  print_result(arguments, text_of(*information), to_json(*information));
  return {};
}

}  // namespace

Command information_command() {
  return {
      "information",
      "Measure how much a recording's vectors tell, as they reach a study's map",
      {{"STUDY",
        "TOML file that describes the study and its system, or one that 'somato systems' lists",
        true, false, Role::kInput, own_file_names}},
      {input_flag("--data", "The recording: its file, or a folder of original files", true),
       threads_flag(), output_flag("-o,--output", "File for the figures, in JSON"), json_flag()},
      InformationParameters::declarations().infos(),
      run_information,
      "information"};
}

}  // namespace somato::program
