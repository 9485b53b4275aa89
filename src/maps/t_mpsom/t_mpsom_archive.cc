#include "maps/t_mpsom/t_mpsom_archive.h"

#include <utility>
#include <vector>

#include "maps/som/map_parts.h"

namespace somato {
namespace {

std::string weights_name(const std::string& prefix, std::size_t input) {
  return prefix + "weights_" + std::to_string(input);
}

}  // namespace

void add_t_mpsom(Archive& archive, const std::string& prefix, const TMpsom& map) {
  archive.add(prefix + "parameters", parameters_to_toml(map.parameters()));
  for (std::size_t input = 0; input < map.parameters().input_sizes.size(); ++input) {
    add_matrix(archive, weights_name(prefix, input), map.weights(input));
  }
}

Result<TMpsom> t_mpsom_from(const Archive& archive, const std::string& prefix,
                            const std::string& where) {
  SOMATO_TRY(auto parameters,
             parameters_from<TMpsomParameters>(archive, prefix + "parameters", where));
  std::vector<Matrix<float>> weights;
  for (std::size_t input = 0; input < parameters.input_sizes.size(); ++input) {
    SOMATO_TRY(auto matrix, matrix_from(archive, weights_name(prefix, input), where));
    weights.push_back(std::move(matrix));
  }
  auto map = TMpsom::from_weights(std::move(parameters), weights);
  if (!map) return damaged_model(std::move(map.error()), where);
  return map;
}

}  // namespace somato
