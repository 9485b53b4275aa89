#include "folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <string>
#include <string_view>
#include <system_error>

namespace somato::program {

namespace {

// ".somato-PROCESS-NUMBER.partial" of a process that was killed (somato/files/whole_file.h).
bool is_left_behind(const std::string& name) {
  constexpr std::string_view kBegin = ".somato-";
  if (!name.starts_with(kBegin) || !name.ends_with(".partial")) return false;
  pid_t process = 0;
  const char* const digits = name.data() + kBegin.size();
  const auto [end, status] = std::from_chars(digits, name.data() + name.size(), process);
  if (status != std::errc() || process <= 0 || *end != '-') return false;
  return kill(process, 0) != 0 && errno == ESRCH;
}

void remove_partial_files(const std::filesystem::path& folder) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, ignored)) {
    if (is_left_behind(entry.path().filename().string())) {
      std::filesystem::remove(entry.path(), ignored);
    }
  }
}

}  // namespace

Result<FolderLock> FolderLock::take(const std::filesystem::path& folder) {
  FolderLock lock(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (lock.folder_ < 0) return lock;
  if (flock(lock.folder_, LOCK_EX | LOCK_NB) == 0) {
    remove_partial_files(folder);
    return lock;
  }
  if (errno != EWOULDBLOCK) return lock;
  return fail(ErrorKind::kSystem, "another run of somato works in this folder", folder.string(),
              "wait for its end, or give another folder");
}

FolderLock::~FolderLock() {
  if (folder_ >= 0) close(folder_);
}

}  // namespace somato::program
