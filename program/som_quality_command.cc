#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "commands.h"
#include "data.h"
#include "memory_flag.h"
#include "row_data.h"
#include "somato/maps/areas.h"

namespace somato::program {
namespace {

Result<double> accuracy(const MapAndRows& both) {
  const SomModel& model = both.model;
  const Classes& classes = both.rows.classes;
  PreparedRows prepared(model, both.rows);
  SomWorkspace workspace;
  std::size_t row = 0;
  double right = 0.0;
  return for_each_part(prepared.samples(),
                       [&](const Samples& part) -> Result<void> {
                         for (std::size_t i = 0; i < part.count(); ++i) {
                           const auto predicted =
                               model.labels.classify(model.som, part[i], workspace);
                           const std::string& name = classes.names[classes.of_sample[row++]];
                           right += model.classes[predicted] == name ? 1.0 : 0.0;
                         }
                         return {};
                       })
      .map([&] { return right / static_cast<double>(row); });
}

Result<std::string> label_measures(const MapAndRows& both, const SomQuality& quality) {
  const std::vector<std::size_t>& classes = both.rows.classes.of_sample;
  const WinnerAreas areas(both.model.som.grid(), quality.winners);
  std::string text =
      fmt::format("individuals_apart {}\nareas_connected {}\n",
                  individuals_apart(quality.winners, classes), areas.connected(classes));
  if (both.model.classes.empty()) return text;
  return accuracy(both).map(
      [&](double share) { return text + fmt::format("accuracy {:.6g}\n", share); });
}

Result<void> quality(const Arguments& arguments) {
  auto threads = read_threads(arguments);
  if (!threads) return fail(std::move(threads.error()));
  const auto both = read_map_and_rows(arguments);
  if (!both) return fail(both.error());
  const auto quality = measure_rows(both->model, both->rows, *threads);
  if (!quality) return fail(quality.error());
  const auto of_labels =
      both->rows.labelled() ? label_measures(*both, *quality) : Result<std::string>();
  if (!of_labels) return fail(of_labels.error());
  const auto hit = std::count_if(quality->hits.begin(), quality->hits.end(),
                                 [](std::size_t hits) { return hits > 0; });
  fmt::print("samples {}\nneurons {}\nneurons_hit {}\n", both->rows.count,
             both->model.som.neurons(), hit);
  fmt::print("quantization_error {:.6g}\ntopographic_error {:.6g}\n{}", quality->quantization_error,
             quality->topographic_error, *of_labels);
  return {};
}

}  // namespace

Command som_quality_command() {
  std::vector<Flag> flags = data_flags();
  flags.push_back(threads_flag());
  flags.push_back(memory_flag());
  return {"som quality",
          "Measure how well a map stands for data",
          {{"MAP", "A trained map", true}, {"DATA", "NPY file or text, as for training", true}},
          std::move(flags),
          {},
          quality};
}

}  // namespace somato::program
