#include "systems/exchange/map_npz_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/archives/archive.h"
#include "base/archives/zip_reader.h"
#include "base/arrays/npy_texts.h"
#include "base/arrays/npz_arrays.h"
#include "base/text/format_version.h"
#include "base/text/number_of_text.h"
#include "maps/som/map_parts.h"
#include "maps/som/som_archive.h"
#include "systems/exchange/map_array.h"
#include "systems/exchange/map_npz_format.h"
#include "systems/exchange/parameters_json.h"
#include "systems/model/som_model_fit.h"

namespace somato {
namespace {

const std::set<std::string> kKnownArrays{
    "file_format", "parameters",    "weights",      "positions", "edges",
    "elements",    "feature_names", "mean",         "scale",     "labels",
    "class_names", "fill_values",   "samples_seen", "layers",    "relevances"};

// The first version is 1. Errors (kData): no version, or a newer one.
Result<void> check_version(const NpzArrays& arrays, const std::string& where) {
  SOMATO_TRY(const std::string npy, arrays.read("file_format"));
  SOMATO_TRY(const auto texts, texts_in_npy(npy, arrays.place_of("file_format")));
  const std::string& text = texts.front();
  if (texts.size() == 1 && text == kMapNpzFormat + std::to_string(kMapNpzVersion)) return {};
  const bool is_ours = texts.size() == 1 && text.starts_with(kMapNpzFormat);
  const auto version =
      is_ours ? number_of_text<std::uint64_t>(text.substr(kMapNpzFormat.size())) : std::nullopt;
  if (!version || *version == 0) {
    return damaged_model("'file_format' is not that of a map", where);
  }
  return unsupported_format(*version, kMapNpzVersion, where, {});
}

Result<void> check_known(const NpzArrays& arrays, const std::string& where) {
  std::set<std::string> seen;
  for (const std::string& name : arrays.names()) {
    if (!seen.insert(name).second) {
      return damaged_model(fmt::format("the archive has the array '{}' twice", name), where);
    }
    if (kKnownArrays.contains(name)) continue;
    return damaged_model(
        unknown_name("array", name, where, {kKnownArrays.begin(), kKnownArrays.end()}), where);
  }
  if (!arrays.has_others()) return {};
  return damaged_model("the archive has a member that is not an array", where);
}

Result<std::vector<std::string>> names_in(const NpzArrays& arrays, const std::string& name) {
  if (!arrays.has(name)) return std::vector<std::string>();
  SOMATO_TRY(const std::string npy, arrays.read(name));
  return texts_in_npy(npy, arrays.place_of(name));
}

// Whole numbers from -1, of any number of dimensions.
Result<std::vector<std::int64_t>> integers_in(const NpzArrays& arrays, const std::string& name) {
  constexpr double kMost = 9007199254740992.0;  // 2^53: all integers below are doubles.
  SOMATO_TRY(const auto numbers, arrays.numbers(name));
  std::vector<std::int64_t> integers;
  integers.reserve(numbers.size());
  for (const double number : numbers) {
    if (number < -1.0 || number >= kMost || std::floor(number) != number) {
      return damaged_model(fmt::format("{} is not a whole number of at least -1", number),
                           arrays.place_of(name));
    }
    integers.push_back(static_cast<std::int64_t>(number));
  }
  return integers;
}

Result<std::vector<double>> list_in(const NpzArrays& arrays, const std::string& name) {
  if (!arrays.has(name)) return std::vector<double>();
  return arrays.numbers(name);
}

// The columns in `elements` of weights whose other columns are 0.
Result<Array<float>> stored_columns(const Matrix<float>& weights,
                                    const std::vector<std::int64_t>& elements,
                                    const std::string& where) {
  std::vector<bool> is_stored(weights.columns());
  for (const std::int64_t element : elements) {
    if (element < 0 || std::cmp_greater_equal(element, weights.columns())) {
      return damaged_model("'elements' contains an element outside the input", where);
    }
    is_stored[static_cast<std::size_t>(element)] = true;
  }
  Array<float> stored{{weights.rows(), elements.size()}, {}};
  for (std::size_t neuron = 0; neuron < weights.rows(); ++neuron) {
    for (std::size_t d = 0; d < weights.columns(); ++d) {
      if (is_stored[d]) stored.values.push_back(weights(neuron, d));
      if (is_stored[d] || weights(neuron, d) == 0.0F) continue;
      return damaged_model(fmt::format("neuron {} has a weight for feature {}, which is not in "
                                       "'elements' (counted from 0)",
                                       neuron, d),
                           where);
    }
  }
  return stored;
}

// The parts of a model file for the elements of the input that have weights.
Result<void> add_weights(const NpzArrays& arrays, const Matrix<float>& weights, Archive& archive,
                         const std::string& where) {
  if (!arrays.has("elements")) {
    add_matrix(archive, "weights", weights);
    return {};
  }
  SOMATO_TRY(auto elements, integers_in(arrays, "elements"));
  SOMATO_TRY(auto stored, stored_columns(weights, elements, where));
  if (stored.values.size() != elements.size() * weights.rows()) {
    return damaged_model("'elements' is not an ascending list", where);
  }
  archive.add("weights", std::move(stored));
  const auto size = static_cast<std::int64_t>(weights.columns());
  archive.add("input_size", Array<std::int64_t>{{1}, {size}});
  archive.add("elements", Array<std::int64_t>{{elements.size()}, std::move(elements)});
  return {};
}

// A map that grows has neurons instead of rows and columns.
Result<void> add_graph(const NpzArrays& arrays, std::size_t neurons, Archive& archive) {
  Array<std::int64_t> graph{{1, 2}, {static_cast<std::int64_t>(neurons), 0}};
  if (arrays.has("edges")) {
    SOMATO_TRY(const auto edges, integers_in(arrays, "edges"));
    graph.shape[0] += edges.size() / 2;
    graph.values[1] = static_cast<std::int64_t>(edges.size() / 2);
    graph.values.insert(graph.values.end(), edges.begin(),
                        edges.end() - static_cast<std::ptrdiff_t>(edges.size() % 2));
  }
  archive.add("graph", std::move(graph));
  return {};
}

Result<void> check_shape(const MapArray& weights, const SomParameters& parameters,
                         const std::string& where) {
  const bool is_graph = weights.shape.size() == 2;
  const bool fits =
      !parameters.is_size_automatic() &&
      (is_graph ? parameters.rows == 1 && weights.shape[0] == parameters.columns
                : weights.shape[0] == parameters.rows && weights.shape[1] == parameters.columns);
  if (fits) return {};
  return damaged_model(
      fmt::format("'weights' of {} does not fit the rows and columns of 'parameters'",
                  fmt::join(weights.shape, " x ")),
      where);
}

Result<SomParameters> parameters_in(const NpzArrays& arrays, const std::string& where) {
  SOMATO_TRY(const auto texts, names_in(arrays, "parameters"));
  if (texts.size() != 1) return damaged_model("'parameters' is not a text", where);
  return som_parameters_from_json(texts.front(), arrays.place_of("parameters"));
}

Result<Som> som_in(const NpzArrays& arrays, const std::string& where) {
  SOMATO_TRY(const auto parameters, parameters_in(arrays, where));
  SOMATO_TRY(const std::string npy, arrays.read("weights"));
  SOMATO_TRY(const MapArray weights, map_array_in_npy(npy, arrays.place_of("weights")));
  SOMATO_TRY_VOID(check_shape(weights, parameters, where));
  Archive archive("som");
  archive.add("parameters", parameters_to_toml(parameters));
  SOMATO_TRY_VOID(add_weights(arrays, weights.weights, archive, where));
  if (arrays.has("layers")) {
    SOMATO_TRY(const auto texts, names_in(arrays, "layers"));
    if (texts.size() != 1) return damaged_model("'layers' is not a text", where);
    archive.add("layers", texts.front());
  }
  if (arrays.has("relevances")) {
    SOMATO_TRY(auto relevances, list_in(arrays, "relevances"));
    archive.add("relevances", Array<double>{{relevances.size()}, std::move(relevances)});
  }
  const bool is_graph = weights.shape.size() == 2;
  if (is_graph) SOMATO_TRY_VOID(add_graph(arrays, weights.weights.rows(), archive));
  return som_from(archive, "", where);
}

Result<void> read_scaling(const NpzArrays& arrays, const std::string& where, SomModel& model) {
  SOMATO_TRY(model.means, list_in(arrays, "fill_values"));
  if (arrays.has("mean") != arrays.has("scale")) {
    return damaged_model("a standardization needs both 'mean' and 'scale'", where);
  }
  if (!arrays.has("mean")) return {};
  SOMATO_TRY(auto means, list_in(arrays, "mean"));
  SOMATO_TRY(auto deviations, list_in(arrays, "scale"));
  model.standardization = Standardization{std::move(means), std::move(deviations)};
  return {};
}

Result<void> read_labels(const NpzArrays& arrays, const std::string& where, SomModel& model) {
  SOMATO_TRY(model.classes, names_in(arrays, "class_names"));
  if (!arrays.has("labels")) return {};
  SOMATO_TRY(const auto numbers, integers_in(arrays, "labels"));
  std::vector<std::optional<std::size_t>> classes;
  classes.reserve(numbers.size());
  for (const std::int64_t number : numbers) {
    classes.push_back(number < 0 ? std::optional<std::size_t>() : static_cast<std::size_t>(number));
  }
  if (classes.size() != model.som.neurons()) {
    return damaged_model(
        fmt::format("'labels' has {} numbers for {} neurons", classes.size(), model.som.neurons()),
        where);
  }
  model.labels = NeuronLabels(std::move(classes));
  return {};
}

Result<void> read_samples_seen(const NpzArrays& arrays, const std::string& where, SomModel& model) {
  if (!arrays.has("samples_seen")) return {};
  SOMATO_TRY(const auto numbers, integers_in(arrays, "samples_seen"));
  const bool is_possible = numbers.size() == 1 && numbers[0] >= 0 &&
                           model.som.parameters().training == Training::kOnline;
  if (!is_possible) return damaged_model("'samples_seen' does not fit the map", where);
  model.samples_seen = static_cast<std::uint64_t>(numbers[0]);
  return {};
}

}  // namespace

bool is_map_npz(std::string_view bytes) {
  if (!is_zip(bytes)) return false;
  const auto arrays = NpzArrays::open(bytes, {});
  return arrays && arrays->has("file_format");
}

Result<SomModel> map_in_npz(std::string_view bytes, const std::string& where) {
  SOMATO_TRY(const NpzArrays arrays, NpzArrays::open(bytes, where));
  SOMATO_TRY_VOID(check_version(arrays, where));
  SOMATO_TRY_VOID(check_known(arrays, where));
  SOMATO_TRY(auto som, som_in(arrays, where));
  SomModel model{std::move(som), {}, {}, {}, {}, {}};
  SOMATO_TRY(model.features, names_in(arrays, "feature_names"));
  SOMATO_TRY_VOID(read_scaling(arrays, where, model));
  SOMATO_TRY_VOID(read_labels(arrays, where, model));
  SOMATO_TRY_VOID(read_samples_seen(arrays, where, model));
  std::string misfit = misfit_of(model);
  if (!misfit.empty()) return damaged_model(std::move(misfit), where);
  return model;
}

}  // namespace somato
