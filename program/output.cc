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

// Whether two paths lead to one regular file, or to the same place where there is none yet.
bool same_file(const std::string& a, const std::string& b) {
  std::error_code missing;
  if (std::filesystem::exists(a, missing)) {
    return std::filesystem::is_regular_file(a, missing) &&
           std::filesystem::equivalent(a, b, missing);
  }
  return std::filesystem::weakly_canonical(a, missing) ==
         std::filesystem::weakly_canonical(b, missing);
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
  if (!arguments.has(name)) return {};
  const std::string path = arguments.text(name);
  for (const char* other : {"DATA", "MAP", "SYSTEM", "FILE", "labels", "output", "activity",
                            "description", "data", "model"}) {
    if (other == name || !arguments.has(other) || !same_file(path, arguments.text(other))) continue;
    return fail(ErrorKind::kUsage,
                "the file is given twice; saving would write over " + std::string(other), path,
                "name another file");
  }
  for (const auto& [many, paths] : arguments.lists) {
    for (const std::string& other : paths) {
      if (!same_file(path, other)) continue;
      return fail(ErrorKind::kUsage, "saving would write over one of " + many, path,
                  "name another file");
    }
  }
  return check_output(path);
}

}  // namespace somato::program
