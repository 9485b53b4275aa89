#include "maps/som/som_archive.h"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "maps/som/layer_parts.h"
#include "maps/som/map_parts.h"
#include "maps/som/relevances.h"

namespace somato {
namespace {

// Parameters must be resolved, since automatic values depend on the samples.
Result<SomParameters> read_decided(const Archive& archive, const std::string& name,
                                   const std::string& where) {
  auto parameters = parameters_from<SomParameters>(archive, name, where);
  if (!parameters) return parameters;
  const bool decided = parameters->normalize_input && parameters->iterations &&
                       parameters->radius_start && parameters->radius_reached_at &&
                       parameters->learning_rate_reached_at &&
                       parameters->arithmetic != Arithmetic::kAutomatic;
  if (!decided) return damaged_model("a parameter of the map is still automatic", where);
  auto resolved = resolve(*parameters, 1, 1);
  if (!resolved) return damaged_model(std::move(resolved.error()), where);
  return resolved;
}

void add_elements(Archive& archive, const std::string& prefix, const StoredElements& elements) {
  archive.add(prefix + "input_size",
              Array<std::int64_t>{{1}, {static_cast<std::int64_t>(elements.size())}});
  archive.add(prefix + "elements",
              Array<std::int64_t>{{elements.count()},
                                  {elements.listed().begin(), elements.listed().end()}});
}

// Elements are numbered by 32 bits.
Result<std::size_t> read_input_size(const Archive& archive, const std::string& name,
                                    const std::string& where) {
  constexpr std::int64_t kLargest = std::int64_t{1} << 32U;
  SOMATO_TRY(const auto found, archive.get<Array<std::int64_t>>(name, where));
  const Array<std::int64_t>& array = *found;
  if (array.shape != std::vector<std::uint64_t>{1} || array.values[0] < 1 ||
      array.values[0] > kLargest) {
    return damaged_model("'" + name + "' is not a valid input size", where);
  }
  return static_cast<std::size_t>(array.values[0]);
}

Result<std::vector<std::uint32_t>> read_list(const Archive& archive, const std::string& name,
                                             std::size_t size, const std::string& where) {
  SOMATO_TRY(const auto found, archive.get<Array<std::int64_t>>(name, where));
  const Array<std::int64_t>& array = *found;
  std::vector<std::uint32_t> listed;
  listed.reserve(array.values.size());
  for (const std::int64_t element : array.values) {
    if (element < 0 || std::cmp_greater_equal(element, size)) {
      return damaged_model("'" + name + "' contains an element outside the input", where);
    }
    listed.push_back(static_cast<std::uint32_t>(element));
  }
  if (array.shape.size() == 1 && StoredElements::possible_list(size, listed)) return listed;
  return damaged_model("'" + name + "' is not an ascending list", where);
}

// All of `columns` elements by default.
Result<StoredElements> read_elements(const Archive& archive, const std::string& prefix,
                                     std::size_t columns, const std::string& where) {
  if (!archive.find(prefix + "elements") && !archive.find(prefix + "input_size")) {
    return StoredElements(columns);
  }
  SOMATO_TRY(const auto size, read_input_size(archive, prefix + "input_size", where));
  SOMATO_TRY(auto listed, read_list(archive, prefix + "elements", size, where));
  if (listed.size() != columns) {
    return damaged_model("'" + prefix + "elements' does not fit the map's weights", where);
  }
  return StoredElements(size, std::move(listed));
}

// The number of neurons and of edges, then the two neurons of each edge.
void add_graph(Archive& archive, const std::string& prefix, const NeuronGraph& graph) {
  Array<std::int64_t> array{
      {graph.edges().size() + 1, 2},
      {static_cast<std::int64_t>(graph.size()), static_cast<std::int64_t>(graph.edges().size())}};
  for (const auto& [a, b] : graph.edges()) {
    array.values.push_back(static_cast<std::int64_t>(a));
    array.values.push_back(static_cast<std::int64_t>(b));
  }
  archive.add(prefix + "graph", std::move(array));
}

// The same graph for the same numbers only.
Result<std::shared_ptr<const NeuronGraph>> read_graph(const Archive& archive,
                                                      const std::string& name, std::size_t neurons,
                                                      const std::string& where) {
  SOMATO_TRY(const auto found, archive.get<Array<std::int64_t>>(name, where));
  const std::vector<std::int64_t>& values = found->values;
  const auto damaged = [&] { return damaged_model("'" + name + "' is not a graph", where); };
  if (neurons > NeuronGraph::kMostNeurons || found->shape.size() != 2 || found->shape[1] != 2 ||
      std::cmp_not_equal(values[0], neurons) ||
      std::cmp_not_equal(values[1], found->shape[0] - 1)) {
    return damaged();
  }
  std::vector<NeuronGraph::Edge> edges;
  edges.reserve(found->shape[0] - 1);
  for (std::size_t i = 2; i < values.size(); i += 2) {
    if (values[i] < 0 || values[i] >= values[i + 1] ||
        std::cmp_greater_equal(values[i + 1], neurons)) {
      return damaged();
    }
    edges.emplace_back(values[i], values[i + 1]);
    if (edges.size() > 1 && !(edges[edges.size() - 2] < edges.back())) return damaged();
  }
  return std::make_shared<const NeuronGraph>(neurons, std::move(edges));
}

}  // namespace

void add_som(Archive& archive, const std::string& prefix, const Som& som) {
  archive.add(prefix + "parameters", parameters_to_toml(som.parameters()));
  add_matrix(archive, prefix + "weights", som.weights().to_matrix());
  if (!som.parameters().layers.empty()) {
    archive.add(prefix + "layers", layers_to_toml(som.parameters().layers));
  }
  add_relevances(archive, prefix + "relevances", som.parameters());
  if (!som.elements().all()) add_elements(archive, prefix, som.elements());
  if (som.grid().graph()) add_graph(archive, prefix, *som.grid().graph());
}

Result<Som> som_from(const Archive& archive, const std::string& prefix, const std::string& where) {
  SOMATO_TRY(auto parameters, read_decided(archive, prefix + "parameters", where));
  SOMATO_TRY(auto weights, matrix_from(archive, prefix + "weights", where));
  if (weights.rows() != parameters.grid().size()) {
    return damaged_model("the map's weights do not fit its grid", where);
  }
  SOMATO_TRY(parameters.layers, layers_from(archive, prefix + "layers", weights.columns(), where));
  SOMATO_TRY(parameters.relevances,
             relevances_from(archive, prefix + "relevances", parameters, weights.columns(), where));
  if (archive.find(prefix + "graph")) {
    SOMATO_TRY(auto graph, read_graph(archive, prefix + "graph", weights.rows(), where));
    if (parameters.grid().rows() == 1) return Som(parameters, weights, std::move(graph));
    return damaged_model("the map's graph does not fit its grid", where);
  }
  SOMATO_TRY(auto elements, read_elements(archive, prefix, weights.columns(), where));
  return Som(parameters, LaneMatrix<float>(weights), std::move(elements));
}

}  // namespace somato
