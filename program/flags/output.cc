#include "flags/output.h"

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

namespace somato::program {
namespace {

namespace fs = std::filesystem;

// The depth to which importers search.
constexpr int kDeepestFolder = 16;

// An argument and a path that it names.
using NamedPath = std::pair<std::string, std::string>;

Result<void> refuse(const std::string& path, int reason, const std::string& advice) {
  return fail(ErrorKind::kSystem, "cannot save: " + std::generic_category().message(reason), path,
              advice);
}

// Whether two paths name the same regular file, or the same place if it does not exist yet.
bool same_file(const std::string& a, const std::string& b) {
  std::error_code missing;
  if (fs::exists(a, missing)) {
    return fs::is_regular_file(a, missing) && fs::equivalent(a, b, missing);
  }
  return fs::weakly_canonical(a, missing) == fs::weakly_canonical(b, missing);
}

// Whether the existing `file` is one of the files of `folder`, under any name.
bool is_in_folder(const std::string& file, const std::string& folder) {
  std::error_code missing;
  if (!fs::is_regular_file(file, missing) || !fs::is_directory(folder, missing)) return false;
  const auto options = fs::directory_options::follow_directory_symlink |
                       fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator at(folder, options, missing), end; at != end;
       at.increment(missing)) {
    if (missing) return false;
    if (at.depth() >= kDeepestFolder) at.disable_recursion_pending();
    if (at->is_regular_file(missing) && fs::equivalent(at->path(), file, missing)) return true;
  }
  return false;
}

// Whether `file` is one of the files that a command writes into `folder`, or below it.
bool is_written(const std::string& file, const std::string& folder,
                const std::vector<std::string>& names) {
  std::error_code missing;
  if (!fs::is_regular_file(file, missing)) return false;
  for (const std::string& name : names) {
    if (same_file(file, (fs::path(folder) / name).string())) return true;
  }
  return false;
}

tl::unexpected<Error> would_replace(const std::string& what, const std::string& output) {
  return fail(ErrorKind::kUsage, "the file is given twice; saving would overwrite " + what, output,
              "use another file name");
}

Result<void> check_is_not(const std::string& output, const NamedPath& read) {
  if (same_file(output, read.second)) return would_replace(read.first, output);
  if (!is_in_folder(output, read.second)) return {};
  return fail(ErrorKind::kUsage, "saving would overwrite a file of the folder " + read.first,
              output, "use a file outside the folder, or remove this one first");
}

std::vector<NamedPath> inputs_of(const Command& command, const Arguments& arguments) {
  std::vector<NamedPath> inputs;
  for (const Positional& positional : command.positionals) {
    if (positional.role != Role::kInput) continue;
    if (arguments.has(positional.name)) {
      inputs.emplace_back(positional.name, arguments.text(positional.name));
    }
    const auto many = arguments.lists.find(positional.name);
    if (many == arguments.lists.end()) continue;
    for (const std::string& path : many->second) inputs.emplace_back("one of " + many->first, path);
  }
  for (const Flag& flag : command.flags) {
    const std::string key = key_of(flag.name);
    if (flag.role != Role::kInput || !arguments.has(key)) continue;
    inputs.emplace_back("--" + key, arguments.text(key));
  }
  return inputs;
}

Result<void> check_folder(const Flag& flag, const std::string& folder,
                          const std::vector<NamedPath>& inputs) {
  for (const NamedPath& input : inputs) {
    if (!is_written(input.second, folder, flag.writes)) continue;
    return fail(ErrorKind::kUsage, "results would overwrite it, which is given as " + input.first,
                input.second, "use another folder for --" + key_of(flag.name));
  }
  return {};
}

}  // namespace

Result<void> check_output(const std::string& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) {
    return refuse(path, EISDIR, "name a file, not a folder");
  }
  fs::path folder = fs::path(path).parent_path();
  if (folder.empty()) folder = ".";
  if (fs::is_directory(folder, ignored)) return {};
  return refuse(path, fs::exists(folder, ignored) ? ENOTDIR : ENOENT,
                "create the folder first, or check the path");
}

Result<void> check_not_read(const std::string& output, const std::vector<std::string>& read) {
  for (const std::string& path : read) {
    SOMATO_TRY_VOID(check_is_not(output, NamedPath{path, path}));
  }
  return {};
}

Result<void> check_outputs(const Command& command, const Arguments& arguments) {
  std::vector<NamedPath> others = inputs_of(command, arguments);
  for (const Flag& flag : command.flags) {
    const std::string key = key_of(flag.name);
    if (!arguments.has(key)) continue;
    const std::string path = arguments.text(key);
    if (flag.role == Role::kOutputFolder) {
      SOMATO_TRY_VOID(check_folder(flag, path, others));
    }
    if (flag.role != Role::kOutput) continue;
    for (const NamedPath& other : others) {
      SOMATO_TRY_VOID(check_is_not(path, other));
    }
    SOMATO_TRY_VOID(check_output(path));
    others.emplace_back("--" + key, path);
  }
  return {};
}

}  // namespace somato::program
