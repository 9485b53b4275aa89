#include "row_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "data.h"
#include "memory_flag.h"
#include "somato/core/check.h"
#include "somato/maps/initial_weights.h"
#include "somato/maps/sample_range.h"
#include "terminal.h"

namespace somato::program {
namespace {

// Large enough for every thread to be busy, small enough to stop soon.
constexpr std::size_t kLargestPart = std::size_t{8} << 20;

// Of what rows may take: one part in use, one coming, and what is made of them.
constexpr std::size_t kPartsInMemory = 8;

tl::unexpected<Error> stopped() {
  return fail(ErrorKind::kInterrupted, "reading was stopped before its end");
}

// Ends at Ctrl-C.
class StoppableRows final : public SampleSource {
 public:
  explicit StoppableRows(SampleSource& rows) : rows_(rows) {}

  std::size_t size() const override { return rows_.size(); }
  Result<void> rewind() override { return rows_.rewind(); }
  Result<SamplePart> next() override {
    if (stop_requested()) return stopped();
    return rows_.next();
  }

 private:
  SampleSource& rows_;
};

// The file, if its rows have to be read in parts.
Result<std::unique_ptr<NumberSource>> open_large(const Arguments& arguments) {
  const std::string path = arguments.text("DATA");
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return nullptr;
  const auto memory = read_memory(arguments);
  if (!memory) return fail(memory.error());
  auto options = read_csv_options(arguments);
  if (!options) return fail(std::move(options.error()));
  auto file = open_numbers(path, *options, std::min(kLargestPart, *memory / kPartsInMemory));
  if (!file || (*file)->memory_of_all() > static_cast<double>(*memory)) return file;
  return nullptr;
}

// Numbers classes in the order in which their names come by.
class ClassesByName {
 public:
  void take(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      const auto [found, is_new] = numbers_.emplace(name, classes_.names.size());
      if (is_new) classes_.names.push_back(name);
      classes_.of_sample.push_back(found->second);
    }
  }

  Classes classes() && { return std::move(classes_); }

 private:
  Classes classes_;
  std::map<std::string, std::size_t> numbers_;
};

void take_samples(const Samples& samples, RowData& rows) {
  rows.count += samples.count();
  widen_ranges(samples, rows.low, rows.high);
}

// Sees every row of the file once: what is wrong with it is told before anything begins.
Result<void> survey(NumberSource& file, RowData& rows) {
  constexpr std::uint64_t kSteps = 1000;
  const Progress progress = terminal_progress("reading");
  ClassesByName classes;
  for (;;) {
    const auto part = file.next_part();
    if (!part) return fail(part.error());
    if (!*part) break;
    take_samples((*part)->samples, rows);
    classes.take((*part)->labels);
    if (!progress(static_cast<std::uint64_t>(file.share_read() * (kSteps - 1)), kSteps)) {
      return stopped();
    }
  }
  progress(kSteps, kSteps);
  rows.classes = std::move(classes).classes();
  return {};
}

Result<void> add_labels_of_file(const Arguments& arguments, RowData& rows) {
  const auto labels = read_labels_of(arguments, rows.count);
  if (!labels) return fail(labels.error());
  if (!labels->empty()) rows.classes = Classes::from_names(*labels);
  return {};
}

}  // namespace

Result<RowData> read_rows(const Arguments& arguments) {
  if (auto once = check_labels_given_once(arguments); !once) return fail(std::move(once.error()));
  auto file = open_large(arguments);
  if (!file) return fail(std::move(file.error()));
  RowData rows;
  rows.path = arguments.text("DATA");
  if (*file) {
    rows.file_ = std::move(*file);
    rows.features = rows.file_->names();
    if (auto seen = survey(*rows.file_, rows); !seen) return fail(std::move(seen.error()));
    auto labelled = add_labels_of_file(arguments, rows);
    if (!labelled) return fail(std::move(labelled.error()));
    rows.samples_ = std::make_unique<StoppableRows>(*rows.file_);
    return rows;
  }
  auto data = read_data(arguments);
  if (!data) return fail(std::move(data.error()));
  rows.features = std::move(data->features);
  rows.classes = Classes::from_names(data->labels);
  rows.all_ = std::make_unique<const Samples>(std::move(data->samples));
  take_samples(*rows.all_, rows);
  rows.samples_ = std::make_unique<SamplesInMemory>(*rows.all_);
  return rows;
}

Result<void> refuse_constant_columns(const RowData& rows, const std::string& path) {
  for (std::size_t column = 0; column < rows.size(); ++column) {
    if (rows.low[column] != rows.high[column]) continue;
    const std::string name =
        rows.features.empty() ? "" : fmt::format(" ('{}')", rows.features[column]);
    return fail(ErrorKind::kData,
                fmt::format("column {}{} has the same value in every row", column + 1, name), path,
                "leave the column out, or pass --keep-constant-columns");
  }
  return {};
}

Result<MapAndRows> read_map_and_rows(const Arguments& arguments) {
  auto model = load_som_model(arguments.text("MAP"));
  if (!model) return fail(std::move(model.error()));
  auto rows = read_rows(arguments);
  if (!rows) return fail(std::move(rows.error()));
  if (rows->size() != model->som.input_size()) {
    return fail(ErrorKind::kData,
                fmt::format("the rows have {} numbers, but the map takes {}", rows->size(),
                            model->som.input_size()),
                arguments.text("DATA"), "give data with the columns that the map was trained on");
  }
  auto fit = check_names(model->features, rows->features, arguments.text("DATA"));
  if (!fit) return fail(std::move(fit.error()));
  return MapAndRows{std::move(*model), std::move(*rows)};
}

Result<SamplePart> SamplesInRange::next() {
  auto part = source_.next();
  if (!part || !*part) return part;
  for (std::size_t i = 0; i < (*part)->count(); ++i) {
    if (is_in_range((**part)[i])) continue;
    return fail(
        ErrorKind::kData,
        fmt::format("row {} is too large for the map: as the map takes it, it has to be told "
                    "apart from others in single precision",
                    done_ + i + 1),
        path_, "leave the row out, or write what stands for a missing number as one");
  }
  done_ += (*part)->count();
  return part;
}

PreparedRows::PreparedRows(const SomModel& model, const RowData& rows)
    : standardized_(rows.samples(), [&model](const Samples& part) { return model.prepare(part); }),
      in_range_(model.standardization ? static_cast<SampleSource&>(standardized_) : rows.samples(),
                rows.path),
      ahead_(in_range_) {}

Result<SomQuality> measure_rows(const SomModel& model, const RowData& rows, std::size_t threads) {
  const Progress progress = rows.in_memory() ? Progress() : terminal_progress("measuring");
  PreparedRows prepared(model, rows);
  SomQualityMeasurement measurement(model.som, threads);
  std::vector<std::size_t> winners;
  std::size_t done = 0;
  auto measured = for_each_part(prepared.samples(), [&](const Samples& part) -> Result<void> {
    const std::vector<std::size_t> of_part = measurement.add(part);
    if (rows.labelled()) winners.insert(winners.end(), of_part.begin(), of_part.end());
    done += part.count();
    if (progress && !progress(done, rows.count)) return stopped();
    return {};
  });
  if (!measured) return fail(std::move(measured.error()));
  SomQuality quality = measurement.quality();
  quality.winners = std::move(winners);
  return quality;
}

}  // namespace somato::program
