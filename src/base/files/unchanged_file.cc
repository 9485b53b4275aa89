#include "base/files/unchanged_file.h"

namespace somato {

Result<UnchangedFile> UnchangedFile::open(FileSystem& files, const std::string& path) {
  SOMATO_TRY(auto opened, open_to_read(files, path));
  if (opened.status.kind != FileStatus::Kind::kRegular) {
    return fail(ErrorKind::kSystem, "only a regular file can be read repeatedly", path,
                "save it as a file first");
  }
  return UnchangedFile(std::move(opened.file), path, opened.status);
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
