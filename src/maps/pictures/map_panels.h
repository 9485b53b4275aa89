#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "somato/drawing/map_picture.h"
#include "somato/maps/som.h"

namespace somato {

/// A panel with the U-matrix of a map (see u_matrix()).
ValuePanel u_matrix_panel(const Som& som);

/// Panels with the component planes of the first `most` input elements of a map. `names` are those
/// of all elements; without names the elements are numbered from 1. Throws InvalidArgument if the
/// number of names differs from that of the elements.
std::vector<Panel> component_panels(const Som& som, const std::vector<std::string>& names,
                                    std::size_t most);

/// The caption of a picture of a map: "15 x 15 neurons, rectangular plane".
std::string caption_of(const Grid& grid);

}  // namespace somato
