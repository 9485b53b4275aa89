#include <fmt/format.h>

#include <cstdio>
#include <iterator>
#include <utility>

#include "commands.h"
#include "data.h"
#include "output.h"
#include "somato/files/csv.h"
#include "somato/files/npy.h"
#include "somato/files/whole_file.h"

namespace somato::program {
namespace {

std::string winners_csv(const MapAndData& both) {
  const Som& som = both.model.som;
  const bool labelled = !both.model.classes.empty();
  std::string csv = fmt::format("sample,winner,row,column,distance{}\n", labelled ? ",label" : "");
  SomWorkspace workspace;
  for (std::size_t i = 0; i < both.samples.count(); ++i) {
    const SignalView sample = both.samples[i];
    const std::size_t winner = som.winner(sample, workspace);
    fmt::format_to(std::back_inserter(csv), "{},{},{},{},{:.9g}", i + 1, winner,
                   som.grid().row_of(winner), som.grid().column_of(winner),
                   som.distance(sample, winner, workspace));
    if (labelled) {
      const std::size_t its_class = both.model.labels.classify(som, sample, workspace);
      csv += "," + csv_field(both.model.classes[its_class]);
    }
    csv += "\n";
  }
  return csv;
}

Result<void> write_activity(const MapAndData& both, const std::string& path) {
  Matrix<float> activity(both.samples.count(), both.model.som.neurons());
  SomWorkspace workspace;
  for (std::size_t i = 0; i < activity.rows(); ++i) {
    both.model.som.activity(both.samples[i], workspace, activity.row(i));
  }
  return write_npy(path, activity);
}

Result<void> map(const Arguments& arguments) {
  if (auto savable = check_output(arguments, "output"); !savable) return savable;
  if (auto savable = check_output(arguments, "activity"); !savable) return savable;
  auto both = read_map_and_data(arguments);
  if (!both) return fail(std::move(both.error()));
  if (arguments.has("activity")) {
    auto written = write_activity(*both, arguments.text("activity"));
    if (!written) return written;
  }
  const std::string csv = winners_csv(*both);
  if (arguments.has("output")) return save_whole(arguments.text("output"), csv);
  std::fputs(csv.c_str(), stdout);
  return {};
}

}  // namespace

Command som_map_command() {
  return {"som map",
          "Find the winner of each row on a map, and its label if the map has labels",
          {{"MAP", "A trained map", true}, {"DATA", "NPY file or text, as for training", true}},
          {{"-o,--output", "CSV file instead of standard output"},
           {"--activity", "NPY file for the activity of every neuron, a row a sample"},
           {"--label-column", "Column of a CSV file that holds labels, which is left out"},
           {"--header",
            "Whether the first line of a text file holds names, yes or no; default: when it holds "
            "something that is no number"}},
          {},
          map};
}

}  // namespace somato::program
