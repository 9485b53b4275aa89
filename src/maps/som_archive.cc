#include "maps/som_archive.h"

#include <cstdint>
#include <utility>
#include <vector>

#include "maps/map_parts.h"

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

}  // namespace

void add_som(Archive& archive, const std::string& prefix, const Som& som) {
  archive.add(prefix + "parameters", parameters_to_toml(som.parameters()));
  add_matrix(archive, prefix + "weights", som.weights().to_matrix());
  if (!som.elements().all()) add_elements(archive, prefix, som.elements());
}

Result<Som> som_from(const Archive& archive, const std::string& prefix, const std::string& where) {
  SOMATO_TRY(auto parameters, read_decided(archive, prefix + "parameters", where));
  SOMATO_TRY(auto weights, matrix_from(archive, prefix + "weights", where));
  if (weights.rows() != parameters.grid().size()) {
    return damaged_model("the map's weights do not fit its grid", where);
  }
  SOMATO_TRY(auto elements, read_elements(archive, prefix, weights.columns(), where));
  return Som(parameters, LaneMatrix<float>(weights), std::move(elements));
}

}  // namespace somato
