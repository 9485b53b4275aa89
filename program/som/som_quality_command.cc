#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "flags/commands.h"
#include "flags/memory_flag.h"
#include "flags/result_output.h"
#include "maps/grid/areas.h"
#include "som/column_report.h"
#include "som/data.h"
#include "som/map_and_rows.h"
#include "som/measures_flag.h"
#include "som/processes.h"
#include "somato/maps/clusters.h"
#include "somato/maps/som_measures.h"

namespace somato::program {
namespace {

// A winner with a label names its samples; the other samples are searched among labelled neurons.
Result<double> accuracy(const MapAndRows& both, const std::vector<std::size_t>& winners,
                        std::size_t threads) {
  const SomModel& model = both.model;
  const Classes& classes = both.rows.classes;
  double right = 0.0;
  const auto count = [&](std::size_t row, std::size_t predicted) {
    right += model.classes[predicted] == classes.names[classes.of_sample[row]] ? 1.0 : 0.0;
  };
  std::size_t unnamed = 0;
  for (std::size_t row = 0; row < winners.size(); ++row) {
    const std::optional<std::size_t> label = model.labels[winners[row]];
    if (label) {
      count(row, *label);
    } else {
      ++unnamed;
    }
  }
  const auto share = [&] { return right / static_cast<double>(winners.size()); };
  if (unnamed == 0) return share();
  PreparedRows prepared(model, both.rows);
  std::size_t first = 0;
  return for_each_part(prepared.samples(),
                       [&](const Samples& part) -> Result<void> {
                         std::vector<std::size_t> places;
                         for (std::size_t i = 0; i < part.count(); ++i) {
                           if (!model.labels[winners[first + i]]) places.push_back(i);
                         }
                         const auto found =
                             model.labels.classify(model.som, part.subset(places), threads);
                         for (std::size_t i = 0; i < found.size(); ++i) {
                           count(first + places[i], found[i]);
                         }
                         first += part.count();
                         return {};
                       })
      .map(share);
}

Result<void> add_label_measures(const MapAndRows& both, const SomQuality& quality,
                                std::size_t threads, Table& table) {
  if (!both.rows.labelled()) return {};
  const std::vector<std::size_t>& classes = both.rows.classes.of_sample;
  const WinnerAreas areas(both.model.som.grid(), quality.winners);
  table.entries.push_back(entry("individuals_apart", individuals_apart(quality.winners, classes)));
  table.entries.push_back(entry("areas_connected", areas.connected(classes)));
  if (both.model.classes.empty()) return {};
  return accuracy(both, quality.winners, threads).map([&](double share) {
    table.entries.push_back(entry("accuracy", share));
  });
}

// Only one process can measure more than the errors, which needs all samples together.
Result<MeasuresRequest> requested_measures(const Arguments& arguments,
                                           const JoinedProcesses* processes) {
  auto request = read_measures(arguments);
  if (!request || !request->any() || !processes) return request;
  return fail(ErrorKind::kUsage, "several processes cannot share the work of this flag",
              "--measures", "omit it, or start one process");
}

Result<void> measure(const Arguments& arguments, JoinedProcesses* processes) {
  SOMATO_TRY(const auto request, agreed(requested_measures(arguments, processes), processes));
  SOMATO_TRY(const auto threads, agreed(threads_of(arguments, processes), processes));
  SOMATO_TRY(const auto both, read_map_and_rows(arguments, processes));
  SOMATO_TRY(const auto quality, measure_rows(both.model, both.rows, threads, processes));
  if (processes && !processes->is_first()) return {};
  const auto hit = std::count_if(quality.hits.begin(), quality.hits.end(),
                                 [](std::size_t hits) { return hits > 0; });
  Table table{{},
              {entry("samples", both.rows.count), entry("neurons", both.model.som.neurons()),
               entry("neurons_hit", static_cast<std::uint64_t>(hit)),
               entry("quantization_error", quality.quantization_error),
               entry("topographic_error", quality.topographic_error)}};
  SOMATO_TRY_VOID(add_label_measures(both, quality, threads, table));
  std::string text = lines_of(table);
  if (request.any()) {
    SOMATO_TRY(text, add_measures(request, both, threads, table));
  }
  print_result(arguments, text, table);
  note_columns_and_filled(both.rows);
  return {};
}

Result<void> quality(const Arguments& arguments) {
  SOMATO_TRY(const auto processes, Processes::join());
  return processes.leave(measure(arguments, processes.group()));
}

std::vector<KeySection> key_sections_of_measures() {
  return {{"Measures and clusters of maps",
           "Flags of `somato som quality` and `somato som cluster`; they are not keys of a file. "
           "[measures.md](../mathematics/measures.md) gives the definitions; none of these numbers "
           "is in the papers.",
           {key_table<MeasureParameters>("measures"), key_table<ClusterParameters>("clusters")}}};
}

}  // namespace

Command som_quality_command() {
  std::vector<Flag> flags = data_flags();
  flags.push_back(measures_flag());
  flags.push_back(threads_flag());
  flags.push_back(memory_flag());
  flags.push_back(json_flag());
  return {"som quality",
          "Measure the quality of a map for data",
          {{"MAP", "A trained map", true}, data_positional("NPY file or text, as for training")},
          std::move(flags),
          MeasureParameters::declarations().infos(),
          quality,
          {"measures"},
          key_sections_of_measures};
}

}  // namespace somato::program
