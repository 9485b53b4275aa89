#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "maps/pictures/cells.h"
#include "maps/svg/svg.h"

namespace somato {

/// Throws InvalidArgument unless there are no clusters or one for each neuron.
void check_clusters(const Grid& grid, const std::vector<std::size_t>& clusters);

/// Draws the outlines between clusters as dark lines with a white rim, which can be seen on all
/// colours; nothing without clusters. `corner` is that of the cells.
void draw_outlines(SvgWriter& svg, const Cells& cells, Point corner,
                   const std::vector<std::size_t>& clusters);

/// The same with the lines, in pairs of ends, around cells `pixels` wide.
void draw_outlines(SvgWriter& svg, double pixels, Point corner, const std::vector<Point>& ends);

/// Cuts a line to a rectangle from (0, 0) to `size`; false if nothing is left (Liang and Barsky, A
/// new concept and method for line clipping, ACM Transactions on Graphics 3, 1984).
bool cut_line(Point& from, Point& to, Point size);

/// Draws a border around the map and between areas, and lines between cells of one area unless they
/// are small. `area` is that of each neuron; empty: all cells are one area.
void draw_borders(SvgWriter& svg, const Cells& cells, Point corner,
                  const std::vector<std::size_t>& area, const std::string& line_colour);

/// Points of Cells in pixels. Lines are scaled here and not by a group, whose scale would draw
/// slanting lines thinner.
std::vector<Point> in_pixels(const Cells& cells, std::vector<Point> points);

}  // namespace somato
