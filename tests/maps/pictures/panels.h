#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include "maps/pictures/xml.h"
#include "somato/drawing/map_picture.h"

namespace somato::test {

inline Grid grid_of(std::size_t rows, std::size_t columns, Lattice lattice = Lattice::kRectangular,
                    Topology topology = Topology::kPlane) {
  return {rows, columns, lattice, topology};
}

/// Each neuron has its number as its value.
inline ValuePanel counting_panel(const Grid& grid) {
  ValuePanel panel{.title = "Values", .grid = grid};
  for (std::size_t i = 0; i < grid.size(); ++i) panel.values.push_back(static_cast<double>(i));
  return panel;
}

/// The picture of one panel, read back.
inline Element draw(const Panel& panel) {
  const auto root = read_xml(draw_picture("A title", "A caption", {panel}));
  if (!root) throw std::runtime_error("not well formed");
  return *root;
}

/// The only group of that class.
inline Element group(const Element& root, const std::string& name) {
  const auto found = groups(root, name);
  if (found.size() != 1) throw std::runtime_error("not one group " + name);
  return found[0];
}

/// The texts below `root`, in the order of the document.
inline std::vector<std::string> texts(const Element& root) {
  std::vector<std::string> found;
  for (const Element& text : elements(root, "text")) found.push_back(text.text);
  return found;
}

/// Six samples of two classes, won by three neurons.
inline LabelPanel two_classes() {
  return {.title = "Classes",
          .grid = grid_of(3, 4),
          .class_names = {"ball", "block"},
          .winners = {0, 0, 0, 11, 11, 5},
          .classes = {0, 0, 1, 1, 1, 0}};
}

}  // namespace somato::test
