#include "reproduce/kept_studies.h"

#include <system_error>
#include <utility>

#include "base/files/whole_file.h"
#include "flags/output_folder.h"
#include "studies/run/part_file.h"

namespace somato::program {
namespace {

constexpr const char* kFound = ".found";

}  // namespace

Result<void> KeptStudies::make_folders() const {
  return make_folder(unfinished());
}

void KeptStudies::look() {
  std::error_code ignored;
  for (const auto& part : std::filesystem::directory_iterator(parts_, ignored)) {
    for (const auto& file : std::filesystem::directory_iterator(part.path(), ignored)) {
      if (file.path().extension() == kFound) found_[file.path().stem().string()] = file.path();
    }
  }
}

Result<std::optional<PartResults>> KeptStudies::find(const std::string& name) const {
  const auto content = find_text(name);
  if (!content) return std::nullopt;
  return read_part_file(*content, found_.at(name).string());
}

Result<void> KeptStudies::keep(const std::string& name, const PartResults& results) {
  return keep_text(name, part_file(results));
}

std::optional<std::string> KeptStudies::find_text(const std::string& name) const {
  const auto found = found_.find(name);
  if (found == found_.end()) return {};
  auto content = read_whole(found->second.string());
  return content ? std::optional(std::move(*content)) : std::nullopt;
}

Result<void> KeptStudies::keep_text(const std::string& name, const std::string& text) {
  const std::filesystem::path path = own_ / (name + kFound);
  SOMATO_TRY_VOID(save_whole(path.string(), text));
  found_[name] = path;
  return {};
}

}  // namespace somato::program
