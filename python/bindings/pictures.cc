#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "bindings.h"
#include "errors.h"
#include "map.h"
#include "maps/pictures/layout_file.h"
#include "maps/pictures/map_panels.h"
#include "maps/pictures/skin_picture.h"
#include "maps/pictures/weights_picture.h"
#include "nanobind/stl/optional.h"
#include "nanobind/stl/string.h"
#include "nanobind/stl/vector.h"
#include "somato/maps/som_quality.h"

namespace somato::python {
namespace {

namespace nb = nanobind;

/// A picture of a map, panel by panel, as 'somato som plot' draws it. Keeps the map alive.
class MapPicture {
 public:
  explicit MapPicture(const Map& map) : model_(map.model()) {}

  void add_u_matrix() { panels_.emplace_back(u_matrix_panel(model_.som)); }

  void add_hits(const Numbers<std::int64_t>& hits) {
    panels_.emplace_back(hits_panel(grid(), sizes(hits)));
  }

  void add_labels(const std::vector<std::string>& names, const Numbers<std::int64_t>& winners,
                  const Numbers<std::int64_t>& classes) {
    LabelPanel panel;
    panel.title = "Labels";
    panel.grid = grid();
    panel.class_names = names;
    panel.winners = sizes(winners);
    panel.classes = sizes(classes);
    panels_.emplace_back(std::move(panel));
  }

  void add_components(std::size_t most) {
    for (Panel& panel : component_panels(model_.som, model_.features, most)) {
      panels_.push_back(std::move(panel));
    }
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
      .def("add_labels", &MapPicture::add_labels, nb::arg("names"), nb::arg("winners").noconvert(),
           nb::arg("classes").noconvert())
      .def("add_components", &MapPicture::add_components, nb::arg("most"))
      .def("svg", &MapPicture::svg, nb::arg("title"));
  module.def("component_plane", &plane, nb::arg("map"), nb::arg("element"));
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
