#include "flags/output_folder.h"

#include <system_error>

#include "flags/output.h"

namespace somato::program {

Result<void> make_folder(const std::filesystem::path& path, const std::string& flag) {
  std::error_code code;
  std::filesystem::create_directories(path, code);
  if (!code) return {};
  return fail(ErrorKind::kSystem, "the folder cannot be created: " + code.message(), path.string(),
              "use a writable folder for " + flag);
}

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
  SOMATO_TRY_VOID(make_folder(path_, flag_));
  for (const std::string& name : names()) {
    SOMATO_TRY_VOID(check_output((path_ / name).string()));
  }
  return {};
}

}  // namespace somato::program
