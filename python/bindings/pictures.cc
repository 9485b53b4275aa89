#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "errors.h"
#include "map.h"
#include "maps/pictures/expanded_grid.h"
#include "maps/pictures/map_panels.h"
#include "maps/pictures/outlines.h"
#include "maps/reading/weight_plane.h"
#include "nanobind/stl/optional.h"
#include "nanobind/stl/string.h"
#include "nanobind/stl/vector.h"
#include "somato/maps/som_quality.h"
#include "views/skins/layout_file.h"
#include "views/skins/skin_picture.h"
#include "views/skins/weights_picture.h"

namespace somato::python {
namespace {

namespace nb = nanobind;

using Table2 = nb::ndarray<const double, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

/// A picture of a map, panel by panel, as 'somato som plot' draws it. Keeps the map alive.
class MapPicture {
 public:
  explicit MapPicture(const Map& map) : model_(map.model()) {}

  void add_u_matrix() { panels_.emplace_back(u_matrix_panel(model_.som)); }

  void add_hits(const Numbers<std::int64_t>& hits) {
    panels_.emplace_back(hits_panel(grid(), sizes(hits)));
  }

  void add_u_matrix_edges() { panels_.emplace_back(u_matrix_edges_panel(model_.som)); }

  /// `marks` is "labels", "pies" or "label_text".
  void add_labels(const std::vector<std::string>& names, const Numbers<std::int64_t>& winners,
                  const Numbers<std::int64_t>& classes, const std::string& marks,
                  bool size_by_hits) {
    LabelPanel panel;
    panel.title = marks == "labels" ? "Labels" : marks == "pies" ? "Classes" : "Label text";
    panel.grid = grid();
    panel.class_names = names;
    panel.winners = sizes(winners);
    panel.classes = sizes(classes);
    panel.marks = marks == "labels" ? LabelMarks::kSamples
                  : marks == "pies" ? LabelMarks::kPies
                                    : LabelMarks::kText;
    panel.size_by_hits = size_by_hits;
    panels_.emplace_back(std::move(panel));
  }

  /// The names of the neurons that the map has.
  void add_label_text() {
    panels_.emplace_back(label_text_panel(grid(), model_.labels, model_.classes));
  }

  void add_components(std::size_t most, const std::string& order, const std::string& scale) {
    const auto sorting =
        value_or_throw(choice_named<PlaneSorting>("order", order, "component_order"));
    const auto colours =
        value_or_throw(choice_named<PlaneScale>("scale", scale, "component_scale"));
    for (Panel& panel : component_panels(model_.som, model_.features, most, sorting, colours)) {
      panels_.push_back(std::move(panel));
    }
  }

  void add_clusters(const Numbers<std::int64_t>& clusters) {
    panels_.emplace_back(clusters_panel(grid(), sizes(clusters)));
  }

  /// Rows of a linkage matrix: two clusters, height and size.
  void add_dendrogram(const Numbers<std::int64_t>& clusters, const Table2& merges) {
    DendrogramPanel panel;
    panel.title = "Dendrogram";
    panel.clusters.of_neuron = sizes(clusters);
    for (std::size_t i = 0; i < merges.shape(0); ++i) {
      panel.clusters.merges.push_back({static_cast<std::size_t>(merges(i, 0)),
                                       static_cast<std::size_t>(merges(i, 1)), merges(i, 2),
                                       static_cast<std::size_t>(merges(i, 3))});
    }
    panels_.emplace_back(std::move(panel));
  }

  /// `positions` are those of samples, which have classes or none.
  void add_projection(const Table2& positions, const std::vector<std::string>& names,
                      const Numbers<std::int64_t>& classes) {
    std::vector<Position> samples;
    for (std::size_t i = 0; i < positions.shape(0); ++i) {
      samples.push_back({positions(i, 0), positions(i, 1)});
    }
    panels_.emplace_back(projection_panel(model_.som, WeightPlane(model_.som), samples,
                                          Classes{names, sizes(classes)}));
  }

  void add_trajectory(const Numbers<std::int64_t>& winners, std::size_t first_number) {
    panels_.emplace_back(trajectory_panel(model_.som, sizes(winners), first_number));
  }

  /// Outlines clusters in all panels so far.
  void outline(const Numbers<std::int64_t>& clusters) {
    for (Panel& panel : panels_) somato::outline(panel, sizes(clusters));
  }

  std::string svg(const std::string& title) const {
    return draw_picture(title, caption_of(grid()), panels_);
  }

 private:
  const Grid& grid() const { return model_.som.grid(); }

