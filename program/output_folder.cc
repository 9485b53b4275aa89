#include "output_folder.h"

#include <system_error>

#include "output.h"

namespace somato::program {

OutputFolder::~OutputFolder() {
  std::error_code not_empty;
  for (const std::filesystem::path& folder : made_) std::filesystem::remove(folder, not_empty);
}

Result<void> OutputFolder::make() {
  std::error_code code;
  std::filesystem::path missing = std::filesystem::absolute(path_, code).lexically_normal();
  for (; !std::filesystem::exists(missing, code); missing = missing.parent_path()) {
    made_.push_back(missing);
  }
  std::filesystem::create_directories(path_, code);
  if (code) {
    return fail(ErrorKind::kSystem, "the folder cannot be made: " + code.message(), path_.string(),
                "give " + flag_ + " a folder that can be written to");
  }
  for (const std::string& name : names()) {
    if (auto free = check_output((path_ / name).string()); !free) return free;
  }
  return {};
}

}  // namespace somato::program
