#include "output.h"

#include <cerrno>
#include <filesystem>
#include <system_error>

namespace somato::program {
namespace {

Result<void> refuse(const std::string& path, int reason, const std::string& advice) {
  return fail(ErrorKind::kSystem, "cannot save: " + std::generic_category().message(reason), path,
              advice);
}

}  // namespace

Result<void> check_output(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    return refuse(path, EISDIR, "name a file, not a folder");
  }
  std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (folder.empty()) folder = ".";
  if (std::filesystem::is_directory(folder, ignored)) return {};
  return refuse(path, std::filesystem::exists(folder, ignored) ? ENOTDIR : ENOENT,
                "check the path; folders are not made for you");
}

Result<void> check_output(const Arguments& arguments, const std::string& name) {
  return arguments.has(name) ? check_output(arguments.text(name)) : Result<void>();
}

}  // namespace somato::program
