#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "flags/commands.h"
#include "flags/memory_flag.h"
#include "maps/reading/sample_reader.h"
#include "som/column_report.h"
#include "som/data.h"
#include "som/map_and_rows.h"
#include "som/processes.h"
#include "som/row_output.h"
#include "som/winner_format.h"
#include "somato/files/npy.h"

namespace somato::program {
namespace {

// Large enough for every thread to be busy, small enough for the output of a block to be small.
constexpr std::size_t kRowsAtOnce = std::size_t{1} << 16;
constexpr std::size_t kNumbersAtOnce = std::size_t{1} << 22;

// A process that comes after others continues their output.
Result<void> write_own_winners(const MapAndRows& both, const WinnerFormat& format,
                               std::size_t threads, bool is_first, RowOutput& output) {
  const SomModel& model = both.model;
  PreparedRows prepared(model, both.rows);
  SampleReader reader(model.som, threads,
                      model.classes.empty() ? std::vector<std::size_t>() : model.labels.labelled());
  std::size_t done = both.rows.first;
  bool has_begun = !is_first;
  SOMATO_TRY_VOID(
      for_each_block(prepared.samples(), kRowsAtOnce, [&](const Samples& block) -> Result<void> {
        const SampleReadings readings = reader.read(block, {false, true});
        if (!std::exchange(has_begun, true)) SOMATO_TRY_VOID(output.write(format.begin()));
        for (const std::string& text : format.rows(readings, done, threads)) {
          SOMATO_TRY_VOID(output.write(text));
        }
        done += block.count();
        return {};
      }));
  return has_begun ? Result<void>() : output.write(format.begin());
}

Result<void> write_winners(const MapAndRows& both, const Arguments& arguments, std::size_t threads,
                           ProcessGroup* processes) {
  SOMATO_TRY(auto output, RowOutput::begin(arguments.text("output"), processes));
  const WinnerFormat format(both.model, arguments.has("json"));
  const bool is_first = !processes || processes->is_first();
  const bool is_last = !processes || processes->rank() + 1 == processes->size();
  return output.commit(write_own_winners(both, format, threads, is_first, output).and_then([&] {
    return is_last ? output.write(format.end()) : Result<void>();
  }));
}

Result<void> write_own_activity(const MapAndRows& both, std::size_t threads, RowOutput& output) {
  const Som& som = both.model.som;
  PreparedRows prepared(both.model, both.rows);
  const std::size_t rows = std::max<std::size_t>(kNumbersAtOnce / som.neurons(), 1);
  std::vector<float> activity;
  return for_each_block(prepared.samples(), rows, [&](const Samples& block) {
    activity.resize(block.count() * som.neurons());
    read_activity(som, block, threads, activity);
    return output.write(npy_numbers(activity));
  });
}

Result<void> write_activity(const MapAndRows& both, const std::string& path, std::size_t threads,
                            ProcessGroup* processes) {
  SOMATO_TRY(auto output, RowOutput::begin(path, processes));
  const bool is_first = !processes || processes->is_first();
  const std::string start = npy_start(both.rows.count, both.model.som.neurons());
  return output.commit((is_first ? output.write(start) : Result<void>()).and_then([&] {
    return write_own_activity(both, threads, output);
  }));
}

Result<void> map_with(const Arguments& arguments, JoinedProcesses* processes) {
  SOMATO_TRY(const auto threads, agreed(threads_of(arguments, processes), processes));
  SOMATO_TRY(const auto both, read_map_and_rows(arguments, processes));
  if (arguments.has("activity")) {
    SOMATO_TRY_VOID(write_activity(both, arguments.text("activity"), threads, processes));
  }
  SOMATO_TRY_VOID(write_winners(both, arguments, threads, processes));
  if (!processes || processes->is_first()) note_columns_and_filled(both.rows);
  return {};
}

Result<void> map(const Arguments& arguments) {
  SOMATO_TRY(const auto processes, Processes::join());
  return processes.leave(map_with(arguments, processes.group()));
}

}  // namespace

Command som_map_command() {
  std::vector<Flag> flags{
      output_flag("-o,--output", "CSV file instead of standard output"),
      output_flag("--activity", "NPY file for the activity of every neuron, one row per sample")};
  const std::vector<Flag> of_table = table_flags();
  flags.insert(flags.end(), of_table.begin(), of_table.end());
  flags.push_back(threads_flag());
  flags.push_back(memory_flag());
  flags.push_back({"--json", "Write winners as JSON instead of CSV", false, false});
  return {"som map",
          "Find the winner of each row on a map, and its label if the map has labels",
          {{"MAP", "A trained map", true}, data_positional("NPY file or text, as for training")},
          std::move(flags),
          {},
          map};
}

}  // namespace somato::program
