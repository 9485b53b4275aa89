#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "flags/commands.h"
#include "flags/output_folder.h"
#include "flags/result_output.h"
#include "reproduce/part.h"
#include "studies/run/merged_parts.h"
#include "terminal/folder_lock.h"
#include "terminal/wording.h"

namespace somato::program {
namespace {

// Before anything is written.
Result<void> check_parts(const std::vector<std::string>& folders) {
  for (const std::string& folder : folders) {
    if (contains_parts(parts_folder(folder))) continue;
    return fail(ErrorKind::kUsage, "the folder contains no parts", folder,
                "name folders that 'run', 'reproduce' or 'sweep' wrote with --part");
  }
  return {};
}

Result<void> merge_from(const std::filesystem::path& folder, const std::filesystem::path& to,
                        MergedParts& sum) {
  SOMATO_TRY(const auto merged, merge_parts(parts_folder(folder), to));
  sum.parts += merged.parts;
  sum.trainings += merged.trainings;
  sum.studies += merged.studies;
  return {};
}

Result<void> merge(const Arguments& arguments) {
  const std::filesystem::path out = arguments.text("out");
  const std::filesystem::path to = parts_folder(out);
  const std::vector<std::string>& folders = arguments.lists.at("FOLDER");
  SOMATO_TRY_VOID(check_parts(folders));
  SOMATO_TRY_VOID(make_folder(to));
  SOMATO_TRY([[maybe_unused]] const auto lock, FolderLock::take(out));
  MergedParts sum;
  for (const std::string& folder : folders) {
    SOMATO_TRY_VOID(merge_from(folder, to, sum));
  }
  const std::string text = fmt::format(
      "{}: {} with {} and {}. The command of the parts writes the results with "
      "--out {} and without --part.\n",
      out.string(), counted(sum.parts, "part"), counted(sum.trainings, "training"),
      counted(sum.studies, "sweep result"), out.string());
  print_summary(arguments, text,
                Table{{},
                      {entry("parts", std::uint64_t{sum.parts}),
                       entry("trainings", std::uint64_t{sum.trainings}),
                       entry("sweep_results", std::uint64_t{sum.studies})}});
  return {};
}

}  // namespace

Command merge_command() {
  return {"merge",
          "Combine the parts of a study, a reproduction or a sweep that did not share a folder",
          {{"FOLDER", "Folders that were --out of 'run', 'reproduce' or 'sweep' with --part", true,
            true}},
          {folder_flag("-o,--out", "Folder for the parts of all folders"), json_flag()},
          {},
          merge};
}

}  // namespace somato::program
