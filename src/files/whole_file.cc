#include "somato/files/whole_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "files/file_system.h"

namespace somato {
namespace {

constexpr std::size_t kReadAtOnce = std::size_t{1} << 20;
constexpr int kMostLinks = 40;

std::string advice_for(int error) {
  switch (error) {
    case ENOENT:
      return "check the path; folders are not made for you";
    case ENOTDIR:
      return "check the path; a part of it is not a folder";
    case EISDIR:
      return "name a file, not a folder";
    case EACCES:
    case EPERM:
    case EROFS:
      return "choose another place or change the permissions";
    case ENOSPC:
    case EDQUOT:
      return "make room or choose another place";
    case EFBIG:
      return "raise the limit on file sizes (ulimit -f) or choose another place";
    case ELOOP:
      return "the symbolic links lead round in a circle";
    default:
      return {};
  }
}

tl::unexpected<Error> system_failure(const std::string& what, const std::string& path, int error) {
  return fail(ErrorKind::kSystem,
              fmt::format("{}: {}", what, std::generic_category().message(error)), path,
              advice_for(error));
}

tl::unexpected<Error> too_large(const std::string& path, std::size_t limit) {
  return fail(ErrorKind::kData, fmt::format("the file is larger than {} bytes", limit), path,
              "split it, or check that it is the right file");
}

// Signals interrupt system calls; that is no failure.
template <typename Operation>
auto uninterrupted(Operation operation) {
  auto outcome = operation();
  while (!outcome && outcome.error() == EINTR) outcome = operation();
  return outcome;
}

// An open file that is closed on every way out.
class OpenFile {
 public:
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  OpenFile(FileSystem& files, int number) : files_(&files), number_(number) {}
  OpenFile(OpenFile&& other) noexcept
      : files_(other.files_), number_(std::exchange(other.number_, -1)) {}
  OpenFile& operator=(OpenFile&&) = delete;
  ~OpenFile() { (void)close(); }

  static Outcome<OpenFile> open(FileSystem& files, const std::string& path, Opening opening) {
    return uninterrupted([&] { return files.open(path, opening); }).map([&](int number) {
      return OpenFile(files, number);
    });
  }

  int number() const { return number_; }

  Outcome<FileStatus> status() const {
    return uninterrupted([&] { return files_->status(number_); });
  }

  // Never twice: after a failed close the number may already belong to another file.
  Outcome<void> close() {
    const int number = std::exchange(number_, -1);
    if (number < 0) return {};
    Outcome<void> closed = files_->close(number);
    if (!closed && closed.error() == EINTR) return {};
    return closed;
  }

