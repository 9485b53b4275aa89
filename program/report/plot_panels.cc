#include "report/plot_panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "base/core/threads.h"
#include "base/text/text.h"
#include "maps/reading/weight_plane.h"
#include "som/data.h"
#include "som/row_data.h"
#include "somato/core/parameter.h"
#include "somato/drawing/map_picture.h"
#include "somato/maps/clusters.h"
#include "terminal/terminal.h"

namespace somato::program {
namespace {

// The data that a panel needs beside the map.
enum class Need { kNothing, kData, kLabels, kLabelNames, kClusters };

struct KnownPanel {
  std::string name;
  Need need = Need::kNothing;
  bool is_usual = false;  // drawn without --panels
};

const std::vector<KnownPanel>& known_panels() {
  static const std::vector<KnownPanel> panels{
      {"u_matrix", Need::kNothing, true},   {"u_matrix_edges"},
      {"hits", Need::kData, true},          {"labels", Need::kLabels, true},
      {"label_text", Need::kLabelNames},    {"pies", Need::kLabels},
      {"components", Need::kNothing, true}, {"clusters", Need::kClusters},
      {"dendrogram", Need::kClusters},      {"projection"},
      {"trajectory", Need::kData}};
  return panels;
}

std::vector<std::string> names_of(bool only_usual) {
  std::vector<std::string> names;
  for (const KnownPanel& panel : known_panels()) {
    if (panel.is_usual || !only_usual) names.push_back(panel.name);
  }
  return names;
}

Need need_of(const std::string& name) {
  const auto& panels = known_panels();
  return std::find_if(panels.begin(), panels.end(),
                      [&](const KnownPanel& panel) { return panel.name == name; })
      ->need;
}

Result<std::vector<std::string>> named_panels(const std::string& text) {
  ParameterInfo info;
  info.name = "panels";
  info.type = "list of choice";
  info.choices = names_of(false);
  const Value value = value_from_text(info, text);
  std::vector<std::string> chosen;
  for (const Value& item : std::get<Value::List>(value.content)) {
    std::size_t choice = 0;
    if (auto read = detail::read_choice(info, item, choice); !read) {
      read.error().where = "--panels";
      return fail(std::move(read.error()));
    }
    chosen.push_back(info.choices[choice]);
  }
  return chosen;
}

bool has_panel(const PlotChoice& choice, const std::string& panel) {
  return std::find(choice.panels.begin(), choice.panels.end(), panel) != choice.panels.end();
}

// Only panels named by --panels can lack something.
Result<void> check_needs(const Arguments& arguments, const std::vector<std::string>& panels) {
  const bool has_data = !data_files(arguments).empty();
  const bool has_labels = arguments.has("labels") || arguments.has("label-column");
  for (const std::string& panel : panels) {
    const Need need = need_of(panel);
    if (need == Need::kData && !has_data) {
      return fail(ErrorKind::kUsage, panel + " cannot be drawn without data", "--panels",
                  "provide DATA");
    }
    if (need == Need::kLabels && !(has_data && has_labels)) {
      return fail(ErrorKind::kUsage, panel + " cannot be drawn without labelled data", "--panels",
                  "use DATA with --labels or --label-column");
    }
  }
  return {};
}

// The flags that change a panel, with their panels.
Result<void> check_effects(const Arguments& arguments, const PlotChoice& choice) {
  const std::pair<std::string, std::string> effects[] = {{"component-order", "components"},
                                                         {"component-scale", "components"},
                                                         {"size-by-hits", "pies"},
                                                         {"trajectory", "trajectory"}};
  for (const auto& [flag, panel] : effects) {
    if (!arguments.has(flag) || has_panel(choice, panel)) continue;
    return fail(ErrorKind::kUsage, fmt::format("has no effect without the panel {}", panel),
                "--" + flag, fmt::format("add {} to --panels", panel));
  }
  return {};
}

template <typename Enum>
Result<Enum> choice_of(const Arguments& arguments, const std::string& flag, Enum otherwise) {
  if (!arguments.has(flag)) return otherwise;
  return choice_named<Enum>("choice", arguments.text(flag), "--" + flag);
}

std::optional<std::size_t> row_number(std::string_view text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

// FIRST..LAST, from 1.
Result<std::pair<std::size_t, std::size_t>> row_range(const std::string& text) {
  const std::size_t dots = text.find("..");
  if (dots != std::string::npos) {
    const auto first = row_number(std::string_view(text).substr(0, dots));
    const auto last = row_number(std::string_view(text).substr(dots + 2));
    if (first && last && *first >= 1 && *first <= *last) return std::pair(*first, *last);
  }
  return fail(ErrorKind::kUsage, fmt::format("{} is not a range of rows", shown(text)),
              "--trajectory", "use FIRST..LAST with numbers from 1, such as 13..24");
}

// The contribution of the rows to panels.
struct ReadRows {
  std::vector<std::size_t> hits;
  std::vector<std::size_t> winners;
  std::vector<Position> positions;  // only for a plane
};

Result<ReadRows> read(const MapAndRows& both, const WeightPlane* plane) {
  const Som& som = both.model.som;
  const Progress progress = both.rows.in_memory() ? Progress() : terminal_progress("measuring");
  PreparedRows prepared(both.model, both.rows);
  SomQualityMeasurement measurement(som, available_threads());
  ReadRows read;
  auto done = for_each_part(prepared.samples(), [&](const Samples& part) -> Result<void> {
    const std::vector<std::size_t> winners = measurement.add(part);
    read.winners.insert(read.winners.end(), winners.begin(), winners.end());
    if (plane != nullptr) {
      const std::vector<Position> positions = plane->positions_of(som, part);
      read.positions.insert(read.positions.end(), positions.begin(), positions.end());
    }
    if (progress && !progress(read.winners.size(), both.rows.own_count)) return reading_stopped();
    return {};
  });
  SOMATO_TRY_VOID(std::move(done));
  read.hits = measurement.quality().hits;
  return read;
}

// Makes the panels one after the other.
class PanelMaker {
 public:
  PanelMaker(const MapAndRows& both, bool has_data, const PlotChoice& choice)
      : both_(both), has_data_(has_data), choice_(choice), som_(both.model.som) {}

  Result<std::vector<Panel>> make() {
    if (has_panel(choice_, "projection")) plane_.emplace(som_);
    if (has_data_) {
      SOMATO_TRY(rows_, read(both_, plane_ ? &*plane_ : nullptr));
    }
    if (!choice_.clusters.empty()) {
      SOMATO_TRY(clusters_, clusters_by_name(som_, choice_.clusters, "--clusters"));
    }
    for (const std::string& panel : choice_.panels) SOMATO_TRY_VOID(add(panel));
    if (!clusters_.of_neuron.empty()) {
      for (Panel& panel : panels_) outline(panel, clusters_.of_neuron);
    }
    return std::move(panels_);
  }

 private:
  Result<void> add(const std::string& panel) {
    if (panel == "u_matrix") {
      panels_.emplace_back(u_matrix_panel(som_));
    } else if (panel == "u_matrix_edges") {
      panels_.emplace_back(u_matrix_edges_panel(som_));
    } else if (panel == "hits" && has_data_) {
      panels_.emplace_back(hits_panel(som_.grid(), rows_.hits));
    } else if (panel == "labels" || panel == "pies") {
      if (has_data_ && both_.rows.labelled()) panels_.emplace_back(labels(panel));
    } else if (panel == "label_text") {
      return add_label_text();
    } else if (panel == "components") {
      for (Panel& plane : component_panels(som_, both_.model.features, choice_.components,
                                           choice_.sorting, choice_.scale)) {
        panels_.push_back(std::move(plane));
      }
    } else if (panel == "clusters") {
      panels_.emplace_back(clusters_panel(som_.grid(), clusters_.of_neuron));
    } else if (panel == "dendrogram") {
      return add_dendrogram();
    } else if (panel == "projection") {
      panels_.emplace_back(projection());
    } else if (panel == "trajectory") {
      return add_trajectory();
    }
    return {};
  }

  LabelPanel labels(const std::string& name) const {
    LabelPanel panel;
    panel.title = name == "labels" ? "Labels" : name == "pies" ? "Classes" : "Label text";
    panel.grid = som_.grid();
    panel.class_names = both_.rows.classes.names;
    panel.winners = rows_.winners;
    panel.classes = both_.rows.classes.of_sample;
    panel.marks = name == "labels" ? LabelMarks::kSamples
                  : name == "pies" ? LabelMarks::kPies
                                   : LabelMarks::kText;
    panel.size_by_hits = choice_.size_by_hits;
    return panel;
  }

  // The classes of the data, or those of the map.
  Result<void> add_label_text() {
    if (has_data_ && both_.rows.labelled()) {
      panels_.emplace_back(labels("label_text"));
      return {};
    }
    if (both_.model.classes.empty()) {
      return fail(ErrorKind::kUsage, "label_text cannot be drawn, because the map has no labels",
                  "--panels", "use DATA with --labels or --label-column");
    }
    panels_.emplace_back(label_text_panel(som_.grid(), both_.model.labels, both_.model.classes));
    return {};
  }

  Result<void> add_dendrogram() {
    if (clusters_.merges.empty() && som_.neurons() > 1) {
      return fail(ErrorKind::kUsage, "a dendrogram needs hierarchical clusters", "--clusters",
                  "use ward");
    }
    panels_.emplace_back(DendrogramPanel{"Dendrogram", clusters_});
    return {};
  }

  ProjectionPanel projection() const {
    const bool labelled = has_data_ && both_.rows.labelled();
    return projection_panel(som_, *plane_, rows_.positions,
                            labelled ? both_.rows.classes : Classes());
  }

  Result<void> add_trajectory() {
    const auto [first, last] =
        choice_.trajectory.value_or(std::pair(std::size_t{1}, rows_.winners.size()));
    if (last > rows_.winners.size()) {
      return fail(ErrorKind::kUsage,
                  fmt::format("the data have {} rows, not {}", rows_.winners.size(), last),
                  "--trajectory", "use a smaller number");
    }
    if (last - first + 1 > kMostTrajectorySamples) {
      return fail(ErrorKind::kUsage,
                  fmt::format("a trajectory of {} rows cannot be followed", last - first + 1),
                  "--trajectory",
                  fmt::format("choose up to {} rows, such as 1..24", kMostTrajectorySamples));
    }
    const auto begin = rows_.winners.begin();
    panels_.emplace_back(trajectory_panel(
        som_,
        {begin + static_cast<std::ptrdiff_t>(first - 1), begin + static_cast<std::ptrdiff_t>(last)},
        first));
    return {};
  }

  const MapAndRows& both_;
  bool has_data_;
  const PlotChoice& choice_;
  const Som& som_;
  std::optional<WeightPlane> plane_;
  ReadRows rows_;
  Clusters clusters_;
  std::vector<Panel> panels_;
};

}  // namespace

std::vector<Flag> plot_panel_flags() {
  return {
      {"--panels", fmt::format("Panels to draw, separated by commas: {}. Default: all possible of "
                               "{}",
                               fmt::join(names_of(false), ", "), fmt::join(names_of(true), ", "))},
      {"--components", "Maximum number of component planes. Default: 12"},
      {"--component-order",
       "Order of component planes: columns, or likeness (correlated planes follow each other). "
       "Default: columns"},
      {"--component-scale",
       "Colours of component planes: own (the range of each plane) or common. Default: own"},
      {"--size-by-hits", "Whether the area of a pie is proportional to its samples", false, false},
      {"--clusters",
       "Clusters of the neurons, outlined in all panels: ward, k_means or watershed, with a number "
       "or one that is chosen, such as ward:4. Default: none, and ward for the panels clusters and "
       "dendrogram"},
      {"--trajectory",
       "Rows of DATA whose winners the panel trajectory connects, such as 13..24. Default: all"}};
}

Result<PlotChoice> read_plot_choice(const Arguments& arguments) {
  PlotChoice choice;
  choice.panels = names_of(true);
  if (arguments.has("panels")) {
    SOMATO_TRY(choice.panels, named_panels(arguments.text("panels")));
    SOMATO_TRY_VOID(check_needs(arguments, choice.panels));
  }
  SOMATO_TRY_VOID(check_effects(arguments, choice));
  SOMATO_TRY(const auto most, arguments.number("components", 0));
  choice.components = most.value_or(choice.components);
  SOMATO_TRY(choice.sorting, choice_of(arguments, "component-order", choice.sorting));
  SOMATO_TRY(choice.scale, choice_of(arguments, "component-scale", choice.scale));
  choice.size_by_hits = arguments.has("size-by-hits");
  if (arguments.has("trajectory")) {
    SOMATO_TRY(choice.trajectory, row_range(arguments.text("trajectory")));
  }
  const bool needs_clusters = has_panel(choice, "clusters") || has_panel(choice, "dendrogram");
  choice.clusters = arguments.has("clusters") ? arguments.text("clusters")
                    : needs_clusters          ? "ward"
                                              : "";
  return choice;
}

Result<std::vector<Panel>> make_plot_panels(const MapAndRows& both, bool has_data,
                                            const PlotChoice& choice) {
  return PanelMaker(both, has_data, choice).make();
}

}  // namespace somato::program
