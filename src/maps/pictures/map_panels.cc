#include "maps/pictures/map_panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "base/text/text.h"
#include "somato/core/check.h"
#include "somato/core/parameter.h"
#include "somato/maps/som_features.h"
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

// Neighbours, and on a rectangular grid the neurons a diagonal apart.
bool has_edge(const Grid& grid, std::size_t a, std::size_t b) {
  if (grid.graph() || grid.lattice() == Lattice::kHexagonal) return grid.adjacent(a, b);
  return grid.squared_distance(a, b) < 2.1;
}

// The neurons among which those with an edge to `neuron` are.
std::vector<std::size_t> around(const Grid& grid, std::size_t neuron) {
  std::vector<std::size_t> found = grid.neighbours(neuron);
  if (!grid.graph()) {
    for (const std::size_t other : grid.neighbours(neuron)) {
      for (const std::size_t next : grid.neighbours(other)) found.push_back(next);
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

std::vector<EdgeValue> edges_of(const Som& som) {
  constexpr double kSquareRootOf2 = 0x1.6a09e667f3bcdp+0;
  std::vector<EdgeValue> edges;
  for (std::size_t a = 0; a < som.neurons(); ++a) {
    for (const std::size_t b : around(som.grid(), a)) {
      if (b <= a || !has_edge(som.grid(), a, b)) continue;
      const double length = som.grid().adjacent(a, b) ? 1.0 : kSquareRootOf2;
      edges.push_back({a, b, neuron_distance(som, a, b) / length});
    }
  }
  return edges;
}

// The first elements, in the order of their panels.
std::vector<std::size_t> drawn_elements(const Som& som, std::size_t most, PlaneSorting sorting) {
  std::vector<std::size_t> elements(som.input_size());
  std::iota(elements.begin(), elements.end(), std::size_t{0});
  if (sorting == PlaneSorting::kLikeness) elements = order_planes(som).order;
  std::erase_if(elements, [&](std::size_t element) { return element >= most; });
  return elements;
}

std::optional<ColourLimits> limits_of(const std::vector<std::vector<double>>& planes) {
  if (planes.empty()) return std::nullopt;
  ColourLimits limits{INFINITY, -INFINITY};
  for (const std::vector<double>& plane : planes) {
    const auto [least, greatest] = std::minmax_element(plane.begin(), plane.end());
    limits.least = std::min(limits.least, *least);
    limits.greatest = std::max(limits.greatest, *greatest);
  }
  return limits;
}

}  // namespace

const std::vector<std::pair<PlaneSorting, std::string>>& Choices<PlaneSorting>::all() {
  static const std::vector<std::pair<PlaneSorting, std::string>> all{
      {PlaneSorting::kColumns, "columns"}, {PlaneSorting::kLikeness, "likeness"}};
  return all;
}

const std::vector<std::pair<PlaneScale, std::string>>& Choices<PlaneScale>::all() {
  static const std::vector<std::pair<PlaneScale, std::string>> all{{PlaneScale::kOwn, "own"},
                                                                   {PlaneScale::kCommon, "common"}};
  return all;
}

ValuePanel u_matrix_panel(const Som& som) {
  return value_panel("U-matrix", som, u_matrix(som));
}

EdgePanel u_matrix_edges_panel(const Som& som) {
  return {.title = "U-matrix with edges",
          .grid = som.grid(),
          .values = u_matrix(som),
          .edges = edges_of(som),
          .note =
              "Dots: neurons, with their mean distance from neighbours; between them, the "
              "distance of two neighbours."};
}

std::vector<Panel> component_panels(const Som& som, const std::vector<std::string>& names,
                                    std::size_t most, PlaneSorting sorting, PlaneScale scale) {
  require(names.empty() || names.size() == som.input_size(),
          "component planes need one name per input element");
  const std::vector<std::size_t> elements = drawn_elements(som, most, sorting);
  std::vector<std::vector<double>> planes;
  planes.reserve(elements.size());
  for (const std::size_t i : elements) planes.push_back(component_plane(som, i));
  const auto limits = scale == PlaneScale::kCommon ? limits_of(planes) : std::nullopt;
  std::vector<Panel> panels;
  panels.reserve(planes.size());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const std::size_t element = elements[i];
    ValuePanel panel =
        value_panel(names.empty() ? fmt::format("Component {}", element + 1) : names[element], som,
                    std::move(planes[i]));
    panel.limits = limits;
    panels.emplace_back(std::move(panel));
  }
  return panels;
}

ProjectionPanel projection_panel(const Som& som, const WeightPlane& plane,
                                 const std::vector<Position>& samples, const Classes& classes) {
  require(classes.of_sample.empty() || classes.of_sample.size() == samples.size(),
          "a panel needs a class for each sample");
  ProjectionPanel panel;
  panel.title = "Projection";
  panel.grid = som.grid();
  panel.neurons = plane.neurons();
  panel.note = fmt::format(
      "The first two principal components of the weights, with {:.0f} % (to the right) and {:.0f} "
      "% (upwards) of their variance.",
      100 * plane.shares()[0], 100 * plane.shares()[1]);
  const std::size_t every = (samples.size() + kMostProjectedSamples - 1) / kMostProjectedSamples;
  for (std::size_t i = 0; i < samples.size(); i += every) {
    panel.samples.push_back(samples[i]);
    if (!classes.of_sample.empty()) panel.classes.push_back(classes.of_sample[i]);
  }
  if (!panel.classes.empty()) panel.class_names = classes.names;
  if (every > 1) {
    panel.note += fmt::format(" {} of {} samples are drawn.", panel.samples.size(), samples.size());
  }
  return panel;
}

LabelPanel label_text_panel(const Grid& grid, const NeuronLabels& labels,
                            const std::vector<std::string>& class_names) {
  LabelPanel panel{
      .title = "Label text", .grid = grid, .class_names = class_names, .marks = LabelMarks::kText};
  for (const std::size_t neuron : labels.labelled()) {
    panel.winners.push_back(neuron);
    panel.classes.push_back(*labels[neuron]);
  }
  return panel;
}

TrajectoryPanel trajectory_panel(const Som& som, std::vector<std::size_t> winners,
                                 std::size_t first_number) {
  return {.title = "Trajectory",
          .grid = som.grid(),
          .values = u_matrix(som),
          .winners = std::move(winners),
          .first_number = first_number};
}

Result<Clusters> clusters_by_name(const Som& som, const std::string& text,
                                  const std::string& where) {
  const std::size_t colon = text.find(':');
  ClusterParameters parameters;
  SOMATO_TRY(parameters.method,
             choice_named<ClusterMethod>("method of clustering", text.substr(0, colon), where));
  if (colon != std::string::npos) {
    const char* end = text.data() + text.size();
    std::size_t count = 0;
    const auto [rest, error] = std::from_chars(text.data() + colon + 1, end, count);
    if (error != std::errc() || rest != end || count == 0) {
      return fail(ErrorKind::kUsage,
                  fmt::format("{} is not a number of clusters", shown(text.substr(colon + 1))),
                  where, "use METHOD or METHOD:NUMBER, such as ward:4");
    }
    parameters.count = count;
  }
  auto clusters = cluster_neurons(som, parameters);
  if (!clusters) clusters.error().where = where;
  return clusters;
}

void outline(Panel& panel, const std::vector<std::size_t>& clusters) {
  std::visit(
      [&](auto& one) {
        if constexpr (requires { one.clusters = clusters; }) one.clusters = clusters;
      },
      panel);
}

std::string caption_of(const Grid& grid) {
  if (const NeuronGraph* graph = grid.graph()) {
    return fmt::format("{} neurons with {} connections", graph->size(), graph->edges().size());
  }
  return fmt::format("{} x {} neurons, {} {}", grid.rows(), grid.columns(),
                     choice_name(grid.lattice()), choice_name(grid.topology()));
}

}  // namespace somato
