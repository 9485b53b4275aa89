#include <fmt/format.h>

#include <optional>
#include <utility>

#include "commands.h"
#include "data.h"
#include "somato/files/toml_file.h"
#include "somato/files/whole_file.h"
#include "somato/studies/information.h"
#include "study_data.h"

namespace somato::program {
namespace {

void print_figure(const std::string& name, const std::optional<double>& value) {
  if (value) fmt::print("  {:<34}{:.3f}\n", name, *value);
}

void print_label(const LabelInformation& about) {
  fmt::print("\n{}: {} classes\n", about.label, about.classes);
  print_figure("accuracy", about.accuracy);
  print_figure("chance", about.chance);
  print_figure("accuracy_new_individuals", about.accuracy_new_individuals);
  print_figure("chance_new_individuals", about.chance_new_individuals);
  print_figure("distance_ratio", about.distance_ratio);
}

void print_order(const OrderInformation& order, const InformationParameters& asked) {
  fmt::print("\norder by {}{}\n", asked.order,
             asked.within.empty() ? "" : ", within each " + asked.within);
  print_figure("correlation", order.correlation);
  print_figure("shuffled", order.shuffled);
  print_figure("shuffled_share", order.shuffled_share);
  if (asked.within.empty()) return;
  for (const OrderInformation::Group& group : order.groups) {
    print_figure(fmt::format("correlation of {} in {}", group.individuals, group.name),
                 group.correlation);
  }
}

void print(const Information& information) {
  fmt::print("{}: {} explorations, vectors of {} elements from '{}'\n", information.study,
             information.explorations, information.elements, information.module);
  for (const LabelInformation& about : information.labels) print_label(about);
  if (information.order) print_order(*information.order, information.asked);
}

Result<StudyDescription> read_asked_study(const Arguments& arguments) {
  return read_toml(arguments.text("STUDY")).and_then([](const Table& file) {
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
  print(*information);
  return {};
}

}  // namespace

Command information_command() {
  return {"information",
          "Measure how much a recording's vectors tell, as they reach a study's map",
          {{"STUDY", "TOML file that describes the study and its system", true}},
          {input_flag("--data", "The recording: its file, or a folder of original files", true),
           threads_flag(), output_flag("-o,--output", "File for the figures, in JSON")},
          InformationParameters::declarations().infos(),
          run_information,
          "information"};
}

}  // namespace somato::program
