#include "maps/pictures/map_panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "somato/core/check.h"
#include "somato/core/parameter.h"
#include "somato/maps/som_quality.h"

namespace somato {
namespace {

ValuePanel value_panel(std::string title, const Som& som, std::vector<double> values) {
  ValuePanel panel;
  panel.title = std::move(title);
  panel.grid = som.grid();
  panel.values = std::move(values);
  return panel;
}

}  // namespace

ValuePanel u_matrix_panel(const Som& som) {
  return value_panel("U-matrix", som, u_matrix(som));
}

std::vector<Panel> component_panels(const Som& som, const std::vector<std::string>& names,
                                    std::size_t most) {
  require(names.empty() || names.size() == som.input_size(),
          "component planes need one name per input element");
  const std::size_t count = std::min(most, som.input_size());
  std::vector<Panel> panels;
  panels.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    panels.emplace_back(value_panel(names.empty() ? fmt::format("Component {}", i + 1) : names[i],
                                    som, component_plane(som, i)));
  }
  return panels;
}

std::string caption_of(const Grid& grid) {
  if (const NeuronGraph* graph = grid.graph()) {
    return fmt::format("{} neurons with {} connections", graph->size(), graph->edges().size());
  }
  return fmt::format("{} x {} neurons, {} {}", grid.rows(), grid.columns(),
                     choice_name(grid.lattice()), choice_name(grid.topology()));
}

}  // namespace somato
