#include "recordings/file/partial_file.h"

#include <fmt/format.h>

#include <cerrno>

namespace somato {
namespace {

// One that is there is opened without changing it.
Outcome<OpenFile> open_or_create(FileSystem& files, const std::string& path) {
  for (;;) {
    Outcome<OpenFile> created = OpenFile::open(files, path, Opening::kCreate);
    if (created || created.error() != EEXIST) return created;
    Outcome<OpenFile> found = OpenFile::open(files, path, Opening::kOverwrite);
    if (found || found.error() != ENOENT) return found;
  }
}

tl::unexpected<Error> used_by_another(const std::string& path) {
  return fail(ErrorKind::kUsage, "another process records into this file", partial_path(path),
              "wait until it ends, or use another name");
}

tl::unexpected<Error> left_behind(const std::string& path) {
  return fail(
      ErrorKind::kUsage, "an earlier session that was not completed is in this file",
      partial_path(path),
      fmt::format("recover it: {}; then remove it, or use another name", recover_command(path)));
}

}  // namespace

std::string partial_path(const std::string& path) {
  return path + ".partial";
}

std::string recover_command(const std::string& path) {
  return fmt::format("somato recover {} -o {}", partial_path(path), path);
}

Result<OpenFile> create_partial_file(FileSystem& files, const std::string& path,
                                     std::size_t empty) {
  const std::string partial = partial_path(path);
  for (;;) {
    Outcome<OpenFile> file = open_or_create(files, partial);
    if (!file) return system_failure("cannot create", partial, file.error());
    // A file system without locks is no reason to fail.
    if (const auto locked = file->lock(); !locked && locked.error() == EWOULDBLOCK) {
      return used_by_another(path);
    }
    const Outcome<FileStatus> status = file->status();
    if (!status) return system_failure("cannot create", partial, status.error());
    if (status->links == 0) continue;  // Its process has removed it in the meantime.
    if (status->size > empty) return left_behind(path);
    if (const auto kept = flush_folder_of(files, partial); !kept) {
      return system_failure("cannot create", partial, kept.error());
    }
    return std::move(*file);
  }
}

}  // namespace somato
