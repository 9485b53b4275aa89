#include "flags/left_out.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "version.h"

namespace somato::program {
namespace {

// A part of the program that a build can leave out.
struct BuildPart {
  bool is_here;
  std::string text;
  std::string option;
  std::vector<std::string> commands;
  // Those of commands that every build has.
  std::vector<std::string> flags;
};

const std::vector<BuildPart>& build_parts() {
  static const std::vector<BuildPart> all{
      {kHasSimulation,
       "simulated bodies",
       "SIMULATION",
       {"sense", "reproduce", "sweep", "merge", "emulate"},
       {"--body", "--seed", "--images", "--threads"}},
      {kHasReport,
       "report, figures and view",
       "REPORT",
       {"report", "figure", "view", "som plot"},
       {"--view", "--port", "--address", "--allow-others", "--names", "--each", "--layout"}},
      {kHasStudies,
       "training and evaluation",
       "STUDIES",
       {"run", "information", "suggest", "touch-order", "systems", "som train", "som map",
        "som quality", "som cluster", "som features", "som predict"},
       {}},
      {kHasImporters,
       "import and export",
       "IMPORTERS",
       {"import", "convert", "som import", "som export"},
       {}}};
  return all;
}

bool is_among(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Only these have flags of parts: elsewhere, a flag of the same name is another one.
bool uses_parts(const std::string& command) {
  return command == "live" || command == "explore";
}

Error left_out(const BuildPart& part, std::string what, const std::string& where) {
  return {ErrorKind::kUsage,
          fmt::format("{} belongs to a part that this program was built without: {}",
                      std::move(what), part.text),
          where,
          fmt::format("use a program that is built with SOMATO_BUILD_{}=ON, as it is without "
                      "SOMATO_PROFILE=robot (docs/embedding.md)",
                      part.option)};
}

}  // namespace

std::optional<Error> left_out_command(const std::string& words) {
  for (const BuildPart& part : build_parts()) {
    if (part.is_here || !is_among(part.commands, words)) continue;
    return left_out(part, fmt::format("the command '{}'", words), {});
  }
  return {};
}

std::optional<Error> left_out_flag(const std::string& flag, const std::string& command) {
  for (const BuildPart& part : build_parts()) {
    if (part.is_here || !uses_parts(command) || !is_among(part.flags, flag)) continue;
    return left_out(part, fmt::format("the flag '{}'", flag), command);
  }
  return {};
}

Error without_importers(const std::string& path) {
  return {ErrorKind::kUsage, "this program was built without importers, and reads recordings only",
          path, "import it with a program that is built with SOMATO_BUILD_IMPORTERS=ON"};
}

void remove_left_out_flags(Command& command) {
  std::erase_if(command.flags, [&](const Flag& flag) {
    return left_out_flag("--" + key_of(flag.name), command.name).has_value();
  });
  if (!kHasSimulation && command.name == "explore") command.parameters.clear();
}

}  // namespace somato::program
