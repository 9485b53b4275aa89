#include "somato/maps/som_archive.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "somato/files/toml_file.h"

namespace somato {
namespace {

tl::unexpected<Error> damaged(const std::string& what, const std::string& where) {
  return fail(ErrorKind::kData, what, where, "the file is damaged or not a map; save it again");
}

// What a file says is data, whatever reads it.
tl::unexpected<Error> as_data(Error error) {
  error.kind = ErrorKind::kData;
  return fail(std::move(error));
}

Result<SomParameters> read_decided(const std::string& toml, const std::string& where) {
  Result<Table> table = parse_toml(toml, where);
  if (!table) return as_data(std::move(table.error()));
  Result<SomParameters> parameters = read_parameters<SomParameters>(*table);
  if (!parameters) return as_data(std::move(parameters.error()));
  const bool decided = parameters->normalize_input && parameters->iterations &&
                       parameters->radius_start && parameters->radius_reached_at &&
                       parameters->learning_rate_reached_at;
  if (!decided) return damaged("a parameter of the map is left automatic", where);
  Result<SomParameters> resolved = resolve(*parameters, 1, 1);
  if (!resolved) return as_data(std::move(resolved.error()));
  return resolved;
}

}  // namespace

void add_som(Archive& archive, const std::string& prefix, const Som& som) {
  const Matrix<float> weights = som.weights().to_matrix();
  archive.add(prefix + "parameters", parameters_to_toml(som.parameters()));
  archive.add(prefix + "weights", Array<float>{{weights.rows(), weights.columns()},
                                               {weights.values().begin(), weights.values().end()}});
}

Result<Som> som_from(const Archive& archive, const std::string& prefix, const std::string& where) {
  auto toml = archive.get<std::string>(prefix + "parameters", where);
  if (!toml) return fail(std::move(toml.error()));
  auto weights = archive.get<Array<float>>(prefix + "weights", where);
  if (!weights) return fail(std::move(weights.error()));
  auto parameters = read_decided(**toml, where);
  if (!parameters) return fail(std::move(parameters.error()));
  const Array<float>& array = **weights;
  if (array.shape.size() != 2 || array.shape[0] != parameters->grid().size()) {
    return damaged("the map's weights do not fit its grid", where);
  }
  if (!std::all_of(array.values.begin(), array.values.end(),
                   [](float weight) { return std::isfinite(weight); })) {
    return damaged("a weight of the map is not finite", where);
  }
  return Som(*parameters, Matrix<float>(array.shape[0], array.shape[1], array.values));
}

}  // namespace somato
