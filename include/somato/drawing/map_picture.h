#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "somato/maps/grid.h"

namespace somato {

/// A map with one value per neuron, shown by the colour of its cell, above a colour bar: a
/// U-matrix, hits, a component plane.
struct ValuePanel {
  std::string title{};
  Grid grid{};
  std::vector<double> values{};  ///< One per neuron, all finite.
  bool write_values = false;  ///< Whether non-zero values are written in their cells if they fit.
  std::string note{};         ///< Below the map; may be empty.
};

/// A panel with the number of samples that each neuron wins, written in its cell.
ValuePanel hits_panel(const Grid& grid, const std::vector<std::size_t>& hits);

/// A map with a marker for each sample at its winner, with the shape and colour of its class, and a
/// legend. The samples of a neuron are placed side by side; if they do not fit, there is one marker
/// per class with their number. Cells of winners are filled with the colour of the majority of
/// their samples (NeuronLabels::by_majority), the others with a lighter colour according to their
/// area (WinnerAreas).
struct LabelPanel {
  std::string title{};
  Grid grid{};
  std::vector<std::string> class_names{};  ///< By class number; any text.
  std::vector<std::size_t> winners{};      ///< The winner of each sample.
  std::vector<std::size_t> classes{};      ///< The class number of each sample.
  bool show_areas = true;  ///< Whether the areas of the classes are filled and outlined.
  std::string note{};      ///< Below the map; may be empty.
};

/// One of the maps of a picture.
using Panel = std::variant<ValuePanel, LabelPanel>;

/// The panels in up to four columns, below a title and above a caption (which may be empty), as a
/// standalone SVG picture. Cells are squares on a rectangular and hexagons on a hexagonal grid;
/// their size depends on the grid. Up to 50 x 50 neurons every cell has a tooltip. A grid of 200 x
/// 200 takes about 3 MB per panel. Panels of a torus state that opposite edges join.
///
/// Throws InvalidArgument without panels; if a panel has no neurons, not one value per neuron, or a
/// value that is not finite; if the numbers of winners and classes differ, a winner is not on the
/// grid or a class has no name.
std::string draw_picture(const std::string& title, const std::string& caption,
                         const std::vector<Panel>& panels);

}  // namespace somato
