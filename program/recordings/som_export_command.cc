#include <fmt/format.h>

#include "base/archives/archive.h"
#include "flags/commands.h"
#include "somato/graph/system_model.h"
#include "systems/exchange/map_npz_writer.h"
#include "systems/exchange/system_map.h"
#include "terminal/terminal.h"
#include "terminal/wording.h"

namespace somato::program {
namespace {

Result<SomModel> read_model(const Arguments& arguments) {
  const std::string path = arguments.text("MODEL");
  SOMATO_TRY(const auto archive, load_archive(path));
  if (archive.kind() == "system") {
    SOMATO_TRY(const auto system, load_system(path));
    return map_of_system(system, arguments.text("module"), path);
  }
  if (!arguments.has("module")) return load_som_model(path);
  return fail(ErrorKind::kUsage, "has no effect on the model of a single map", "--module",
              "omit it");
}

Result<void> export_map(const Arguments& arguments) {
  SOMATO_TRY(const auto model, read_model(arguments));
  const std::string path = arguments.text("output");
  auto saved = save_map_npz(path, model);
  if (!saved) {
    if (saved.error().where.empty()) saved.error().where = path;
    return saved;
  }
  print_summary(fmt::format("{}: {} neurons, {}\n", path, model.som.neurons(),
                            counted(model.som.input_size(), "feature")));
  return {};
}

}  // namespace

Command som_export_command() {
  return {"som export",
          "Write a trained map as an NPZ archive, which numpy.load opens",
          {{"MODEL", "A trained map, or a trained system with a map", true}},
          {output_flag("-o,--output", "NPZ file", true),
           {"--module", "The module of a system that is a map. Default: the only one"}},
          {},
          export_map};
}

}  // namespace somato::program
