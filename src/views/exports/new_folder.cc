#include "views/exports/new_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <system_error>

namespace somato {
namespace {

namespace fs = std::filesystem;

tl::unexpected<Error> cannot_save(const fs::path& path, const std::error_code& reason,
                                  const std::string& advice = {}) {
  return fail(ErrorKind::kSystem, "cannot save: " + reason.message(), path.string(), advice);
}

// hand_csv/ is hand_csv.
fs::path without_slash(const fs::path& path) {
  return path.has_filename() ? path : path.parent_path();
}

}  // namespace

Result<NewFolder> NewFolder::begin(const fs::path& path) {
  static std::atomic<unsigned> counter{0};
  const fs::path target = without_slash(path);
  std::error_code failure;
  if (fs::exists(fs::symlink_status(target, failure))) {
    return cannot_save(target, std::make_error_code(std::errc::file_exists),
                       "use another name, or remove it first");
  }
  for (;;) {
    const std::string name = fmt::format(".somato-{}-{}.partial", ::getpid(), counter++);
    const fs::path beside = target.parent_path() / name;
    if (fs::create_directory(beside, failure)) return NewFolder(target, beside);
    if (failure) return cannot_save(target, failure, "create its parent folder first");
  }
}

NewFolder::~NewFolder() {
  std::error_code ignored;
  if (!beside_.empty()) fs::remove_all(beside_, ignored);
}

Result<void> NewFolder::commit() {
  std::error_code failure;
  fs::rename(beside_, path_, failure);
  if (failure) return cannot_save(path_, failure);
  beside_.clear();
  return {};
}

}  // namespace somato
