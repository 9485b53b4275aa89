#include "base/files/file_system.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

namespace somato {
namespace {

constexpr unsigned kPermissionBits = 0777;

int flags_of(Opening opening) {
  switch (opening) {
    case Opening::kRead:
      return O_RDONLY;
    case Opening::kOverwrite:
      return O_WRONLY;
    case Opening::kTruncate:
      return O_WRONLY | O_TRUNC;
    case Opening::kCreate:
      return O_WRONLY | O_CREAT | O_EXCL;
    case Opening::kFolder:
      return O_RDONLY | O_DIRECTORY;
  }
  return O_RDONLY;
}

FileStatus::Kind kind_of(mode_t mode) {
  if (S_ISREG(mode)) return FileStatus::Kind::kRegular;
  return S_ISDIR(mode) ? FileStatus::Kind::kDirectory : FileStatus::Kind::kOther;
}

Outcome<void> done(int returned) {
  if (returned < 0) return tl::unexpected<int>(errno);
  return {};
}

Outcome<std::size_t> counted(ssize_t returned) {
  if (returned < 0) return tl::unexpected<int>(errno);
  return static_cast<std::size_t>(returned);
}

class OperatingSystem final : public FileSystem {
 public:
  Outcome<int> open(const std::string& path, Opening opening) override {
    const int file = ::open(path.c_str(), flags_of(opening) | O_CLOEXEC, 0666);
    if (file < 0) return tl::unexpected<int>(errno);
    return file;
  }

  Outcome<FileStatus> status(int file) override {
    struct stat found{};
    if (::fstat(file, &found) < 0) return tl::unexpected<int>(errno);
    constexpr std::int64_t kNanoseconds = 1000000000;
    return FileStatus{kind_of(found.st_mode),
                      static_cast<std::size_t>(found.st_size),
                      found.st_mtim.tv_sec * kNanoseconds + found.st_mtim.tv_nsec,
                      found.st_mode & kPermissionBits,
                      found.st_uid,
                      found.st_gid,
                      static_cast<std::size_t>(found.st_nlink)};
  }

  Outcome<std::size_t> read(int file, char* bytes, std::size_t count) override {
    return counted(::read(file, bytes, count));
  }

  Outcome<std::size_t> read_at(int file, std::size_t place, char* bytes,
                               std::size_t count) override {
    return counted(::pread(file, bytes, count, static_cast<off_t>(place)));
  }

  Outcome<std::size_t> write(int file, std::string_view bytes) override {
    return counted(::write(file, bytes.data(), bytes.size()));
  }

  // Changing the owner of a file usually requires the superuser; otherwise the file belongs to this
  // user.
  Outcome<void> set_permissions(int file, const FileStatus& like) override {
    [[maybe_unused]] const int refused = ::fchown(file, like.owner, like.group);
    return done(::fchmod(file, like.permissions));
  }

  Outcome<void> flush(int file) override { return done(::fsync(file)); }
  Outcome<void> lock(int file) override { return done(::flock(file, LOCK_EX | LOCK_NB)); }
  Outcome<void> close(int file) override { return done(::close(file)); }

  Outcome<void> rename(const std::string& from, const std::string& to) override {
    return done(std::rename(from.c_str(), to.c_str()));
  }

  Outcome<void> remove(const std::string& path) override { return done(::unlink(path.c_str())); }
};

}  // namespace

FileSystem& operating_system() {
  static OperatingSystem instance;
  return instance;
}

}  // namespace somato
