#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "maps/pictures/cells.h"
#include "maps/svg/colours.h"
#include "maps/svg/svg.h"

namespace somato {

/// The common parts of all panels: a title, a map or another drawing, a footer (colour bar or
/// legend) and a note, from top to bottom.
struct PanelFrame {
  std::string title;
  Cells cells;
  double map_width = 0.0;
  double map_height = 0.0;
  double width = 0.0;
  double foot_height = 0.0;
  std::vector<std::string> note_lines;

  Point map_corner() const;
  double foot_top() const;
  double height() const;
};

/// The frame of a panel on `grid`, still without foot and note. Throws InvalidArgument for a grid
/// without neurons.
PanelFrame make_frame(const std::string& title, const Grid& grid);

/// The same with cells `pixels` wide.
PanelFrame make_frame(const std::string& title, const Grid& grid, double pixels);

/// The width of the cells of a panel, in pixels: maps are about kMapSide long, but their cells can
/// be seen and one is not a poster.
double cell_pixels(const Grid& grid);

/// The frame of a drawing without cells.
PanelFrame make_frame(const std::string& title, double width, double height);

/// Adds a note, which also states if the map is a torus.
void add_note(PanelFrame& frame, const std::string& note);
void add_note(PanelFrame& frame, const std::string& note, Topology topology);

/// Draws the title and the note.
void draw_frame(SvgWriter& svg, const PanelFrame& frame);

/// Draws every cell, neuron n filled with `fills[n]`; up to 2500 cells have `tooltip(n)`.
void draw_cells(SvgWriter& svg, const PanelFrame& frame, const std::vector<Colour>& fills,
                const std::function<std::string(std::size_t)>& tooltip);

/// The length of the longer side of a map in pixels, unless its cells would be too large or too
/// small.
constexpr double kMapSide = 480.0;

/// Throws InvalidArgument unless there is a finite value for each neuron.
void check_values(const Grid& grid, const std::vector<double>& values);

/// The place of a neuron for a reader, counted from 1.
std::string place_of(const Grid& grid, std::size_t neuron);

}  // namespace somato
