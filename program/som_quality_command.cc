#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "commands.h"
#include "data.h"
#include "somato/maps/areas.h"
#include "somato/maps/som_quality.h"

namespace somato::program {
namespace {

double accuracy(const MapAndData& both) {
  const SomModel& model = both.model;
  SomWorkspace workspace;
  double right = 0.0;
  for (std::size_t i = 0; i < both.samples.count(); ++i) {
    const std::size_t predicted = model.labels.classify(model.som, both.samples[i], workspace);
    right += model.classes[predicted] == both.data.labels[i] ? 1.0 : 0.0;
  }
  return right / static_cast<double>(both.samples.count());
}

void print_label_measures(const MapAndData& both, const SomQuality& quality) {
  const std::vector<std::size_t> classes = Classes::from_names(both.data.labels).of_sample;
  const WinnerAreas areas(both.model.som.grid(), quality.winners);
  fmt::print("individuals_apart {}\n", individuals_apart(quality.winners, classes));
  fmt::print("areas_connected {}\n", areas.connected(classes));
  if (!both.model.classes.empty()) fmt::print("accuracy {:.6g}\n", accuracy(both));
}

Result<void> quality(const Arguments& arguments) {
  auto threads = read_threads(arguments);
  if (!threads) return fail(std::move(threads.error()));
  auto both = read_map_and_data(arguments);
  if (!both) return fail(std::move(both.error()));
  const SomQuality quality = measure_quality(both->model.som, both->samples, *threads);
  const auto hit = std::count_if(quality.hits.begin(), quality.hits.end(),
                                 [](std::size_t hits) { return hits > 0; });
  fmt::print("samples {}\nneurons {}\nneurons_hit {}\n", both->samples.count(),
             both->model.som.neurons(), hit);
  fmt::print("quantization_error {:.6g}\ntopographic_error {:.6g}\n", quality.quantization_error,
             quality.topographic_error);
  if (!both->data.labels.empty()) print_label_measures(*both, quality);
  return {};
}

}  // namespace

Command som_quality_command() {
  std::vector<Flag> flags = data_flags();
  flags.push_back(threads_flag());
  return {"som quality",
          "Measure how well a map stands for data",
          {{"MAP", "A trained map", true}, {"DATA", "NPY file or text, as for training", true}},
          std::move(flags),
          {},
          quality};
}

}  // namespace somato::program
