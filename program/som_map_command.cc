#include <fmt/format.h>

#include <cstdio>
#include <iterator>
#include <optional>
#include <utility>

#include "commands.h"
#include "data.h"
#include "memory_flag.h"
#include "row_data.h"
#include "somato/files/csv.h"
#include "somato/files/file_writer.h"
#include "somato/files/npy.h"

namespace somato::program {
namespace {

// Where text goes as it comes: to a file, or to standard output.
class TextOutput {
 public:
  Result<void> begin(const Arguments& arguments) {
    if (!arguments.has("output")) return {};
    return FileWriter::begin(arguments.text("output")).map([&](FileWriter&& file) {
      file_ = std::move(file);
    });
  }

  Result<void> write(const std::string& text) {
    if (file_) return file_->write(text);
    std::fputs(text.c_str(), stdout);
    return {};
  }

  Result<void> commit() { return file_ ? file_->commit() : Result<void>(); }

 private:
  std::optional<FileWriter> file_;
};

std::string header_of_csv(const SomModel& model) {
  const bool labelled = !model.classes.empty();
  return fmt::format("sample,winner,row,column,distance{}\n", labelled ? ",label" : "");
}

// Lines for rows of which the first has the number `first`, from 0.
std::string winners_csv(const SomModel& model, const Samples& samples, std::size_t first) {
  const Som& som = model.som;
  std::string csv;
  SomWorkspace workspace;
  for (std::size_t i = 0; i < samples.count(); ++i) {
    const SignalView sample = samples[i];
    const std::size_t winner = som.winner(sample, workspace);
    fmt::format_to(std::back_inserter(csv), "{},{},{},{},{:.9g}", first + i + 1, winner,
                   som.grid().row_of(winner), som.grid().column_of(winner),
                   som.distance(sample, winner, workspace));
    if (!model.classes.empty()) {
      const std::size_t its_class = model.labels.classify(som, sample, workspace);
      csv += "," + csv_field(model.classes[its_class]);
    }
    csv += "\n";
  }
  return csv;
}

Result<void> write_winners(const MapAndRows& both, const Arguments& arguments) {
  TextOutput output;
  if (auto begun = output.begin(arguments); !begun) return begun;
  PreparedRows prepared(both.model, both.rows);
  std::size_t done = 0;
  return for_each_part(prepared.samples(),
                       [&](const Samples& part) {
                         std::string csv = winners_csv(both.model, part, done);
                         if (done == 0) csv.insert(0, header_of_csv(both.model));
                         done += part.count();
                         return output.write(csv);
                       })
      .and_then([&] { return output.commit(); });
}

Result<void> write_activity(const MapAndRows& both, const std::string& path) {
  const Som& som = both.model.som;
  auto file = FileWriter::begin(path);
  if (!file) return fail(std::move(file.error()));
  auto written = file->write(npy_start(both.rows.count, som.neurons()));
  if (!written) return written;
  PreparedRows prepared(both.model, both.rows);
  std::vector<float> activity(som.neurons());
  SomWorkspace workspace;
  return for_each_part(prepared.samples(),
                       [&](const Samples& part) -> Result<void> {
                         for (std::size_t i = 0; i < part.count(); ++i) {
                           som.activity(part[i], workspace, activity);
                           auto row = file->write(npy_numbers(activity));
                           if (!row) return row;
                         }
                         return {};
                       })
      .and_then([&] { return file->commit(); });
}

Result<void> map(const Arguments& arguments) {
  const auto both = read_map_and_rows(arguments);
  if (!both) return fail(both.error());
  if (arguments.has("activity")) {
    auto written = write_activity(*both, arguments.text("activity"));
    if (!written) return written;
  }
  return write_winners(*both, arguments);
}

}  // namespace

Command som_map_command() {
  return {"som map",
          "Find the winner of each row on a map, and its label if the map has labels",
          {{"MAP", "A trained map", true}, {"DATA", "NPY file or text, as for training", true}},
          {output_flag("-o,--output", "CSV file instead of standard output"),
           output_flag("--activity", "NPY file for the activity of every neuron, a row a sample"),
           {"--label-column", "Column of a CSV file that holds labels, which is left out"},
           {"--header",
            "Whether the first line of a text file holds names, yes or no; default: when it holds "
            "something that is no number"},
           memory_flag()},
          {},
          map};
}

}  // namespace somato::program
