#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/core/threads.h"
#include "base/files/whole_file.h"
#include "base/text/text.h"
#include "flags/commands.h"
#include "flags/layout_flag.h"
#include "flags/memory_flag.h"
#include "flags/neuron_flag.h"
#include "maps/pictures/map_panels.h"
#include "maps/pictures/weights_picture.h"
#include "som/column_report.h"
#include "som/data.h"
#include "som/map_and_rows.h"
#include "som/processes.h"
#include "somato/drawing/map_picture.h"

namespace somato::program {
namespace {

bool has_data(const Arguments& arguments) {
  return !data_files(arguments).empty();
}

const std::vector<std::string> kPanels{"u_matrix", "hits", "labels", "components"};

// The panels that --panels names, or all possible ones.
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
  if (has_data(arguments)) return {};
  for (const Flag& flag : data_flags()) {
    if (!arguments.has(key_of(flag.name))) continue;
    return fail(ErrorKind::kUsage, "has no effect without data", flag.name, "provide DATA");
  }
  return {};
}

// Only panels named by --panels can be missing.
Result<void> check_panels(const Arguments& arguments, const std::vector<std::string>& chosen) {
  if (!arguments.has("panels")) return {};
  const bool labelled = arguments.has("labels") || arguments.has("label-column");
  if (wants(chosen, "hits") && !has_data(arguments)) {
    return fail(ErrorKind::kUsage, "hits cannot be drawn without data", "--panels", "provide DATA");
  }
  if (wants(chosen, "labels") && !(labelled && has_data(arguments))) {
    return fail(ErrorKind::kUsage, "labels cannot be drawn without labelled data", "--panels",
                "use DATA with --labels or --label-column");
  }
  return {};
}

Result<void> add_data_panels(const MapAndRows& both, const std::vector<std::string>& chosen,
                             std::vector<Panel>& panels) {
  const Som& som = both.model.som;
  SOMATO_TRY(auto quality, measure_rows(both.model, both.rows, available_threads()));
  if (wants(chosen, "hits")) panels.emplace_back(hits_panel(som.grid(), quality.hits));
  if (!wants(chosen, "labels") || !both.rows.labelled()) return {};
  LabelPanel panel;
  panel.title = "Labels";
  panel.grid = som.grid();
  panel.class_names = both.rows.classes.names;
  panel.winners = std::move(quality.winners);
  panel.classes = both.rows.classes.of_sample;
  panels.emplace_back(std::move(panel));
  return {};
}

Result<MapAndRows> read_map_and_perhaps_rows(const Arguments& arguments) {
  if (has_data(arguments)) return read_map_and_rows(arguments);
  SOMATO_TRY(auto model, load_som_model(arguments.text("MAP")));
  return MapAndRows{std::move(model), {}};
}

// Pictures are always SVG: another file extension is a mistake.
Result<void> check_ending(const std::string& output) {
  const std::string ending = std::filesystem::path(output).extension().string();
  for (const char* other : {".png", ".pdf", ".jpg", ".jpeg", ".eps"}) {
    if (ending != other) continue;
    return fail(ErrorKind::kUsage, fmt::format("the picture is SVG, not {}", ending.substr(1)),
                output,
                "use the extension .svg; browsers and Inkscape convert it to other formats");
  }
  return {};
}

Result<void> check_skin_flags(const Arguments& arguments) {
  const bool has_layout = arguments.has("layout");
  if (arguments.has("neuron") && !has_layout) {
    return fail(ErrorKind::kUsage, "has no effect without --layout", "--neuron", "add --layout");
  }
  for (const std::string flag : {"panels", "components"}) {
    if (!has_layout || !arguments.has(flag)) continue;
    return fail(ErrorKind::kUsage, "has no effect on a picture of weights on a skin", "--" + flag,
                "omit it, or --layout");
  }
  if (!has_layout || !has_data(arguments)) return {};
  return fail(ErrorKind::kUsage, "a picture of weights on a skin shows no data", "DATA",
              "omit it, or --layout");
}

// The weights on a skin, instead of panels.
Result<void> plot_skin(const Arguments& arguments) {
  SOMATO_TRY(const auto layout, read_layout_flag(arguments));
  SOMATO_TRY(const auto model, load_som_model(arguments.text("MAP")));
  std::optional<std::size_t> neuron;
  if (arguments.has("neuron")) {
    SOMATO_TRY(neuron, chosen_neuron(arguments.text("neuron"), model.som.grid()));
  }
  const std::string title = std::filesystem::path(arguments.text("MAP")).filename().string();
  SOMATO_TRY(const auto elements, inputs_on_skin(model.som, model.features, layout));
  SOMATO_TRY(const auto picture, draw_weights(model.som, elements, neuron, title));
  return save_whole(arguments.text("output"), picture);
}

Result<void> plot(const Arguments& arguments) {
  SOMATO_TRY_VOID(refuse_several_processes("som plot"));
  SOMATO_TRY_VOID(check_ending(arguments.text("output")));
  SOMATO_TRY_VOID(check_skin_flags(arguments));
  SOMATO_TRY_VOID(check_data_flags(arguments));
  if (arguments.has("layout")) return plot_skin(arguments);
  SOMATO_TRY(auto chosen, chosen_panels(arguments));
  SOMATO_TRY(auto most, arguments.number("components", 0));
  SOMATO_TRY_VOID(check_panels(arguments, chosen));
  SOMATO_TRY(auto both, read_map_and_perhaps_rows(arguments));
  const Som& som = both.model.som;
  std::vector<Panel> panels;
  if (wants(chosen, "u_matrix")) panels.emplace_back(u_matrix_panel(som));
  if (has_data(arguments)) {
    SOMATO_TRY_VOID(add_data_panels(both, chosen, panels));
  }
  if (wants(chosen, "components")) {
    for (Panel& panel : component_panels(som, both.model.features, most.value_or(12))) {
      panels.push_back(std::move(panel));
    }
  }
  if (panels.empty()) {
    return fail(ErrorKind::kUsage, "no panel can be drawn", "--panels",
                "name a panel, or use --components above 0");
  }
  const std::string title = std::filesystem::path(arguments.text("MAP")).filename().string();
  return save_whole(arguments.text("output"), draw_picture(title, caption_of(som.grid()), panels))
      .map([&] {
        if (has_data(arguments)) note_columns_and_filled(both.rows);
      });
}

}  // namespace

Command som_plot_command() {
  std::vector<Flag> flags = data_flags();
  flags.push_back(output_flag("-o,--output", "SVG file", true));
  flags.push_back(
      {"--panels",
       fmt::format("Panels to draw, separated by commas: {}. Default: all possible with the data",
                   fmt::join(kPanels, ", "))});
  flags.push_back({"--components", "Maximum number of component planes. Default: 12"});
  flags.push_back(layout_flag("on which the weights of each neuron are drawn instead of panels"));
  flags.push_back({"--neuron",
                   "With --layout: the only neuron to draw, as ROW,COLUMN from 1, or its number in "
                   "a map that grows"});
  flags.push_back(memory_flag());
  return {"som plot",
          "Draw a map: U-matrix, hits, labels and component planes, or its weights on a skin",
          {{"MAP", "A trained map", true},
           data_positional("NPY file or text, as for training, for hits and labels", false)},
          std::move(flags),
          {},
          plot};
}

}  // namespace somato::program
