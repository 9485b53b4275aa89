#include "base/support/run_program.h"

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>

namespace somato {
namespace {

using Clock = std::chrono::steady_clock;

struct Ends {
  int ours = -1;
  int theirs = -1;
};

Ends open_pipe() {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  return {ends[0], ends[1]};
}

Ends open_terminal() {
  Ends ends;
  if (::openpty(&ends.ours, &ends.theirs, nullptr, nullptr, nullptr) != 0) {
    throw std::runtime_error("no pseudo-terminal");
  }
  ::fcntl(ends.ours, F_SETFD, FD_CLOEXEC);
  ::fcntl(ends.theirs, F_SETFD, FD_CLOEXEC);
  return ends;
}

void limit(int resource, std::size_t most) {
  if (most == 0) return;
  const rlimit limits{most, most};
  if (::setrlimit(static_cast<decltype(RLIMIT_AS)>(resource), &limits) != 0) ::_exit(127);
}

void set_input(const std::string& input_from) {
  const char* file = input_from.empty() ? "/dev/null" : input_from.c_str();
  const int in = ::open(file, O_RDONLY | O_CLOEXEC);
  if (in < 0 || ::dup2(in, STDIN_FILENO) < 0) ::_exit(127);
}

void set_output(const std::string& output_to, int pipe) {
  if (output_to == "closed") {
    ::close(STDOUT_FILENO);
    return;
  }
  const int out = output_to.empty() ? pipe : ::open(output_to.c_str(), O_WRONLY | O_CLOEXEC);
  if (out < 0 || ::dup2(out, STDOUT_FILENO) < 0) ::_exit(127);
}

// A sanitizer's own exit code is 1, as a failure's is.
void set_environment(const ProgramWorld& world) {
  const std::string code = "exitcode=" + std::to_string(kAccused);
  for (const char* name : {"ASAN_OPTIONS", "UBSAN_OPTIONS", "TSAN_OPTIONS", "LSAN_OPTIONS"}) {
    ::setenv(name, code.c_str(), 1);
  }
  for (const auto& [name, value] : world.environment) ::setenv(name.c_str(), value.c_str(), 1);
}

[[noreturn]] void become(const std::vector<std::string>& arguments, const ProgramWorld& world,
                         int out, int err) {
  std::vector<char*> pointers;
  for (const std::string& argument : arguments) {
    pointers.push_back(const_cast<char*>(argument.c_str()));
  }
  pointers.push_back(nullptr);
  set_environment(world);
  std::signal(SIGPIPE, SIG_DFL);
  std::signal(SIGINT, SIG_DFL);
  if (::chdir(world.folder.c_str()) != 0 || ::dup2(err, STDERR_FILENO) < 0) ::_exit(127);
  set_input(world.input_from);
  set_output(world.output_to, out);
  limit(RLIMIT_FSIZE, world.largest_file);
  limit(RLIMIT_AS, world.memory);
  ::execv(pointers[0], pointers.data());
  ::_exit(127);
}

// Reads what is there; false at the end (a terminal says EIO then).
bool take(int from, std::string& to, std::size_t most) {
  char bytes[65536];
  const ssize_t got = ::read(from, bytes, most);
  if (got <= 0) return false;
  to.append(bytes, static_cast<std::size_t>(got));
  return true;
}

class Watch {
 public:
  Watch(pid_t process, const ProgramWorld& world, int out, int err)
      : process_(process), world_(world), streams_{{out, POLLIN, 0}, {err, POLLIN, 0}} {}

  ProgramRun until_the_end() {
    const auto deadline = Clock::now() + std::chrono::seconds(world_.seconds);
    while (streams_[0].fd >= 0 || streams_[1].fd >= 0) {
      if (Clock::now() > deadline && !run_.timed_out) {
        run_.timed_out = true;
        ::kill(process_, SIGKILL);
      }
      const bool wants_interrupt = says_to_interrupt();
      if (::poll(streams_, 2, wants_interrupt ? 0 : 100) > 0) read_streams();
      if (wants_interrupt) interrupt();
    }
    int status = 0;
    rusage used{};
    ::wait4(process_, &status, 0, &used);
    run_.most_memory = static_cast<std::size_t>(used.ru_maxrss) * 1024;
    if (WIFEXITED(status)) run_.exit_code = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) run_.signal = WTERMSIG(status);
    return run_;
  }

 private:
  void read_streams() {
    const std::size_t most = world_.closes_output ? 1 : 65536;
    if (streams_[0].revents != 0) {
      if (!take(streams_[0].fd, run_.out, most) || world_.closes_output) close(streams_[0]);
    }
    if (streams_[1].revents != 0 && !take(streams_[1].fd, run_.err, 65536)) close(streams_[1]);
  }

  bool says_to_interrupt() const {
    return !interrupted_ && !world_.interrupt_at.empty() &&
           run_.err.find(world_.interrupt_at) != std::string::npos;
  }

  // After both streams were looked at once more: what it wrote before is read by then.
  void interrupt() {
    interrupted_ = true;
    if (world_.before_interrupt) world_.before_interrupt(run_.out + run_.err);
    ::kill(process_, world_.interrupt_with);
  }

  static void close(pollfd& stream) {
    ::close(stream.fd);
    stream.fd = -1;
  }

  pid_t process_;
  const ProgramWorld& world_;
  pollfd streams_[2];
  bool interrupted_ = false;
  ProgramRun run_;
};

}  // namespace

bool ProgramRun::accused() const {
  return exit_code == kAccused || err.find("Sanitizer") != std::string::npos ||
         err.find("runtime error: ") != std::string::npos;
}

ProgramRun run_program(const std::vector<std::string>& arguments, const ProgramWorld& world) {
  const Ends out = open_pipe();
  const Ends err = world.terminal ? open_terminal() : open_pipe();
  const pid_t process = ::fork();
  if (process < 0) throw std::runtime_error("cannot start a process");
  if (process == 0) become(arguments, world, out.theirs, err.theirs);
  ::close(out.theirs);
  ::close(err.theirs);
  return Watch(process, world, out.ours, err.ours).until_the_end();
}

}  // namespace somato
