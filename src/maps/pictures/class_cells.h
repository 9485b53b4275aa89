#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "maps/pictures/cells.h"
#include "maps/svg/colours.h"
#include "somato/drawing/map_picture.h"

namespace somato {

/// The number of samples of each class that a neuron wins, by class number.
using Won = std::map<std::size_t, std::size_t>;

std::size_t samples_of(const Won& won);

/// The name of a class in a tooltip.
std::string tooltip_name(const LabelPanel& panel, std::size_t class_number);

/// The least radius of a circle that contains a number, in pixels.
constexpr double kLeastNumberedRadius = 4.5;

/// Places for markers in an upright square, row after row.
class MarkerSquare {
 public:
  MarkerSquare(std::size_t markers, double side) : markers_(markers) {
    while (columns_ * columns_ < markers) ++columns_;
    spacing_ = side / real(columns_);
  }

  double spacing() const { return spacing_; }

  /// The offset of a marker from the middle of the square; short rows are centred.
  Point offset(std::size_t marker) const {
    const std::size_t row = marker / columns_;
    const std::size_t rows = (markers_ + columns_ - 1) / columns_;
    const std::size_t in_row = std::min(columns_, markers_ - row * columns_);
    return {spacing_ * (real(marker % columns_) - 0.5 * (real(in_row) - 1)),
            spacing_ * (real(row) - 0.5 * (real(rows) - 1))};
  }

 private:
  std::size_t markers_;
  std::size_t columns_ = 1;
  double spacing_ = 0.0;
};

/// Draws a pie for each neuron that wins samples.
void draw_pies(SvgWriter& svg, const LabelPanel& panel, const Cells& cells, Point corner,
               const std::vector<Won>& won);

/// Draws the text of the class of each neuron with one, in a colour that can be read on its fill.
/// `texts` are by class number.
void draw_texts(SvgWriter& svg, const Cells& cells, Point corner,
                const std::vector<std::optional<std::size_t>>& class_of_neuron,
                const std::vector<std::string>& texts, const std::vector<Colour>& fills);

/// Whether all names can be written into cells, in several lines.
bool fit_in_cells(const std::vector<std::string>& names, const Cells& cells);

}  // namespace somato
