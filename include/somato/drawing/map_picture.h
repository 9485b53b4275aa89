#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "somato/maps/clusters.h"
#include "somato/maps/grid.h"

namespace somato {

/// The values of the first and of the last colour of a panel.
struct ColourLimits {
  double least = 0.0;
  double greatest = 0.0;
};

/// A map with one value per neuron, shown by the colour of its cell, above a colour bar: a
/// U-matrix, hits, a component plane.
struct ValuePanel {
  std::string title{};
  Grid grid{};
  std::vector<double> values{};  ///< One per neuron, all finite.
  bool write_values = false;  ///< Whether non-zero values are written in their cells if they fit.
  std::string note{};         ///< Below the map; may be empty.
  std::vector<std::size_t> clusters{};   ///< The cluster of each neuron, outlined; empty: none.
  std::optional<ColourLimits> limits{};  ///< None: the least and the greatest value.
};

/// A panel with the number of samples that each neuron wins, written in its cell.
ValuePanel hits_panel(const Grid& grid, const std::vector<std::size_t>& hits);

/// The distance of two neurons.
struct EdgeValue {
  std::size_t first = 0;
  std::size_t second = 0;
  double value = 0.0;
};

/// An expanded U-matrix (Ultsch and Siemon 1990): between the cells of two neighbours is a cell
/// with the value of the edge between them, and neurons are marked by a dot. Cells of all values
/// that have the same place have their mean: on a rectangular grid, the two diagonals of four
/// neurons. On a torus, edges across its border are at the right and at the bottom. On a graph, the
/// edges are lines between the cells.
struct EdgePanel {
  std::string title{};
  Grid grid{};
  std::vector<double> values{};    ///< One per neuron, all finite.
  std::vector<EdgeValue> edges{};  ///< Finite values of neurons that are at most a diagonal apart.
  std::string note{};              ///< Below the map; may be empty.
  std::vector<std::size_t> clusters{};  ///< As of a ValuePanel.
};

/// The marks of the classes in a cell of a LabelPanel.
enum class LabelMarks {
  kSamples,  ///< A marker for each sample.
  kPies,     ///< A pie chart with the share of each class among the samples that the neuron wins.
  kText,     ///< The name of the class that most samples have.
};

/// A map with the classes of the samples at their winners, and a legend. Cells of winners are
/// filled with the colour of the majority of their samples (NeuronLabels::by_majority), the others
/// with a lighter colour according to their area (WinnerAreas).
///
/// Markers have the shape and colour of a class. The samples of a neuron are placed side by side;
/// if they do not fit, there is one marker per class with their number. Slices of a pie that are
/// large enough have the marker of their class. Names that do not fit into their cells are replaced
/// by numbers, which the legend explains.
struct LabelPanel {
  std::string title{};
  Grid grid{};
  std::vector<std::string> class_names{};  ///< By class number; any text.
  std::vector<std::size_t> winners{};      ///< The winner of each sample.
  std::vector<std::size_t> classes{};      ///< The class number of each sample.
  bool show_areas = true;  ///< Whether the areas of the classes are filled and outlined.
  std::string note{};      ///< Below the map; may be empty.
  LabelMarks marks = LabelMarks::kSamples;
  bool size_by_hits = false;  ///< Whether the area of a pie is proportional to its samples.
  std::vector<std::size_t> clusters{};  ///< As of a ValuePanel; replaces the outlines of areas.
};

/// A panel with the number of the cluster of each neuron, counted from 1, and the outlines of the
/// clusters. `clusters` has one number per neuron.
LabelPanel clusters_panel(const Grid& grid, const std::vector<std::size_t>& clusters);

/// The most samples of a TrajectoryPanel: more lines over one map cannot be followed.
constexpr std::size_t kMostTrajectorySamples = 1000;

/// The winners of consecutive samples, such as the frames of an exploration, as a line over a map:
/// an arrow for each step to another neuron, whose circle has the number of the sample that has
/// arrived. The first circle is black, the last sample has a black square. Visits of a neuron are
/// side by side; those that have no room are at its middle, without numbers.
struct TrajectoryPanel {
  std::string title{};
  Grid grid{};
  std::vector<double>
      values{};  ///< Shades of grey, darker for greater ones: one per neuron or none.
  std::vector<std::size_t> winners{};   ///< In their order; 1 to kMostTrajectorySamples.
  std::size_t first_number = 1;         ///< The number of the first sample.
  std::string note{};                   ///< Below the map; may be empty.
  std::vector<std::size_t> clusters{};  ///< As of a ValuePanel.
};

/// The grid of a map in a plane: each neuron at a position, with lines between neighbours (dashed
/// across the border of a torus, and between two clusters), and samples as small markers of their
/// classes. Both axes have the same scale.
struct ProjectionPanel {
  std::string title{};
  Grid grid{};
  std::vector<Position> neurons{};         ///< One per neuron, finite; y increases upwards.
  std::vector<Position> samples{};         ///< Finite; may be empty.
  std::vector<std::string> class_names{};  ///< By class number; any text.
  std::vector<std::size_t> classes{};      ///< The class of each sample, or empty.
  std::string note{};                      ///< Below the map; may be empty.
  std::vector<std::size_t> clusters{};     ///< The cluster of each neuron, which gives its marker.
};

/// The tree of the merges of a hierarchical clustering over the distances at which they occur. A
/// dashed line cuts it into the clusters, which have their numbers, counted from 1, and their
/// markers below.
struct DendrogramPanel {
  std::string title{};
  Clusters clusters{};
  std::string note{};  ///< Below the tree; may be empty.
};

/// One of the maps of a picture.
using Panel = std::variant<ValuePanel, LabelPanel, EdgePanel, TrajectoryPanel, ProjectionPanel,
                           DendrogramPanel>;

/// The panels in up to four columns, below a title and above a caption (which may be empty), as a
/// standalone SVG picture. Cells are squares on a rectangular and regular hexagons on a hexagonal
/// grid; their size depends on the grid. Up to 50 x 50 neurons every cell has a tooltip. A grid of
/// 200 x 200 takes about 3 MB per panel. Panels of a torus state that opposite edges join. Nothing
/// is distinguished by its hue only.
///
/// Throws InvalidArgument without panels; if a panel has no neurons, not one value per neuron, or a
/// value that is not finite; if the numbers of winners and classes differ, a winner is not on the
/// grid or a class has no name; if there are clusters, but not one for each neuron; if an edge
/// connects neurons that are not beside each other; if the merges are not those of a tree of all
/// neurons.
std::string draw_picture(const std::string& title, const std::string& caption,
                         const std::vector<Panel>& panels);

}  // namespace somato