  SomModel model_;
  std::vector<Panel> panels_;
};

nb::object plane(const Map& map, std::size_t element) {
  return array_of(component_plane(map.model().som, element));
}

/// The cluster of each neuron, and the linkage matrix or None.
nb::tuple clusters_of(const Map& map, const std::string& method) {
  const Clusters clusters = value_or_throw(clusters_by_name(map.model().som, method, "clusters"));
  nb::object merges = nb::none();
  if (!clusters.merges.empty() || map.model().som.neurons() == 1) {
    std::vector<double> values;
    for (const auto& [first, second, height, neurons] : clusters.merges) {
      values.insert(values.end(), {static_cast<double>(first), static_cast<double>(second), height,
                                   static_cast<double>(neurons)});
    }
    const std::size_t shape[] = {clusters.merges.size(), 4};
    merges = array_of(std::move(values), shape);
  }
  return nb::make_tuple(integers(clusters.of_neuron), merges);
}

/// The corners of the cells with a value of an expanded U-matrix, in widths of a neuron's cell as
/// Map::cells(), and their values.
nb::tuple edge_cells(const Map& map) {
  if (map.model().som.grid().graph() != nullptr) {
    throw Failure{Error{ErrorKind::kUsage,
                        "the map has no rows and columns, and so no expanded cells",
                        "u_matrix_edges", "use draw, which shows the edges of a graph"}};
  }
  const EdgePanel panel = u_matrix_edges_panel(map.model().som);
  const ExpandedGrid expanded(panel.grid);
  const ExpandedValues all = expanded_values(expanded, panel);
  const Cells fine(expanded.fine(), 0.5);
  const Point first = fine.centre(expanded.cell_of(0));
  const Point of_neuron = Cells(panel.grid, 1.0).centre(0);
  std::vector<double> corners;
  std::vector<double> values;
  std::size_t sides = 0;
  for (std::size_t i = 0; i < all.values.size(); ++i) {
    if (!all.values[i]) continue;
    values.push_back(*all.values[i]);
    const std::vector<Point> points = in_pixels(fine, fine.corners(i));
    sides = points.size();
    for (const Point& point : points) {
      corners.push_back(point.x - first.x + of_neuron.x);
      corners.push_back(point.y - first.y + of_neuron.y);
    }
  }
  const std::size_t shape[] = {values.size(), sides, 2};
  return nb::make_tuple(array_of(std::move(corners), shape), array_of(std::move(values)));
}

/// The lines between clusters: (lines, 2, 2), in widths of a cell.
nb::object outlines_of(const Map& map, const Numbers<std::int64_t>& clusters) {
  const Grid& grid = map.model().som.grid();
  check_clusters(grid, sizes(clusters));
  const Cells cells(grid, 1.0);
  std::vector<double> ends;
  for (const Point& end : in_pixels(cells, cells.borders(sizes(clusters)).between_areas)) {
    ends.insert(ends.end(), {end.x, end.y});
  }
  const std::size_t shape[] = {ends.size() / 4, 2, 2};
  return array_of(std::move(ends), shape);
}

/// The coordinates of the neurons in the plane of the principal components, the shares of the
/// variance, and the pairs of neighbours.
nb::tuple projection(const Map& map) {
  const Som& som = map.model().som;
  const WeightPlane plane(som);
  std::vector<double> coordinates;
  std::vector<std::int64_t> pairs;
  for (std::size_t i = 0; i < som.neurons(); ++i) {
    coordinates.insert(coordinates.end(), {plane.neurons()[i].x, plane.neurons()[i].y});
    for (const std::size_t other : som.grid().neighbours(i)) {
      if (other < i) continue;
      pairs.push_back(static_cast<std::int64_t>(i));
      pairs.push_back(static_cast<std::int64_t>(other));
    }
  }
  const std::size_t of_neurons[] = {som.neurons(), 2};
  const std::size_t of_pairs[] = {pairs.size() / 2, 2};
  return nb::make_tuple(array_of(std::move(coordinates), of_neurons),
                        nb::make_tuple(plane.shares()[0], plane.shares()[1]),
                        array_of(std::move(pairs), of_pairs));
}

SkinInputs skin_inputs(const Map& map, const std::string& layout) {
  const SomModel& model = map.model();
  return value_or_throw(
      inputs_on_skin(model.som, model.features, value_or_throw(read_layout(layout))));
}

std::string weights_on_skin(const Map& map, const std::string& layout,
                            std::optional<std::size_t> neuron, const std::string& title) {
  return value_or_throw(draw_weights(map.model().som, skin_inputs(map, layout), neuron, title));
}

/// The input of each element, and its x and y in mm.
nb::tuple places_of_inputs(const Map& map, const std::string& layout) {
  const SkinInputs elements = skin_inputs(map, layout);
  std::vector<double> x;
  std::vector<double> y;
  for (const Point& place : elements.skin.places) {
    x.push_back(place.x);
    y.push_back(place.y);
  }
  return nb::make_tuple(elements.inputs, x, y);
}

/// Frames of a channel, drawn side by side.
class Skin {
 public:
  Skin(std::string title, const std::vector<std::string>& element_names,
       const std::vector<std::size_t>& shape, const std::string& unit, double least,
       double greatest) {
    picture_.title = std::move(title);
    picture_.element_names = element_names;
    picture_.shape = shape;
    picture_.unit = unit;
    picture_.least = least;
    picture_.greatest = greatest;
  }

