#include "base/files/replacement.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

namespace somato {
namespace {

constexpr int kMostLinks = 40;

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

// `/dev/stdout` ends in a link below /proc that refers to an open file, not to its name.
bool stands_for_an_open_file(const std::string& link) {
  std::error_code ignored;
  const std::string folder = std::filesystem::canonical(folder_of(link), ignored).string();
  return folder.starts_with("/proc/");
}

struct Target {
  std::string path;
  bool direct = false;  // Written directly, never replaced.
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

}  // namespace

bool is_written_directly(const std::string& path) {
  const Target target = follow_links(path);
  std::error_code ignored;
  const auto status = std::filesystem::status(target.path, ignored);
  const bool is_there = std::filesystem::exists(status);
  return target.direct || (is_there && !std::filesystem::is_regular_file(status) &&
                           !std::filesystem::is_directory(status));
}

Replacement::Replacement(Replacement&& other) noexcept
    : files_(other.files_),
      file_(std::move(other.file_)),
      path_(std::move(other.path_)),
      beside_(std::exchange(other.beside_, {})) {}

Replacement::~Replacement() {
  if (!beside_.empty()) (void)files_->remove(beside_);
}

Result<Replacement> Replacement::begin_beside(FileSystem& files, const std::string& path,
                                              const std::optional<FileStatus>& like) {
  Outcome<NewFile> beside = create_beside(files, path);
  if (!beside) return system_failure("cannot save", path, beside.error());
  Replacement replacement(files, std::move(beside->file), path, beside->path);
  if (!like) return replacement;
  const Outcome<void> taken = replacement.file_.take_permissions(*like);
  if (!taken) return system_failure("cannot save", path, taken.error());
  return replacement;
}

Result<Replacement> Replacement::begin(FileSystem& files, const std::string& path) {
  const Target target = follow_links(path);
  const Opening opening = target.direct ? Opening::kTruncate : Opening::kOverwrite;
  Outcome<OpenFile> existing = OpenFile::open(files, target.path, opening);
  if (!existing && existing.error() == ENOENT && !target.direct) {
    return begin_beside(files, target.path, std::nullopt);
  }
  if (!existing) return system_failure("cannot save", path, existing.error());
  const Outcome<FileStatus> status = existing->status();
  if (!status) return system_failure("cannot save", path, status.error());
  if (target.direct || status->kind != FileStatus::Kind::kRegular) {
    return Replacement(files, std::move(*existing), path, {});
  }
  (void)existing->close();
  return begin_beside(files, target.path, *status);
}

Result<void> Replacement::write(std::string_view bytes) {
  const Outcome<void> written = file_.write_all(bytes);
  if (!written) return system_failure("cannot save", path_, written.error());
  return {};
}

Result<void> Replacement::commit() {
  if (beside_.empty()) {
    const Outcome<void> closed = file_.close();
    if (!closed) return system_failure("cannot save", path_, closed.error());
    return {};
  }
  const Outcome<void> saved = file_.flush().and_then([&] { return file_.close(); }).and_then([&] {
    return uninterrupted([&] { return files_->rename(beside_, path_); });
  });
  if (!saved) return system_failure("cannot save", path_, saved.error());
  beside_.clear();
  const Outcome<void> kept = flush_folder_of(*files_, path_);
  if (!kept) return system_failure("saved, but a power failure may undo it", path_, kept.error());
  return {};
}

}  // namespace somato
