#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "base/text/text.h"
#include "flags/commands.h"
#include "systems/exchange/map_import.h"
#include "terminal/terminal.h"
#include "terminal/wording.h"

namespace somato::program {
namespace {

Result<MapImportOptions> read_options(const Arguments& arguments) {
  MapImportOptions options;
  options.given = given_parameters(arguments, MapImportOptions::parameters());
  options.variable = arguments.text("variable");
  if (arguments.has("features")) options.features = split(arguments.text("features"), ',');
  return options;
}

void print_notes(const std::string& path, const std::vector<std::string>& notes) {
  if (is_quiet()) return;
  for (const std::string& note : notes) {
    fmt::print(stderr, "somato: {}: {}\n", printable(path), printable(note));
  }
}

Result<void> import_file(const Arguments& arguments) {
  SOMATO_TRY(const auto options, read_options(arguments));
  SOMATO_TRY(const auto map, import_map(arguments.text("FILE"), options));
  const std::string path = arguments.text("output");
  SOMATO_TRY_VOID(save_som_model(path, map.model));
  const Som& som = map.model.som;
  print_summary(fmt::format("{}: {} x {} neurons, {}\n", path, som.grid().rows(),
                            som.grid().columns(), counted(som.input_size(), "feature")));
  print_notes(arguments.text("FILE"), map.notes);
  return {};
}

// The parameters of a trained map, not those of its training. Here the sides are never automatic.
Flag flag_of_parameter(const ParameterInfo& info) {
  if (info.name == "rows" || info.name == "columns") {
    return {flag_of(info.name),
            fmt::format("The map's {}, for weights of neurons x features", info.name)};
  }
  std::string text = info.text.substr(0, info.text.find_last_not_of('.') + 1);
  if (!info.choices.empty()) text += fmt::format(": {}", fmt::join(info.choices, ", "));
  return {flag_of(info.name), std::move(text)};
}

}  // namespace

Command som_import_command() {
  std::vector<Flag> flags{output_flag("-o,--output", "File for the map", true),
                          {"--features", "Names of the features, separated by commas"},
                          {"--variable", "The array of an NPZ file with several"}};
  for (const ParameterInfo& info : MapImportOptions::parameters()) {
    flags.push_back(flag_of_parameter(info));
  }
  return {"som import",
          "Read a map of another program, or one that som export has written",
          {{"FILE",
            "Archive of som export, weights of rows x columns x features in an NPY or NPZ file, or "
            "codebook of SOM_PAK or SOM Toolbox (.cod)",
            true}},
          std::move(flags),
          {},
          import_file};
}

}  // namespace somato::program
