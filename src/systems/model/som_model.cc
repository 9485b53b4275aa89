#include "somato/graph/som_model.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/archives/archive.h"
#include "base/files/toml_file.h"
#include "maps/analysis/weighted_points.h"
#include "maps/som/map_parts.h"
#include "maps/som/som_archive.h"
#include "somato/core/check.h"
#include "systems/model/labels_part.h"
#include "systems/model/model_parts.h"
#include "systems/model/som_model_fit.h"

namespace somato {
namespace {

const std::string kSomKind = "som";
const std::string kSomPrefix = "som.";
const std::set<std::string> kKnownParts{kSomPrefix + "parameters",
                                        kSomPrefix + "weights",
                                        kSomPrefix + "input_size",
                                        kSomPrefix + "elements",
                                        kSomPrefix + "layers",
                                        kSomPrefix + "relevances",
                                        kSomPrefix + "graph",
                                        "features",
                                        "standardization",
                                        "classes",
                                        "labels",
                                        "means",
                                        "samples_seen"};

// The weights of a map are means of data, and those of a few neurons spread several times less.
constexpr double kSpreadOfData = 4.0;

// A list of names as a line of TOML, so that a name may hold anything.
std::string names_to_toml(const std::vector<std::string>& names) {
  Value::List list;
  for (const std::string& name : names) list.push_back({name});
  return "names = " + to_toml({list}) + "\n";
}

Result<std::vector<std::string>> read_names(const Archive& archive, const std::string& name,
                                            const std::string& where) {
  std::vector<std::string> names;
  if (!archive.find(name)) return names;
  SOMATO_TRY(auto text, archive.get<std::string>(name, where));
  const Result<Table> table = parse_toml(*text, where);
  const Table::Entry* entry = table ? table->find("names") : nullptr;
  const Value* value = entry ? std::get_if<Value>(&entry->content) : nullptr;
  const auto* list = value ? std::get_if<Value::List>(&value->content) : nullptr;
  if (!list || list->empty()) {
    return damaged_model("'" + name + "' is not a list of names", where);
  }
  for (const Value& item : *list) {
    const auto* item_text = std::get_if<std::string>(&item.content);
    if (!item_text) return damaged_model("'" + name + "' is not a list of names", where);
    names.push_back(*item_text);
  }
  return names;
}

Array<double> standardization_array(const Standardization& standardization) {
  Array<double> array{{2, standardization.means.size()}, standardization.means};
  array.values.insert(array.values.end(), standardization.deviations.begin(),
                      standardization.deviations.end());
  return array;
}

Result<void> read_standardization(const Archive& archive, const std::string& where,
                                  SomModel& model) {
  if (!archive.find("standardization")) return {};
  SOMATO_TRY(auto array, archive.get<Array<double>>("standardization", where));
  const std::vector<double>& values = array->values;
  const std::size_t size = model.som.input_size();
  if (array->shape != std::vector<std::uint64_t>{2, size}) {
    return damaged_model("the standardization does not fit the map", where);
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i]) || (i >= size && values[i] < 0.0)) {
      return damaged_model("the standardization contains an invalid number", where);
    }
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(size);
  model.standardization = Standardization{{values.begin(), middle}, {middle, values.end()}};
  return {};
}

Result<void> read_means(const Archive& archive, const std::string& where, SomModel& model) {
  if (!archive.find("means")) return {};
  SOMATO_TRY(auto array, archive.get<Array<double>>("means", where));
  const std::vector<double>& values = array->values;
  if (array->shape != std::vector<std::uint64_t>{model.som.input_size()}) {
    return damaged_model("the means do not fit the map", where);
  }
  for (const double value : values) {
    if (!std::isfinite(value)) return damaged_model("the means contain an invalid number", where);
  }
  model.means = values;
  return {};
}

Result<void> read_samples_seen(const Archive& archive, const std::string& where, SomModel& model) {
  if (!archive.find("samples_seen")) return {};
  SOMATO_TRY(const auto array, archive.get<Array<std::int64_t>>("samples_seen", where));
  const bool possible = array->shape == std::vector<std::uint64_t>{1} && array->values[0] >= 0 &&
                        model.som.parameters().training == Training::kOnline;
  if (!possible) return damaged_model("the number of samples seen does not fit the map", where);
  model.samples_seen = static_cast<std::uint64_t>(array->values[0]);
  if (model.samples_seen != model.som.parameters().iterations) return {};
  return damaged_model("the number of samples seen is that of the parameters", where);
}

Result<void> read_labels(const Archive& archive, const std::string& where, SomModel& model) {
  if (model.classes.empty() && !archive.find("labels")) return {};
  SOMATO_TRY(auto labels, labels_from(archive, model.som.neurons(), model.classes.size(), where));
  model.labels = std::move(labels);
  return {};
}

Archive archive_of(const SomModel& model) {
  const std::string misfit = misfit_of(model);
  require(misfit.empty(), misfit);
  Archive archive(kSomKind);
  add_som(archive, kSomPrefix, model.som);
  if (!model.features.empty()) archive.add("features", names_to_toml(model.features));
  if (model.standardization) {
    archive.add("standardization", standardization_array(*model.standardization));
  }
  if (!model.classes.empty()) {
    archive.add("classes", names_to_toml(model.classes));
    archive.add("labels", labels_array(model.labels));
  }
  if (!model.means.empty()) {
    archive.add("means", Array<double>{{model.means.size()}, model.means});
  }
  if (model.samples_seen && model.samples_seen != model.som.parameters().iterations) {
    archive.add("samples_seen",
                Array<std::int64_t>{{1}, {static_cast<std::int64_t>(*model.samples_seen)}});
  }
  return archive;
}

