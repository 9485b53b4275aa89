#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "column_report.h"
#include "commands.h"
#include "data.h"
#include "map_and_rows.h"
#include "memory_flag.h"
#include "somato/drawing/map_picture.h"
#include "somato/files/whole_file.h"
#include "somato/maps/som_quality.h"

namespace somato::program {
namespace {

const std::vector<std::string> kPanels{"u_matrix", "hits", "labels", "components"};

// The panels that --panels names, or all that the arguments allow.
Result<std::vector<std::string>> chosen_panels(const Arguments& arguments) {
  ParameterInfo info;
  info.name = "panels";
  info.type = "list of choice";
  info.choices = kPanels;
  if (!arguments.has("panels")) return kPanels;
  const Value value = value_from_text(info, arguments.text("panels"));
  std::vector<std::string> chosen;
  for (const Value& item : std::get<Value::List>(value.content)) {
    std::size_t choice = 0;
    if (auto read = detail::read_choice(info, item, choice); !read) {
      read.error().where = "--panels";
      return fail(std::move(read.error()));
    }
    chosen.push_back(kPanels[choice]);
  }
  return chosen;
}

bool wants(const std::vector<std::string>& chosen, const std::string& panel) {
  return std::find(chosen.begin(), chosen.end(), panel) != chosen.end();
}

Result<void> check_data_flags(const Arguments& arguments) {
  if (arguments.has("DATA")) return {};
  for (const Flag& flag : data_flags()) {
    if (!arguments.has(key_of(flag.name))) continue;
    return fail(ErrorKind::kUsage, "has no effect without data", flag.name, "give DATA");
  }
  return {};
}

// Only what was asked for by name can be missed.
Result<void> check_panels(const Arguments& arguments, const std::vector<std::string>& chosen) {
  if (!arguments.has("panels")) return {};
  const bool labelled = arguments.has("labels") || arguments.has("label-column");
  if (wants(chosen, "hits") && !arguments.has("DATA")) {
    return fail(ErrorKind::kUsage, "hits cannot be drawn without data", "--panels", "give DATA");
  }
  if (wants(chosen, "labels") && !(labelled && arguments.has("DATA"))) {
    return fail(ErrorKind::kUsage, "labels cannot be drawn without labelled data", "--panels",
                "give DATA with --labels or --label-column");
  }
  return {};
}

ValuePanel value_panel(std::string title, const Som& som, std::vector<double> values) {
  ValuePanel panel;
  panel.title = std::move(title);
  panel.grid = som.grid();
  panel.values = std::move(values);
  return panel;
}

Result<void> add_data_panels(const MapAndRows& both, const std::vector<std::string>& chosen,
                             std::vector<Panel>& panels) {
  const Som& som = both.model.som;
  auto quality = measure_rows(both.model, both.rows, 1);
  if (!quality) return fail(std::move(quality.error()));
  if (wants(chosen, "hits")) panels.emplace_back(hits_panel(som.grid(), quality->hits));
  if (!wants(chosen, "labels") || !both.rows.labelled()) return {};
  LabelPanel panel;
  panel.title = "Labels";
  panel.grid = som.grid();
  panel.class_names = both.rows.classes.names;
  panel.winners = std::move(quality->winners);
  panel.classes = both.rows.classes.of_sample;
  panels.emplace_back(std::move(panel));
  return {};
}

void add_components(const SomModel& model, std::size_t most, std::vector<Panel>& panels) {
  for (std::size_t i = 0; i < std::min(most, model.som.input_size()); ++i) {
    const std::string title =
        model.features.empty() ? fmt::format("Component {}", i + 1) : model.features[i];
    panels.emplace_back(value_panel(title, model.som, component_plane(model.som, i)));
  }
}

Result<MapAndRows> read_map_and_perhaps_rows(const Arguments& arguments) {
  if (arguments.has("DATA")) return read_map_and_rows(arguments);
  auto model = load_som_model(arguments.text("MAP"));
  if (!model) return fail(std::move(model.error()));
  return MapAndRows{std::move(*model), {}};
}

// Pictures are SVG whatever their file is called: a name that says otherwise is a mistake.
Result<void> check_ending(const std::string& output) {
  const std::string ending = std::filesystem::path(output).extension().string();
  for (const char* other : {".png", ".pdf", ".jpg", ".jpeg", ".eps"}) {
    if (ending != other) continue;
    return fail(ErrorKind::kUsage, fmt::format("the picture is SVG, not {}", ending.substr(1)),
                output, "name it .svg; browsers and Inkscape save it otherwise");
  }
  return {};
}

Result<void> plot(const Arguments& arguments) {
  if (auto fits = check_ending(arguments.text("output")); !fits) return fits;
  auto chosen = chosen_panels(arguments);
  if (!chosen) return fail(std::move(chosen.error()));
  auto most = arguments.number("components", 0);
  if (!most) return fail(std::move(most.error()));
  if (auto usable = check_panels(arguments, *chosen); !usable) return usable;
  if (auto usable = check_data_flags(arguments); !usable) return usable;
  auto both = read_map_and_perhaps_rows(arguments);
  if (!both) return fail(std::move(both.error()));
  const Som& som = both->model.som;
  std::vector<Panel> panels;
  if (wants(*chosen, "u_matrix")) {
    panels.emplace_back(value_panel("U-matrix", som, u_matrix(som)));
  }
  if (arguments.has("DATA")) {
    if (auto added = add_data_panels(*both, *chosen, panels); !added) return added;
  }
  if (wants(*chosen, "components")) add_components(both->model, most->value_or(12), panels);
  if (panels.empty()) {
    return fail(ErrorKind::kUsage, "there is nothing to draw", "--panels",
                "name a panel, or give --components more than 0");
  }
  const std::string title = std::filesystem::path(arguments.text("MAP")).filename().string();
  const std::string caption =
      fmt::format("{} x {} neurons, {} {}", som.grid().rows(), som.grid().columns(),
                  choice_name(som.grid().lattice()), choice_name(som.grid().topology()));
  return save_whole(arguments.text("output"), draw_picture(title, caption, panels)).map([&] {
    if (arguments.has("DATA")) note_columns_and_filled(both->rows);
  });
}

}  // namespace

Command som_plot_command() {
  std::vector<Flag> flags = data_flags();
  flags.push_back(output_flag("-o,--output", "SVG file", true));
  flags.push_back(
      {"--panels",
       fmt::format("What to draw, with commas between: {}; default: all that the data allow",
                   fmt::join(kPanels, ", "))});
  flags.push_back({"--components", "The most component planes to draw; default: 12"});
  flags.push_back(memory_flag());
  return {"som plot",
          "Draw a map: U-matrix, hits, labels, component planes",
          {{"MAP", "A trained map", true},
           {"DATA", "NPY file or text, as for training, for hits and labels", false}},
          std::move(flags),
          {},
          plot};
}

}  // namespace somato::program
