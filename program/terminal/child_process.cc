#include "terminal/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <optional>
#include <thread>
#include <utility>

namespace somato::program {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kFarewell = std::chrono::seconds(3);

// The exit status, once the process has ended.
std::optional<int> wait_for(pid_t process, std::chrono::milliseconds patience) {
  const auto until = Clock::now() + patience;
  for (;;) {
    int status = 0;
    if (::waitpid(process, &status, WNOHANG) == process) return status;
    if (Clock::now() >= until) return {};
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

int spawn(std::vector<std::string>& words, const std::vector<int>& connected, int theirs,
          pid_t& process) {
  posix_spawn_file_actions_t files{};
  posix_spawn_file_actions_init(&files);
  for (const int number : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    posix_spawn_file_actions_addopen(&files, number, "/dev/null", O_RDWR, 0);
  }
  for (const int number : connected) posix_spawn_file_actions_adddup2(&files, theirs, number);
  posix_spawnattr_t attributes{};
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const int error = ::posix_spawnp(&process, words.front().c_str(), &files, &attributes,
                                   arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return error;
}

}  // namespace

Result<ChildProcess> ChildProcess::start(std::vector<std::string> words,
                                         const std::vector<int>& connected) {
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    return fail(ErrorKind::kSystem, fmt::format("cannot be started: {}", std::strerror(errno)),
                words.front());
  }
  pid_t process = 0;
  const int error = spawn(words, connected, ends[1], process);
  ::close(ends[1]);
  if (error == 0) return ChildProcess(words.front(), process, ends[0]);
  ::close(ends[0]);
  return fail(ErrorKind::kSystem, fmt::format("cannot be started: {}", std::strerror(error)),
              words.front());
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : name_(std::move(other.name_)),
      process_(std::exchange(other.process_, 0)),
      connection_(std::exchange(other.connection_, -1)) {}

ChildProcess::~ChildProcess() {
  close();
  if (process_ == 0 || wait_for(process_, kFarewell)) return;
  ::kill(-process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

void ChildProcess::close() {
  if (connection_ >= 0) ::close(std::exchange(connection_, -1));
}

tl::unexpected<Error> ChildProcess::failed(const std::string& what) const {
  return fail(ErrorKind::kSystem, what, name_);
}

Result<void> ChildProcess::send(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(connection_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno != EINTR) return failed("it has ended before its time");
    bytes.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(sent, 0)));
  }
  return {};
}

Result<std::string> ChildProcess::receive(std::chrono::milliseconds patience) {
  pollfd readable{connection_, POLLIN, 0};
  const auto until = Clock::now() + patience;
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now());
    const int ready =
        ::poll(&readable, 1, static_cast<int>(std::max<std::int64_t>(left.count(), 0)));
    if (ready > 0) break;
    if (ready == 0) return failed("it does not answer");
  }
  std::string bytes(std::size_t{1} << 16, '\0');
  const ssize_t count = ::recv(connection_, bytes.data(), bytes.size(), 0);
  bytes.resize(static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  return bytes;
}

Result<void> ChildProcess::finish(std::chrono::milliseconds patience) {
  close();
  const auto status = wait_for(process_, patience);
  if (!status) return failed("it does not end");
  process_ = 0;
  return *status == 0 ? Result<void>() : failed("it has failed");
}

}  // namespace somato::program