 private:
  FileSystem* files_;
  int number_;
};

Outcome<void> write_all(FileSystem& files, const OpenFile& file, std::string_view bytes) {
  while (!bytes.empty()) {
    const auto written = uninterrupted([&] { return files.write(file.number(), bytes); });
    if (!written) return tl::unexpected<int>(written.error());
    if (*written == 0) return tl::unexpected<int>(EIO);
    bytes.remove_prefix(*written);
  }
  return {};
}

Outcome<void> write_and_close(FileSystem& files, OpenFile& file, std::string_view bytes) {
  return write_all(files, file, bytes).and_then([&] { return file.close(); });
}

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

// `/dev/stdout` ends in a link below /proc that stands for an open file, not for its name.
bool stands_for_an_open_file(const std::string& link) {
  std::error_code ignored;
  const std::string folder = std::filesystem::canonical(folder_of(link), ignored).string();
  return folder.starts_with("/proc/");
}

struct Target {
  std::string path;
  bool direct = false;  // To be written to whatever it is, never replaced.
};

// Follows symbolic links, also to a file that does not exist yet.
Target follow_links(std::string path) {
  std::error_code ignored;
  for (int i = 0; i < kMostLinks; ++i) {
    if (!std::filesystem::is_symlink(std::filesystem::symlink_status(path, ignored))) break;
    if (stands_for_an_open_file(path)) return {std::move(path), true};
    const std::filesystem::path next = std::filesystem::read_symlink(path, ignored);
    path = (std::filesystem::path(path).parent_path() / next).string();
  }
  return {std::move(path), false};
}

struct NewFile {
  std::string path;
  OpenFile file;
};

// A name that a killed process of the same number left behind is passed over.
Outcome<NewFile> create_beside(FileSystem& files, const std::string& path) {
  static std::atomic<unsigned> counter{0};
  for (;;) {
    const std::string name = fmt::format(".somato-{}-{}.partial", ::getpid(), counter++);
    const std::string beside = (std::filesystem::path(path).parent_path() / name).string();
    Outcome<OpenFile> file = OpenFile::open(files, beside, Opening::kCreate);
    if (file) return NewFile{beside, std::move(*file)};
    if (file.error() != EEXIST) return tl::unexpected<int>(file.error());
  }
}

Outcome<void> take_permissions(FileSystem& files, const OpenFile& file, const FileStatus& like) {
  return uninterrupted([&] { return files.set_permissions(file.number(), like); });
}

Outcome<void> fill(FileSystem& files, OpenFile& file, std::string_view bytes,
                   const FileStatus* like) {
  if (like) {
    if (Outcome<void> set = take_permissions(files, file, *like); !set) return set;
  }
  if (Outcome<void> written = write_all(files, file, bytes); !written) return written;
  Outcome<void> flushed = uninterrupted([&] { return files.flush(file.number()); });
  return flushed.and_then([&] { return file.close(); });
}

// A folder that may be written to but not read, or a file system that cannot flush folders, is no
// reason to fail.
Outcome<void> flush_folder(FileSystem& files, const std::string& folder) {
  Outcome<OpenFile> opened = OpenFile::open(files, folder, Opening::kFolder);
  if (!opened && opened.error() == EACCES) return {};
  if (!opened) return tl::unexpected<int>(opened.error());
  Outcome<void> flushed = uninterrupted([&] { return files.flush(opened->number()); });
  if (!flushed && flushed.error() == EINVAL) return {};
  return flushed;
}

Outcome<void> write_beside_and_rename(FileSystem& files, const std::string& path,
                                      std::string_view bytes, const FileStatus* like) {
  Outcome<NewFile> beside = create_beside(files, path);
  if (!beside) return tl::unexpected<int>(beside.error());
  Outcome<void> saved = fill(files, beside->file, bytes, like).and_then([&] {
    return uninterrupted([&] { return files.rename(beside->path, path); });
  });
  if (!saved) (void)files.remove(beside->path);
  return saved;
}

Result<void> replace(FileSystem& files, const std::string& path, std::string_view bytes,
                     const FileStatus* like) {
  const Outcome<void> saved = write_beside_and_rename(files, path, bytes, like);
  if (!saved) return system_failure("cannot save", path, saved.error());
  const Outcome<void> kept = flush_folder(files, folder_of(path));
  if (!kept) return system_failure("saved, but a power cut may undo it", path, kept.error());
  return {};
}

}  // namespace

namespace detail {

Result<std::string> read_whole(FileSystem& files, const std::string& path, std::size_t limit) {
  const Outcome<OpenFile> file = OpenFile::open(files, path, Opening::kRead);
  if (!file) return system_failure("cannot open", path, file.error());
  const Outcome<FileStatus> status = file->status();
  if (!status) return system_failure("cannot read", path, status.error());
  if (status->kind == FileStatus::Kind::kDirectory) {
    return system_failure("cannot read", path, EISDIR);
  }
  if (status->size > limit) return too_large(path, limit);

  // The size is a hint (0 for a pipe); the end is where nothing more comes.
  std::string bytes(status->size, '\0');
  std::size_t count = 0;
  for (;;) {
    char probe[4096];
    const bool full = count == bytes.size();
    char* const place = full ? probe : bytes.data() + count;
    const std::size_t room = full ? sizeof probe : std::min(kReadAtOnce, bytes.size() - count);
    const auto got = uninterrupted([&] { return files.read(file->number(), place, room); });
    if (!got) return system_failure("cannot read", path, got.error());
    if (*got == 0) break;
    count += *got;
    if (count > limit) return too_large(path, limit);
    if (full) bytes.append(probe, *got);
  }
  bytes.resize(count);
  return bytes;
}

Result<void> save_whole(FileSystem& files, const std::string& path, std::string_view bytes) {
  const Target target = follow_links(path);
  const Opening opening = target.direct ? Opening::kTruncate : Opening::kOverwrite;
  Outcome<OpenFile> existing = OpenFile::open(files, target.path, opening);
  if (!existing && existing.error() == ENOENT && !target.direct) {
    return replace(files, target.path, bytes, nullptr);
  }
  if (!existing) return system_failure("cannot save", path, existing.error());
  const Outcome<FileStatus> status = existing->status();
  if (!status) return system_failure("cannot save", path, status.error());
  if (!target.direct && status->kind == FileStatus::Kind::kRegular) {
    (void)existing->close();
    return replace(files, target.path, bytes, &*status);
  }
  const Outcome<void> written = write_and_close(files, *existing, bytes);
  if (!written) return system_failure("cannot save", path, written.error());
  return {};
}

}  // namespace detail

Result<std::string> read_whole(const std::string& path, std::size_t limit) {
  return detail::read_whole(operating_system(), path, limit);
}

Result<void> save_whole(const std::string& path, std::string_view bytes) {
  return detail::save_whole(operating_system(), path, bytes);
}

}  // namespace somato
