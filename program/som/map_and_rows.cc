#include "som/map_and_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "maps/som/sample_range.h"
#include "som/data.h"
#include "systems/model/complete_inputs.h"
#include "terminal/terminal.h"

namespace somato::program {
namespace {

Samples as_the_map_takes(const SomModel& model, const RowData& rows, const Samples& part) {
  return complete_inputs(model, rows.holds_missing ? rows.missing : MissingFill::kRefuse, part);
}

// Samples are dense, one row after the other.
Samples samples_in(const Samples& part, std::size_t first, std::size_t count) {
  return Samples::view_of({part[first].values.data(), count * part.size()}, part.size());
}

}  // namespace

Result<void> check_fills_of(const SomModel& model, const RowData& rows, const std::string& path) {
  if (!rows.holds_missing) return {};
  Result<void> fills = check_fills(model, rows.missing);
  if (fills) return {};
  fills.error().where = path;
  const bool takes_means = !model.fill_values().empty();
  fills.error().advice = rows.missing == MissingFill::kMean
                             ? "pass --missing nearest, or train with --missing mean or "
                               "--standardize"
                         : takes_means ? "pass --missing mean"
                                       : "train with --missing mean or --standardize, and pass "
                                         "--missing mean";
  return fills;
}

Result<MapAndRows> read_map_and_rows(const Arguments& arguments, JoinedProcesses* processes) {
  SOMATO_TRY(auto model, agreed(load_som_model(arguments.text("MAP")), processes));
  SOMATO_TRY(auto rows, read_rows(arguments, model.features, processes, model.scales()));
  SOMATO_TRY_VOID(agreed(check_fills_of(model, rows, arguments.text("MAP")), processes));
  model.subtract_offsets();
  if (rows.size() != model.som.input_size()) {
    Error error{ErrorKind::kData,
                fmt::format("the data have {} columns, but the map requires {}", rows.size(),
                            model.som.input_size()),
                rows.path,
                "use data with the columns that the map was trained on, or select them with "
                "--columns-to-use or --skip"};
    SOMATO_TRY_VOID(agreed<void>(fail(std::move(error)), processes));
  }
  return MapAndRows{std::move(model), std::move(rows)};
}

Result<SamplePart> SamplesInRange::next() {
  auto part = source_.next();
  if (!part || !*part) return part;
  for (std::size_t i = 0; i < (*part)->count(); ++i) {
    if (is_in_range((**part)[i])) continue;
    return fail(
        ErrorKind::kData,
        fmt::format(
            "row {} has values too large for the map, which computes distances in single precision",
            first_ + done_ + i + 1),
        path_, "leave the row out, or mark missing numbers as missing");
  }
  done_ += (*part)->count();
  return part;
}

PreparedRows::PreparedRows(const SomModel& model, const RowData& rows)
    : prepared_(rows.samples(),
                [&](const Samples& part) { return as_the_map_takes(model, rows, part); }),
      in_range_(model.standardization || rows.holds_missing ? static_cast<SampleSource&>(prepared_)
                                                            : rows.samples(),
                rows.path, rows.first),
      ahead_(in_range_) {}

Result<void> for_each_block(SampleSource& source, std::size_t most,
                            const std::function<Result<void>(const Samples&)>& visit) {
  return for_each_part(source, [&](const Samples& part) -> Result<void> {
    for (std::size_t first = 0; first < part.count(); first += most) {
      if (stop_requested()) return reading_stopped();
      const std::size_t count = std::min(most, part.count() - first);
      SOMATO_TRY_VOID(visit(count < part.count() ? samples_in(part, first, count) : part));
    }
    return {};
  });
}

Result<SomQuality> measure_rows(const SomModel& model, const RowData& rows, std::size_t threads,
                                JoinedProcesses* processes) {
  const Progress progress = rows.in_memory() ? Progress() : terminal_progress("measuring");
  PreparedRows prepared(model, rows);
  SomQualityMeasurement measurement(model.som, threads, processes != nullptr);
  std::vector<std::size_t> winners;
  std::size_t done = 0;
  auto measured = for_each_part(prepared.samples(), [&](const Samples& part) -> Result<void> {
    const std::vector<std::size_t> of_part = measurement.add(part);
    if (rows.labelled()) winners.insert(winners.end(), of_part.begin(), of_part.end());
    done += part.count();
    if (progress && !progress(done, rows.own_count)) return reading_stopped();
    return {};
  });
  SOMATO_TRY_VOID(agreed(std::move(measured), processes));
  if (processes) measurement.combine(*processes);
  SomQuality quality = measurement.quality();
  quality.winners = std::move(winners);
  return quality;
}

Result<SomMeasures> measure_rows(const MapAndRows& both, std::vector<SomMeasure> chosen,
                                 const MeasureParameters& parameters, std::size_t threads) {
  SomMeasurement measurement(both.model.som, both.rows.count, std::move(chosen), parameters,
                             threads);
  PreparedRows prepared(both.model, both.rows);
  StoppableRows rows(prepared.samples());
  return for_each_part(rows,
                       [&](const Samples& part) -> Result<void> {
                         measurement.add(part);
                         return {};
                       })
      .map([&] { return measurement.measures(both.rows.classes.of_sample); });
}

Result<void> measure_features(const MapAndRows& both, const std::vector<std::size_t>& winners,
                              FeatureMeasurement& measurement) {
  ChangedSamples prepared(both.rows.samples(),
                          [&](const Samples& part) { return both.model.prepare(part); });
  ReadAhead ahead(prepared);
  StoppableRows rows(ahead);
  std::span<const std::size_t> left(winners);
  return for_each_part(rows, [&](const Samples& part) -> Result<void> {
    measurement.add(part, left.first(part.count()));
    left = left.subspan(part.count());
    return {};
  });
}

std::vector<std::size_t> hits_of(const SomMeasures& measures) {
  std::vector<std::size_t> hits(measures.neurons.size());
  std::transform(measures.neurons.begin(), measures.neurons.end(), hits.begin(),
                 [](const NeuronMeasures& neuron) { return neuron.samples; });
  return hits;
}

std::string feature_name(const SomModel& model, std::size_t feature) {
  return model.features.empty() ? std::to_string(feature + 1) : model.features[feature];
}

}  // namespace somato::program
