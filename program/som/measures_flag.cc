#include "som/measures_flag.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "flags/result_output.h"
#include "som/map_and_rows.h"
#include "terminal/terminal.h"

namespace somato::program {
namespace {

std::vector<std::string> measure_names() {
  std::vector<std::string> names{"all"};
  for (const auto& choice : Choices<SomMeasure>::all()) names.push_back(choice.second);
  names.emplace_back("neurons");
  names.emplace_back("classes");
  return names;
}

// The names after --measures.
Result<std::vector<std::string>> named_measures(const Arguments& arguments) {
  ParameterInfo info;
  info.name = "measures";
  info.type = "list of choice";
  info.choices = measure_names();
  const Value value = value_from_text(info, arguments.text("measures"));
  std::vector<std::string> names;
  for (const Value& item : std::get<Value::List>(value.content)) {
    std::size_t choice = 0;
    if (auto read = detail::read_choice(info, item, choice); !read) {
      read.error().where = "--measures";
      return fail(std::move(read.error()));
    }
    names.push_back(info.choices[choice]);
  }
  return names;
}

Result<void> refuse_parameters(const Arguments& arguments) {
  for (const ParameterInfo& info : MeasureParameters::declarations().infos()) {
    const std::string flag = flag_of(info.name);
    if (!arguments.has(flag.substr(2))) continue;
    return fail(ErrorKind::kUsage, "has no effect without --measures", flag, "add --measures all");
  }
  return {};
}

bool ranks_neighbours(const std::vector<SomMeasure>& chosen) {
  return std::any_of(chosen.begin(), chosen.end(), [](SomMeasure measure) {
    return measure == SomMeasure::kTrustworthiness || measure == SomMeasure::kContinuity ||
           measure == SomMeasure::kNeighbourhoodPreservation;
  });
}

Result<void> refuse_without_effect(const Arguments& arguments, const MeasuresRequest& request) {
  const bool ranks = ranks_neighbours(request.chosen);
  const auto refuse = [&](const char* name, bool has_effect, const char* advice) -> Result<void> {
    if (has_effect || !arguments.has(name)) return {};
    return fail(ErrorKind::kUsage, "has no effect on these measures", "--" + std::string(name),
                advice);
  };
  const char* add_ranks = "add trustworthiness, continuity or neighbourhood_preservation";
  SOMATO_TRY_VOID(refuse("neighbours", ranks, add_ranks));
  SOMATO_TRY_VOID(refuse("ranked-samples", ranks, add_ranks));
  SOMATO_TRY_VOID(refuse("shuffles", !request.chosen.empty() || request.classes,
                         "add a measure of the whole map"));
  return refuse("seed", ranks || request.parameters.shuffles > 0,
                "only ranked samples and --shuffles are drawn");
}

// Measures that are not in the table yet.
void add_values(const SomMeasures& measures, const std::string& prefix, Table& table) {
  for (const auto& [measure, value] : measures.values) {
    const std::string name = prefix + choice_name(measure);
    if (!table.find(name)) table.entries.push_back(entry(name, value));
  }
}

Table table_of_class(const std::string& name, const ClassMeasures& of) {
  return {{},
          {entry("class", name), entry("samples", of.samples), entry("neurons", of.neurons),
           entry("quantization_error", of.quantization_error), entry("purity", of.purity),
           entry("entropy", of.entropy)}};
}

Table table_of_neuron(const Grid& grid, std::size_t neuron, const NeuronMeasures& of) {
  return {{},
          {entry("neuron", neuron), entry("row", grid.row_of(neuron)),
           entry("column", grid.column_of(neuron)), entry("samples", of.samples),
           entry("share", of.share), entry("mean_distance", of.mean_distance),
           entry("greatest_distance", of.greatest_distance)}};
}

// The entries of a table on one line: "class apple, samples 12, ...".
std::string line_of(const Table& table) {
  std::string line = lines_of(table);
  line.pop_back();
  for (std::size_t at = 0; (at = line.find('\n', at)) != std::string::npos;) {
    line.replace(at, 1, ", ");
  }
  return line + "\n";
}

std::string add_tables(std::string name, std::vector<Table> rows, bool is_listed, Table& table) {
  std::string lines;
  for (const Table& row : rows) lines += is_listed ? line_of(row) : "";
  table.entries.push_back(entry(std::move(name), std::move(rows)));
  return lines;
}

std::vector<Table> class_tables(const Classes& classes, const SomMeasures& measures) {
  std::vector<Table> tables;
  tables.reserve(measures.classes.size());
  for (std::size_t c = 0; c < measures.classes.size(); ++c) {
    tables.push_back(table_of_class(classes.names[c], measures.classes[c]));
  }
  return tables;
}

std::vector<Table> neuron_tables(const Grid& grid, const SomMeasures& measures) {
  std::vector<Table> tables;
  tables.reserve(measures.neurons.size());
  for (std::size_t neuron = 0; neuron < measures.neurons.size(); ++neuron) {
    tables.push_back(table_of_neuron(grid, neuron, measures.neurons[neuron]));
  }
  return tables;
}

// The means over the shuffles.
SomMeasures mean_of(const std::vector<SomMeasures>& shuffled) {
  SomMeasures mean;
  for (const SomMeasures& one : shuffled) {
    for (const auto& [measure, value] : one.values) {
      mean.values[measure] += value / static_cast<double>(shuffled.size());
    }
  }
  return mean;
}

Result<Samples> collected(const MapAndRows& both) {
  PreparedRows prepared(both.model, both.rows);
  SampleCollector collector;
  return for_each_part(prepared.samples(),
                       [&](const Samples& part) -> Result<void> {
                         for (std::size_t i = 0; i < part.count(); ++i) collector.add(part[i]);
                         return {};
                       })
      .map([&] { return collector.samples(); });
}

Result<std::vector<SomMeasures>> measures_by_chance(const MeasuresRequest& request,
                                                    const MapAndRows& both, std::size_t threads) {
  if (request.parameters.shuffles == 0) return std::vector<SomMeasures>();
  if (!both.rows.in_memory()) {
    return fail(ErrorKind::kSystem, "shuffling columns needs all rows in memory", both.rows.path,
                "use a larger --memory, or omit --shuffles");
  }
  SOMATO_TRY(const auto samples, collected(both));
  return measure_shuffled(both.model.som, samples, request.chosen, request.parameters,
                          both.rows.classes.of_sample, threads, terminal_progress("shuffles"));
}

Table table_of_shuffle(const MapAndRows& both, const MeasuresRequest& request,
                       const SomMeasures& measures) {
  Table table;
  add_values(measures, "", table);
  if (request.classes) {
    table.entries.push_back(entry("classes", class_tables(both.rows.classes, measures)));
  }
  return table;
}

}  // namespace

Flag measures_flag() {
  return {"--measures",
          fmt::format("Further measures, separated by commas: {}. The text lists neurons only if "
                      "they are named; --json always contains them with all",
                      fmt::join(measure_names(), ", "))};
}

Result<MeasuresRequest> read_measures(const Arguments& arguments) {
  MeasuresRequest request;
  if (!arguments.has("measures")) {
    return refuse_parameters(arguments).map([&] { return request; });
  }
  SOMATO_TRY(request.parameters, read_flags<MeasureParameters>(arguments));
  SOMATO_TRY(const auto names, named_measures(arguments));
  const auto named = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const auto& [measure, name] : Choices<SomMeasure>::all()) {
    if (named("all") || named(name)) request.chosen.push_back(measure);
  }
  const bool labelled = arguments.has("labels") || arguments.has("label-column");
  if (named("classes") && !labelled) {
    return fail(ErrorKind::kUsage, "classes cannot be measured without labels", "--measures",
                "use --labels or --label-column");
  }
  request.lists_neurons = named("neurons");
  request.neurons = named("all") || named("neurons");
  request.classes = labelled && (named("all") || named("classes"));
  return refuse_without_effect(arguments, request).map([&] { return request; });
}

Result<std::string> add_measures(const MeasuresRequest& request, const MapAndRows& both,
                                 std::size_t threads, Table& table) {
  SOMATO_TRY(const auto measures, measure_rows(both, request.chosen, request.parameters, threads));
  SOMATO_TRY(const auto shuffled, measures_by_chance(request, both, threads));
  add_values(measures, "", table);
  if (measures.ranked_samples > 0) {
    table.entries.push_back(entry("ranked_samples", measures.ranked_samples));
  }
  add_values(mean_of(shuffled), "shuffled_", table);
  std::string text = lines_of(table);
  if (request.classes) {
    text += add_tables("classes", class_tables(both.rows.classes, measures), true, table);
  }
  if (request.neurons) {
    text += add_tables("of_neurons", neuron_tables(both.model.som.grid(), measures),
                       request.lists_neurons, table);
  }
  if (!shuffled.empty()) {
    const auto make = [&](const SomMeasures& one) { return table_of_shuffle(both, request, one); };
    table.entries.push_back(entry("shuffled", shuffled, make));
  }
  return text;
}

}  // namespace somato::program
