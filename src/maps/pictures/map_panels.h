#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "maps/reading/weight_plane.h"
#include "somato/core/parameter.h"
#include "somato/drawing/map_picture.h"
#include "somato/maps/labels.h"
#include "somato/maps/som.h"

namespace somato {

/// A panel with the U-matrix of a map (see u_matrix()).
ValuePanel u_matrix_panel(const Som& som);

/// A panel with the U-matrix of a map and the distances of neighbours (neuron_distance()), on a
/// rectangular grid also those of diagonals, divided by the square root of 2.
EdgePanel u_matrix_edges_panel(const Som& som);

/// The order of component planes.
enum class PlaneSorting {
  kColumns,   ///< That of the input elements.
  kLikeness,  ///< That of order_planes(): planes that are alike follow each other.
};

template <>
struct Choices<PlaneSorting> {
  static const std::vector<std::pair<PlaneSorting, std::string>>& all();
};

/// The colours of component planes.
enum class PlaneScale {
  kOwn,     ///< From the least to the greatest value of each plane.
  kCommon,  ///< From the least to the greatest value of all planes that are shown.
};

template <>
struct Choices<PlaneScale> {
  static const std::vector<std::pair<PlaneScale, std::string>>& all();
};

/// Panels with the component planes of the first `most` input elements of a map. `names` are those
/// of all elements; without names the elements are numbered from 1. Throws InvalidArgument if the
/// number of names differs from that of the elements; sorted by likeness as order_planes().
std::vector<Panel> component_panels(const Som& som, const std::vector<std::string>& names,
                                    std::size_t most, PlaneSorting sorting = PlaneSorting::kColumns,
                                    PlaneScale scale = PlaneScale::kOwn);

/// The most samples that projection_panel() draws.
constexpr std::size_t kMostProjectedSamples = 4000;

/// A panel with the grid of a map in the plane of the first two principal components of its
/// weights, and samples at their positions in it, of which `classes` has the classes unless it is
/// empty. Of many samples, every second, third or nth one is drawn, as the note says.
ProjectionPanel projection_panel(const Som& som, const WeightPlane& plane,
                                 const std::vector<Position>& samples, const Classes& classes);

/// A panel with the name of the class of each neuron.
LabelPanel label_text_panel(const Grid& grid, const NeuronLabels& labels,
                            const std::vector<std::string>& class_names);

/// A panel with a trajectory over the U-matrix of a map.
TrajectoryPanel trajectory_panel(const Som& som, std::vector<std::size_t> winners,
                                 std::size_t first_number);

/// The clusters of a map's neurons by METHOD or METHOD:NUMBER, such as "ward:4"
/// (cluster_neurons()). Errors (kUsage), at `where`: an unknown method, a number that is not one,
/// and those of cluster_neurons().
Result<Clusters> clusters_by_name(const Som& som, const std::string& text,
                                  const std::string& where);

/// Sets the clusters that a panel outlines.
void outline(Panel& panel, const std::vector<std::size_t>& clusters);

/// The caption of a picture of a map: "15 x 15 neurons, rectangular plane".
std::string caption_of(const Grid& grid);

}  // namespace somato
