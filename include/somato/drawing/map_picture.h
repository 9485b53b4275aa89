#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "somato/maps/grid.h"

namespace somato {

/// A map with one value a neuron as the colour of its cell, over a colour bar: a U-matrix, hits,
/// a component plane.
struct ValuePanel {
  std::string title{};
  Grid grid{};
  std::vector<double> values{};  ///< One a neuron, all finite.
  bool write_values = false;  ///< Write the values other than 0 into their cells, where they fit.
  std::string note{};         ///< Below the map; may be empty.
};

/// A panel of how many samples each neuron wins, with the numbers written in.
ValuePanel hits_panel(const Grid& grid, const std::vector<std::size_t>& hits);

/// A map with its samples marked where they are won, by the shape and colour of their class, and a
/// legend. The samples of a neuron stand side by side; where they do not fit, one marker a class
/// stands with their number. Won cells are filled with the colour of most of their samples
/// (NeuronLabels::by_majority), the others lighter, by their area (WinnerAreas).
struct LabelPanel {
  std::string title{};
  Grid grid{};
  std::vector<std::string> class_names{};  ///< By class number; any text.
  std::vector<std::size_t> winners{};      ///< The winner of each sample.
  std::vector<std::size_t> classes{};      ///< The class number of each sample.
  bool show_areas = true;                  ///< Fill and outline the areas of the classes.
  std::string note{};                      ///< Below the map; may be empty.
};

using Panel = std::variant<ValuePanel, LabelPanel>;

/// The panels side by side, in up to four columns, under a title and a caption (may be empty), as
/// a standalone SVG picture. Cells are squares on a rectangular and hexagons on a hexagonal grid;
/// their size adapts to the grid. Up to 50 x 50 neurons every cell has a tooltip. A grid of 200 x
/// 200 takes about 3 MB a panel. Panels of a torus say that opposite edges join.
///
/// Throws InvalidArgument without panels; when a panel has no neurons, or not one value a neuron,
/// or a value that is not finite; when winners and classes differ in number, a winner is not on the
/// grid or a class has no name.
std::string draw_picture(const std::string& title, const std::string& caption,
                         const std::vector<Panel>& panels);

}  // namespace somato
