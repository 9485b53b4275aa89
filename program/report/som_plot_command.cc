#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/text/text.h"
#include "flags/commands.h"
#include "flags/memory_flag.h"
#include "flags/neuron_flag.h"
#include "maps/pictures/map_panels.h"
#include "recordings/layout_flag.h"
#include "report/picture_file.h"
#include "report/plot_panels.h"
#include "som/column_report.h"
#include "som/data.h"
#include "som/map_and_rows.h"
#include "som/processes.h"
#include "somato/drawing/map_picture.h"
#include "views/skins/weights_picture.h"

namespace somato::program {
namespace {

bool has_data(const Arguments& arguments) {
  return !data_files(arguments).empty();
}

Result<void> check_data_flags(const Arguments& arguments) {
  if (has_data(arguments)) return {};
  for (const Flag& flag : data_flags()) {
    if (!arguments.has(key_of(flag.name))) continue;
    return fail(ErrorKind::kUsage, "has no effect without data", flag.name, "provide DATA");
  }
  return {};
}

Result<MapAndRows> read_map_and_perhaps_rows(const Arguments& arguments) {
  if (has_data(arguments)) return read_map_and_rows(arguments);
  SOMATO_TRY(auto model, load_som_model(arguments.text("MAP")));
  return MapAndRows{std::move(model), {}};
}

Result<void> check_skin_flags(const Arguments& arguments) {
  const bool has_layout = arguments.has("layout");
  if (arguments.has("neuron") && !has_layout) {
    return fail(ErrorKind::kUsage, "has no effect without --layout", "--neuron", "add --layout");
  }
  for (const Flag& flag : plot_panel_flags()) {
    if (!has_layout || !arguments.has(key_of(flag.name))) continue;
    return fail(ErrorKind::kUsage, "has no effect on a picture of weights on a skin", flag.name,
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
  return save_picture(arguments.text("output"), picture);
}

Result<void> plot(const Arguments& arguments) {
  SOMATO_TRY_VOID(refuse_several_processes("som plot"));
  SOMATO_TRY_VOID(check_picture_ending(arguments.text("output")));
  SOMATO_TRY_VOID(check_skin_flags(arguments));
  SOMATO_TRY_VOID(check_data_flags(arguments));
  if (arguments.has("layout")) return plot_skin(arguments);
  SOMATO_TRY(const auto choice, read_plot_choice(arguments));
  SOMATO_TRY(auto both, read_map_and_perhaps_rows(arguments));
  SOMATO_TRY(const auto panels, make_plot_panels(both, has_data(arguments), choice));
  if (panels.empty()) {
    return fail(ErrorKind::kUsage, "no panel can be drawn", "--panels",
                "name a panel, or use --components above 0");
  }
  const std::string title = std::filesystem::path(arguments.text("MAP")).filename().string();
  const std::string caption = caption_of(both.model.som.grid());
  SOMATO_TRY_VOID(save_picture(arguments.text("output"), draw_picture(title, caption, panels)));
  if (has_data(arguments)) note_columns_and_filled(both.rows);
  return {};
}

}  // namespace

Command som_plot_command() {
  std::vector<Flag> flags = data_flags();
  flags.push_back(output_flag(
      "-o,--output", "Picture: SVG, or by the extension .png or .pdf, which Chromium draws", true));
  for (Flag& flag : plot_panel_flags()) flags.push_back(std::move(flag));
  flags.push_back(layout_flag("on which the weights of each neuron are drawn instead of panels"));
  flags.push_back({"--neuron",
                   "With --layout: the only neuron to draw, as ROW,COLUMN from 1, or its number in "
                   "a map that grows"});
  flags.push_back(memory_flag());
  return {
      "som plot",
      "Draw a map: U-matrix, hits, classes, component planes, clusters, trajectories and more, or "
      "its weights on a skin",
      {{"MAP", "A trained map", true},
       data_positional("NPY file or text, as for training, for hits, classes and trajectories",
                       false)},
      std::move(flags),
      {},
      plot};
}

}  // namespace somato::program
