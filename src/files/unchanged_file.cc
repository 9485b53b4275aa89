#include "files/unchanged_file.h"

#include <cerrno>

namespace somato {

Result<UnchangedFile> UnchangedFile::open(FileSystem& files, const std::string& path) {
  Outcome<OpenFile> file = OpenFile::open(files, path, Opening::kRead);
  if (!file) return system_failure("cannot open", path, file.error());
  const Outcome<FileStatus> status = file->status();
  if (!status) return system_failure("cannot read", path, status.error());
  if (status->kind == FileStatus::Kind::kDirectory) {
    return system_failure("cannot read", path, EISDIR);
  }
  if (status->kind != FileStatus::Kind::kRegular) {
    return fail(ErrorKind::kSystem, "only a regular file can be read repeatedly", path,
                "save it as a file first");
  }
  return UnchangedFile(std::move(*file), path, *status);
}

tl::unexpected<Error> UnchangedFile::changed() const {
  return fail(ErrorKind::kData, "the file changed while it was read", path_,
              "try again when no program is writing to it");
}

Result<void> UnchangedFile::check() const {
  const Outcome<FileStatus> now = file_.status();
  if (!now) return system_failure("cannot read", path_, now.error());
  if (now->size != status_.size || now->modified != status_.modified) return changed();
  return {};
}

Result<void> UnchangedFile::read(std::size_t place, char* bytes, std::size_t count) const {
  const Outcome<std::size_t> got = file_.read_all_at(place, bytes, count);
  if (!got) return system_failure("cannot read", path_, got.error());
  if (*got < count) return changed();
  return {};
}

}  // namespace somato
