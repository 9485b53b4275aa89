#include "maps/pictures/dendrogram_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "maps/svg/colour_bar.h"
#include "maps/svg/text_layout.h"
#include "somato/core/check.h"

namespace somato {
namespace {

constexpr double kAxis = 46.0;  // left of the tree
constexpr double kTreeWidth = kMapSide - kAxis;
constexpr double kTop = 6.0;
constexpr double kTreeHeight = 240.0;
constexpr double kBarGap = 4.0;
constexpr double kClusterBarHeight = 18.0;
constexpr double kHeightSize = 11.0;

using Merges = std::vector<ClusterMerge>;

// The leaves from left to right. Without recursion: a tree may be as deep as it has leaves.
std::vector<std::size_t> leaves_of(const Merges& merges) {
  const std::size_t neurons = merges.size() + 1;
  std::vector<std::size_t> leaves;
  std::vector<std::size_t> open{2 * merges.size()};
  while (!open.empty()) {
    const std::size_t node = open.back();
    open.pop_back();
    if (node < neurons) {
      leaves.push_back(node);
    } else {
      open.push_back(merges[node - neurons].second);
      open.push_back(merges[node - neurons].first);
    }
  }
  return leaves;
}

// The nodes of a tree in pixels, and the cluster of each, or none.
struct Tree {
  std::vector<std::size_t> leaves;
  std::vector<Point> nodes;
  std::vector<std::optional<std::size_t>> clusters;
  double greatest = 0.0;  // height
};

double y_of(double height, double greatest) {
  return kTop + kTreeHeight * (greatest > 0 ? 1 - height / greatest : 1.0);
}

Tree tree_of(const Clusters& clusters) {
  Tree tree;
  tree.leaves = leaves_of(clusters.merges);
  tree.nodes.resize(tree.leaves.size());
  tree.clusters.assign(clusters.of_neuron.begin(), clusters.of_neuron.end());
  for (const ClusterMerge& merge : clusters.merges) {
    tree.greatest = std::max(tree.greatest, merge.height);
  }
  const double spacing = kTreeWidth / real(tree.leaves.size());
  for (std::size_t i = 0; i < tree.leaves.size(); ++i) {
    tree.nodes[tree.leaves[i]] = {kAxis + spacing * (real(i) + 0.5), kTop + kTreeHeight};
  }
  for (const auto& [first, second, height, neurons] : clusters.merges) {
    tree.nodes.push_back(
        {(tree.nodes[first].x + tree.nodes[second].x) / 2, y_of(height, tree.greatest)});
    const bool is_one = tree.clusters[first] && tree.clusters[first] == tree.clusters[second];
    tree.clusters.push_back(is_one ? tree.clusters[first] : std::nullopt);
  }
  return tree;
}

void draw_merges(SvgWriter& svg, const Clusters& clusters, const Tree& tree) {
  std::vector<Point> inside;
  std::vector<Point> between;
  const std::size_t neurons = clusters.of_neuron.size();
  for (std::size_t i = 0; i < clusters.merges.size(); ++i) {
    const Point top = tree.nodes[neurons + i];
    const Point first = tree.nodes[clusters.merges[i].first];
    const Point second = tree.nodes[clusters.merges[i].second];
    std::vector<Point>& ends = tree.clusters[neurons + i] ? inside : between;
    ends.insert(
        ends.end(),
        {first, {first.x, top.y}, {first.x, top.y}, {second.x, top.y}, {second.x, top.y}, second});
  }
  svg.open_group("merges", {}, {.fill = "none", .stroke = "#111111"});
  const double width = std::clamp(kTreeWidth / real(neurons) / 4, 0.4, 1.6);
  if (!inside.empty()) svg.segments(inside, {.stroke_width = width});
  if (!between.empty()) svg.segments(between, {.stroke = "#777777", .stroke_width = 1.2});
  svg.close_group();
}

// The height between the merges within clusters and those of clusters, if there is one.
std::optional<double> cut_of(const Clusters& clusters, const Tree& tree) {
  double inside = 0.0;
  double between = INFINITY;
  for (std::size_t i = 0; i < clusters.merges.size(); ++i) {
    const double height = clusters.merges[i].height;
    if (tree.clusters[clusters.of_neuron.size() + i]) {
      inside = std::max(inside, height);
    } else {
      between = std::min(between, height);
    }
  }
  if (!(inside < between) || std::isinf(between)) return std::nullopt;
  return inside / 2 + between / 2;
}

void draw_cut(SvgWriter& svg, const Clusters& clusters, const Tree& tree) {
  const auto cut = cut_of(clusters, tree);
  if (!cut) return;
  const double y = y_of(*cut, tree.greatest);
  svg.open_group("cut", {}, {.fill = "none"});
  svg.segments({{kAxis, y}, {kAxis + kTreeWidth, y}},
               {.stroke = "#d55e00", .stroke_width = 1.4, .dashes = "6 4"});
  svg.close_group();
}

void draw_axis(SvgWriter& svg, const Tree& tree) {
  constexpr double kLeft = kAxis - 6;
  const double bottom = kTop + kTreeHeight;
  svg.open_group("axis", {}, {.fill = "none", .stroke = "#444444"});
  svg.segments({{kLeft, kTop},
                {kLeft, bottom},
                {kLeft - 4, kTop},
                {kLeft, kTop},
                {kLeft - 4, bottom},
                {kLeft, bottom}},
               {.stroke_width = 0.8});
  svg.close_group();
  svg.open_group("heights");
  svg.text({kLeft - 6, bottom + 4}, "0", {kHeightSize, Anchor::kEnd});
  if (tree.greatest > 0) {
    const std::string number = fmt::format("{:.3g}", tree.greatest);
    svg.text({kLeft - 6, kTop + 4}, number, {kHeightSize, Anchor::kEnd});
  }
  svg.close_group();
}

// A bar below the leaves of each cluster, with its number where there is room.
void draw_clusters(SvgWriter& svg, const Clusters& clusters, const Tree& tree) {
  const double spacing = kTreeWidth / real(tree.leaves.size());
  const double top = kTop + kTreeHeight + kBarGap;
  svg.open_group("clusters", {}, {.stroke = "#111111", .stroke_width = 0.6});
  std::size_t begin = 0;
  while (begin < tree.leaves.size()) {
    const std::size_t cluster = clusters.of_neuron[tree.leaves[begin]];
    std::size_t end = begin;
    while (end < tree.leaves.size() && clusters.of_neuron[tree.leaves[end]] == cluster) ++end;
    const Colour fill = tint(class_mark(cluster).colour, 0.5);
    const double left = kAxis + spacing * real(begin);
    const double width = spacing * real(end - begin);
    svg.rectangle({left, top}, width, kClusterBarHeight, {.fill = to_string(fill)},
                  fmt::format("cluster {}: {} neurons", cluster + 1, end - begin));
    const std::string number = fmt::format("{}", cluster + 1);
    if (text_width(number, kHeightSize) <= width) {
      svg.open_group("", {}, {.stroke = "none"});
      svg.text({left + width / 2, top + 13}, number,
               {kHeightSize, Anchor::kMiddle, false, to_string(readable_on(fill))});
      svg.close_group();
    }
    begin = end;
  }
  svg.close_group();
}

void check(const Clusters& clusters) {
  const std::size_t neurons = clusters.of_neuron.size();
  require(neurons > 0, "a panel needs neurons");
  require(clusters.merges.size() + 1 == neurons,
          "a dendrogram needs one merge less than there are neurons");
  std::vector<bool> is_merged(2 * neurons, false);
  for (std::size_t i = 0; i < clusters.merges.size(); ++i) {
    const auto& [first, second, height, count] = clusters.merges[i];
    require(first != second && std::max(first, second) < neurons + i && !is_merged[first] &&
                !is_merged[second],
            "the merges of a dendrogram are not those of a tree");
    require(std::isfinite(height) && height >= 0,
            "the heights of merges are finite and at least 0");
    is_merged[first] = is_merged[second] = true;
  }
}

std::string note_of(const DendrogramPanel& panel) {
  const std::string text =
      "Distances at which clusters of neurons merge; below, the numbers of the clusters.";
  return panel.note + (panel.note.empty() ? "" : " ") + text;
}

}  // namespace

PanelFrame frame_of(const DendrogramPanel& panel) {
  check(panel.clusters);
  PanelFrame frame =
      make_frame(panel.title, kMapSide, kTop + kTreeHeight + kBarGap + kClusterBarHeight);
  add_note(frame, note_of(panel), Topology::kPlane);
  return frame;
}

void draw_panel(SvgWriter& svg, const PanelFrame& frame, const DendrogramPanel& panel) {
  const Tree tree = tree_of(panel.clusters);
  draw_frame(svg, frame);
  svg.open_group("dendrogram", frame.map_corner());
  draw_axis(svg, tree);
  draw_merges(svg, panel.clusters, tree);
  draw_cut(svg, panel.clusters, tree);
  draw_clusters(svg, panel.clusters, tree);
  svg.close_group();
}

}  // namespace somato
