#include "somato/maps/som_archive.h"

#include <utility>

#include "maps/map_parts.h"

namespace somato {
namespace {

// Without a parameter that resolve() would decide: what it decides depends on the samples.
Result<SomParameters> read_decided(const Archive& archive, const std::string& name,
                                   const std::string& where) {
  auto parameters = parameters_from<SomParameters>(archive, name, where);
  if (!parameters) return parameters;
  const bool decided = parameters->normalize_input && parameters->iterations &&
                       parameters->radius_start && parameters->radius_reached_at &&
                       parameters->learning_rate_reached_at &&
                       parameters->arithmetic != Arithmetic::kAutomatic;
  if (!decided) return damaged_model("a parameter of the map is left automatic", where);
  auto resolved = resolve(*parameters, 1, 1);
  if (!resolved) return damaged_model(std::move(resolved.error()), where);
  return resolved;
}

}  // namespace

void add_som(Archive& archive, const std::string& prefix, const Som& som) {
  archive.add(prefix + "parameters", parameters_to_toml(som.parameters()));
  add_matrix(archive, prefix + "weights", som.weights().to_matrix());
}

Result<Som> som_from(const Archive& archive, const std::string& prefix, const std::string& where) {
  auto parameters = read_decided(archive, prefix + "parameters", where);
  if (!parameters) return fail(std::move(parameters.error()));
  auto weights = matrix_from(archive, prefix + "weights", where);
  if (!weights) return fail(std::move(weights.error()));
  if (weights->rows() != parameters->grid().size()) {
    return damaged_model("the map's weights do not fit its grid", where);
  }
  return Som(*parameters, *weights);
}

}  // namespace somato