  void add_frame(const std::string& title, const Numbers<float>& values,
                 const Numbers<std::uint8_t>& valid) {
    picture_.frames.push_back({title,
                               {values.data(), values.data() + values.size()},
                               {valid.data(), valid.data() + valid.size()}});
  }

  /// Places of the elements from a layout file.
  void place(const std::string& layout, const std::string& channel) {
    const auto places = value_or_throw(read_layout(layout));
    std::vector<std::string> channels;
    for (const ChannelPlaces& one : places) {
      channels.push_back(one.channel);
      if (one.channel == channel) {
        picture_.places = value_or_throw(places_for(one, names()));
      }
    }
    if (!picture_.places) throw Failure{unknown_name("channel", channel, layout, channels)};
  }

  std::string svg() const { return draw_skin(picture_); }

 private:
  // Elements without names have numbers.
  std::vector<std::string> names() const {
    if (!picture_.element_names.empty()) return picture_.element_names;
    std::size_t count = 1;
    for (const std::size_t length : picture_.shape) count *= length;
    std::vector<std::string> numbers;
    for (std::size_t i = 0; i < count; ++i) numbers.push_back(std::to_string(i + 1));
    return numbers;
  }

  SkinPicture picture_;
};

}  // namespace

void bind_pictures(nb::module_& module) {
  nb::class_<MapPicture>(module, "MapPicture", "A picture of a map, panel by panel.")
      .def(nb::init<const Map&>(), nb::arg("map"))
      .def("add_u_matrix", &MapPicture::add_u_matrix)
      .def("add_hits", &MapPicture::add_hits, nb::arg("hits").noconvert())
      .def("add_u_matrix_edges", &MapPicture::add_u_matrix_edges)
      .def("add_labels", &MapPicture::add_labels, nb::arg("names"), nb::arg("winners").noconvert(),
           nb::arg("classes").noconvert(), nb::arg("marks"), nb::arg("size_by_hits"))
      .def("add_label_text", &MapPicture::add_label_text)
      .def("add_components", &MapPicture::add_components, nb::arg("most"), nb::arg("order"),
           nb::arg("scale"))
      .def("add_clusters", &MapPicture::add_clusters, nb::arg("clusters").noconvert())
      .def("add_dendrogram", &MapPicture::add_dendrogram, nb::arg("clusters").noconvert(),
           nb::arg("merges").noconvert())
      .def("add_projection", &MapPicture::add_projection, nb::arg("positions").noconvert(),
           nb::arg("names"), nb::arg("classes").noconvert())
      .def("add_trajectory", &MapPicture::add_trajectory, nb::arg("winners").noconvert(),
           nb::arg("first_number"))
      .def("outline", &MapPicture::outline, nb::arg("clusters").noconvert())
      .def("svg", &MapPicture::svg, nb::arg("title"));
  module.def("component_plane", &plane, nb::arg("map"), nb::arg("element"));
  module.attr("most_trajectory_samples") = kMostTrajectorySamples;
  module.def("named_clusters", &clusters_of, nb::arg("map"), nb::arg("method"));
  module.def("edge_cells", &edge_cells, nb::arg("map"));
  module.def("outlines", &outlines_of, nb::arg("map"), nb::arg("clusters").noconvert());
  module.def("projection", &projection, nb::arg("map"));
  module.def("weights_on_skin", &weights_on_skin, nb::arg("map"), nb::arg("layout"),
             nb::arg("neuron").none(), nb::arg("title"));
  module.def("places_of_inputs", &places_of_inputs, nb::arg("map"), nb::arg("layout"));
  nb::class_<Skin>(module, "Skin", "Frames of a channel, drawn side by side.")
      .def(nb::init<std::string, const std::vector<std::string>&, const std::vector<std::size_t>&,
                    const std::string&, double, double>(),
           nb::arg("title"), nb::arg("element_names"), nb::arg("shape"), nb::arg("unit"),
           nb::arg("least"), nb::arg("greatest"))
      .def("add_frame", &Skin::add_frame, nb::arg("title"), nb::arg("values").noconvert(),
           nb::arg("valid").noconvert())
      .def("place", &Skin::place, nb::arg("layout"), nb::arg("channel"))
      .def("svg", &Skin::svg);
}

}  // namespace somato::python
