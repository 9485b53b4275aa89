#include "recordings/tables/trial_files.h"

#include <fmt/format.h>

#include <map>
#include <system_error>
#include <utility>

#include "base/text/text.h"
#include "recordings/tables/files_below.h"

namespace somato {
namespace {

Result<void> refuse_no_text(const std::vector<TrialFile>& trials) {
  for (const TrialFile& trial : trials) {
    for (const Label& label : trial.labels) {
      if (is_name(label.value)) continue;
      return fail(ErrorKind::kData,
                  fmt::format("the label '{}' in the file name is not UTF-8 text", label.name),
                  trial.path, "rename the file");
    }
  }
  return {};
}

Result<void> refuse_twins(const std::vector<TrialFile>& trials) {
  std::map<std::vector<std::string>, const TrialFile*> seen;
  for (const TrialFile& trial : trials) {
    std::vector<std::string> values;
    values.reserve(trial.labels.size());
    for (const Label& label : trial.labels) values.push_back(label.value);
    const auto [twin, is_new] = seen.emplace(std::move(values), &trial);
    if (is_new) continue;
    return fail(ErrorKind::kData,
                fmt::format("the file has the same labels as {}", twin->second->path), trial.path,
                "remove one of them, or make the folder a label, as in {session}/...");
  }
  return {};
}

tl::unexpected<Error> misfit(const std::filesystem::path& file, const NamePattern& pattern) {
  return fail(ErrorKind::kData,
              fmt::format("the file name does not match the pattern \"{}\"", pattern.text()),
              file.string(), "rename it, remove it from the folder, or correct the pattern");
}

}  // namespace

bool is_one_file(const std::filesystem::path& path) {
  std::error_code missing;
  return std::filesystem::is_regular_file(path, missing);
}

Result<std::vector<TrialFile>> find_trial_files(const std::filesystem::path& folder,
                                                const NamePattern& pattern, bool pass_over_others) {
  const bool one_file = is_one_file(folder);
  const auto files = one_file ? Result<std::vector<std::string>>({folder.filename().string()})
                              : files_below(folder, pattern.extension());
  if (!files) return fail(files.error());
  std::vector<TrialFile> trials;
  for (const std::string& file : *files) {
    const std::filesystem::path path = one_file ? folder : folder / file;
    auto labels = pattern.match(one_file ? folder.generic_string() : file);
    if (!labels) {
      labels.error().where = path.string();
      return fail(std::move(labels.error()));
    }
    if (!*labels && !pass_over_others) return misfit(path, pattern);
    if (*labels) trials.push_back({path.string(), file, std::move(**labels)});
  }
  auto checked = refuse_no_text(trials).and_then([&] { return refuse_twins(trials); });
  if (!checked) return fail(std::move(checked.error()));
  if (!trials.empty()) return trials;
  return fail(ErrorKind::kData, fmt::format("there are no files \"{}\"", pattern.text()),
              folder.string(), "use the folder that contains them, or correct the pattern");
}

}  // namespace somato
