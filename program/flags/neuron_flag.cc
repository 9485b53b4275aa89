#include "flags/neuron_flag.h"

#include <fmt/format.h>

#include <vector>

#include "base/text/text.h"
#include "somato/core/parameter.h"

namespace somato::program {

Result<std::size_t> chosen_neuron(const std::string& text, const Grid& grid) {
  ParameterInfo info;
  info.name = "neuron";
  info.type = "list of integer";
  info.range = Range::at_least(1);
  std::vector<std::size_t> place;
  const bool is_graph = grid.graph() != nullptr;
  if (detail::Field<std::vector<std::size_t>>::read(info, value_from_text(info, text), place)) {
    if (place.size() == 1 && is_graph) place.insert(place.begin(), 1);
    const bool is_inside =
        place.size() == 2 && place[0] <= grid.rows() && place[1] <= grid.columns();
    if (is_inside) return (place[0] - 1) * grid.columns() + place[1] - 1;
  }
  return fail(
      ErrorKind::kUsage, fmt::format("{} is not a neuron of the map", shown(text)), "--neuron",
      is_graph ? fmt::format("use a number from 1 to {}", grid.columns())
               : fmt::format("use ROW,COLUMN from 1,1 to {},{}", grid.rows(), grid.columns()));
}

}  // namespace somato::program
