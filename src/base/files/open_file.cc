#include "base/files/open_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

namespace somato {
namespace {

std::string advice_for(int error) {
  switch (error) {
    case ENOENT:
      return "check the path";
    case ENOTDIR:
      return "check the path; a part of it is not a folder";
    case EEXIST:
      return "remove the file or use another name";
    case EISDIR:
      return "name a file, not a folder";
    case EACCES:
    case EPERM:
    case EROFS:
      return "use another place or change the permissions";
    case ENOSPC:
    case EDQUOT:
      return "free disk space or use another place";
    case EFBIG:
      return "raise the limit on file sizes (ulimit -f) or use another place";
    case ELOOP:
      return "the symbolic links form a loop";
    default:
      return {};
  }
}

}  // namespace

tl::unexpected<Error> system_failure(const std::string& what, const std::string& path, int error) {
  return fail(ErrorKind::kSystem,
              fmt::format("{}: {}", what, std::generic_category().message(error)), path,
              advice_for(error));
}

Outcome<OpenFile> OpenFile::open(FileSystem& files, const std::string& path, Opening opening) {
  return uninterrupted([&] { return files.open(path, opening); }).map([&](int number) {
    return OpenFile(files, number);
  });
}

Result<FileToRead> open_to_read(FileSystem& files, const std::string& path) {
  Outcome<OpenFile> file = OpenFile::open(files, path, Opening::kRead);
  if (!file) return system_failure("cannot open", path, file.error());
  const Outcome<FileStatus> status = file->status();
  if (!status) return system_failure("cannot read", path, status.error());
  if (status->kind == FileStatus::Kind::kDirectory) {
    return system_failure("cannot read", path, EISDIR);
  }
  return FileToRead{std::move(*file), *status};
}

Outcome<FileStatus> OpenFile::status() const {
  return uninterrupted([&] { return files_->status(number_); });
}

Outcome<std::size_t> OpenFile::read(char* bytes, std::size_t count) const {
  return uninterrupted([&] { return files_->read(number_, bytes, count); });
}

Outcome<std::size_t> OpenFile::read_all_at(std::size_t place, char* bytes,
                                           std::size_t count) const {
  std::size_t done = 0;
  while (done < count) {
    const auto got = uninterrupted(
        [&] { return files_->read_at(number_, place + done, bytes + done, count - done); });
    if (!got) return got;
    if (*got == 0) break;
    done += *got;
  }
  return done;
}

Outcome<void> OpenFile::write_all(std::string_view bytes) const {
  while (!bytes.empty()) {
    const auto written = uninterrupted([&] { return files_->write(number_, bytes); });
    if (!written) return tl::unexpected<int>(written.error());
    if (*written == 0) return tl::unexpected<int>(EIO);
    bytes.remove_prefix(*written);
  }
  return {};
}

Outcome<void> OpenFile::take_permissions(const FileStatus& like) const {
  return uninterrupted([&] { return files_->set_permissions(number_, like); });
}

Outcome<void> OpenFile::flush() const {
  return uninterrupted([&] { return files_->flush(number_); });
}

Outcome<void> OpenFile::lock() const {
  return uninterrupted([&] { return files_->lock(number_); });
}

Outcome<void> OpenFile::close() {
  const int number = std::exchange(number_, -1);
  if (number < 0) return {};
  Outcome<void> closed = files_->close(number);
  if (!closed && closed.error() == EINTR) return {};
  return closed;
}

Outcome<void> flush_folder_of(FileSystem& files, const std::string& path) {
  const std::string parent = std::filesystem::path(path).parent_path().string();
  Outcome<OpenFile> opened = OpenFile::open(files, parent.empty() ? "." : parent, Opening::kFolder);
  if (!opened && opened.error() == EACCES) return {};
  if (!opened) return tl::unexpected<int>(opened.error());
  Outcome<void> flushed = opened->flush();
  if (!flushed && flushed.error() == EINVAL) return {};
  return flushed;
}

}  // namespace somato
