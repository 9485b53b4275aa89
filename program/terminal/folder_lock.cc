#include "terminal/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>

#include "terminal/terminal.h"

namespace somato::program {

namespace {

// ".somato-PROCESS-NUMBER.partial", left by a killed process (somato/files/whole_file.h).
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

int open_folder(const std::filesystem::path& folder) {
  return open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
}

// 0, or the error of locking: EWOULDBLOCK if another process holds the lock.
int lock_now(int folder) {
  return flock(folder, LOCK_EX | LOCK_NB) == 0 ? 0 : errno;
}

}  // namespace

Result<FolderLock> FolderLock::take(const std::filesystem::path& folder) {
  FolderLock lock(open_folder(folder));
  const int reason = lock_now(lock.folder_);
  if (reason == EWOULDBLOCK) {
    return fail(ErrorKind::kSystem, "another somato process is using this folder", folder.string(),
                "wait until it ends, or use another folder");
  }
  if (reason == 0) remove_partial_files(folder);
  return lock;
}

Result<FolderLock> FolderLock::wait(const std::filesystem::path& folder) {
  FolderLock lock(open_folder(folder));
  while (lock_now(lock.folder_) == EWOULDBLOCK) {
    if (stop_requested()) {
      return fail(ErrorKind::kInterrupted,
                  "stopped while another somato process was using this folder", folder.string());
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return lock;
}

FolderLock::~FolderLock() {
  if (folder_ >= 0) close(folder_);
}

}  // namespace somato::program