Result<SomModel> som_model_in(const Archive& archive, const std::string& where) {
  SOMATO_TRY_VOID(check_kind(archive, kSomKind, where));
  SOMATO_TRY_VOID(check_parts(archive, kKnownParts, where));
  SOMATO_TRY(auto som, som_from(archive, kSomPrefix, where));
  SOMATO_TRY(auto features, read_names(archive, "features", where));
  SOMATO_TRY(auto classes, read_names(archive, "classes", where));
  SomModel model{std::move(som), std::move(features), {}, std::move(classes), {}, {}};
  if (!model.features.empty() && model.features.size() != model.som.input_size()) {
    return damaged_model("the names of the features do not fit the map", where);
  }
  SOMATO_TRY_VOID(read_standardization(archive, where, model));
  SOMATO_TRY_VOID(read_labels(archive, where, model));
  SOMATO_TRY_VOID(read_means(archive, where, model));
  SOMATO_TRY_VOID(read_samples_seen(archive, where, model));
  return model;
}

bool are_finite(const std::vector<double>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double one) { return std::isfinite(one); });
}

bool is_scale(double deviation) {
  return std::isfinite(deviation) && deviation >= 0.0;
}

std::string misfit_of_scaling(const SomModel& model) {
  const std::size_t size = model.som.input_size();
  if (!model.means.empty() && model.means.size() != size) {
    return "a model's means need as many columns as the map";
  }
  if (!are_finite(model.means)) return "a model's means need finite numbers";
  if (!model.standardization) return {};
  const auto& [means, deviations] = *model.standardization;
  if (means.size() != size || deviations.size() != size) {
    return "a model's standardization needs as many columns as the map";
  }
  const bool is_possible =
      are_finite(means) && std::all_of(deviations.begin(), deviations.end(), is_scale);
  return is_possible ? "" : "a standardization needs finite means, and deviations of at least 0";
}

// The standard deviation of an element of the weights of all neurons.
double deviation_of(const Som& som, std::size_t element) {
  const auto neurons = static_cast<double>(som.neurons());
  double mean = 0.0;
  double greatest = 0.0;
  for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
    mean += double{som.weight(neuron, element)} / neurons;
    greatest = std::max(greatest, std::fabs(double{som.weight(neuron, element)}));
  }
  double squares = 0.0;
  for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
    const double difference = double{som.weight(neuron, element)} - mean;
    squares += difference * difference;
  }
  const double deviation = std::sqrt(squares / neurons);
  return deviation > kRoundingOfWeights * greatest ? deviation : 0.0;
}

}  // namespace

std::string misfit_of(const SomModel& model) {
  const std::size_t size = model.som.input_size();
  if (!model.features.empty() && model.features.size() != size) {
    return "a model needs one name for each input element, or none";
  }
  if (std::string misfit = misfit_of_scaling(model); !misfit.empty()) return misfit;
  if (model.labels.neurons() != (model.classes.empty() ? 0 : model.som.neurons())) {
    return "a model with classes needs a label or none for each neuron; a model without classes "
           "needs none";
  }
  if (!model.classes.empty() && model.labels.labelled().empty()) {
    return "a model with classes needs a neuron with a label";
  }
  for (const std::size_t neuron : model.labels.labelled()) {
    if (*model.labels[neuron] >= model.classes.size()) return "a neuron's class has no name";
  }
  return {};
}

std::vector<ColumnScale> SomModel::scales() const {
  std::vector<ColumnScale> scales(som.input_size());
  if (!standardization) {
    if (som.parameters().normalize_input.value_or(false)) return scales;
    for (std::size_t d = 0; d < scales.size(); ++d) {
      scales[d].deviation = kSpreadOfData * deviation_of(som, d);
    }
    return scales;
  }
  const std::vector<double> offsets = standardization->offsets();
  for (std::size_t d = 0; d < scales.size(); ++d) {
    scales[d] = {offsets[d], standardization->deviations[d]};
  }
  return scales;
}

void SomModel::subtract_offsets() {
  if (!standardization) return;
  const std::vector<double> offsets = standardization->offsets();
  standardization = standardization->without(offsets);
  for (std::size_t d = 0; d < means.size(); ++d) means[d] -= offsets[d];
}

std::uint64_t SomModel::seen() const {
  return samples_seen.value_or(som.parameters().iterations.value_or(0));
}

std::vector<double> SomModel::fill_values() const {
  return means.empty() && standardization ? standardization->means : means;
}

Samples SomModel::prepare(const Samples& samples) const {
  return standardization ? standardization->apply(samples) : samples;
}

std::string encode_som_model(const SomModel& model) {
  return encode_archive(archive_of(model));
}

Result<SomModel> decode_som_model(std::string_view bytes, const std::string& where) {
  SOMATO_TRY(const auto archive, decode_archive(bytes, where));
  return som_model_in(archive, where);
}

Result<void> save_som_model(const std::string& path, const SomModel& model) {
  return save_archive(path, archive_of(model));
}

Result<SomModel> load_som_model(const std::string& path) {
  SOMATO_TRY(const auto archive, load_archive(path));
  return som_model_in(archive, path);
}

}  // namespace somato
