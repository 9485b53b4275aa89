// Runs a program, discards its output and reports, as JSON, its duration, its peak memory and its
// status. This program is small, so that its own memory, which the system attributes to the other
// program until that one starts, is never the maximum.
//
//     time_program BYTES COMMAND...
//
// BYTES limits the memory that the program may map, as `ulimit -v` does; 0 does not.

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>

namespace {

// Only returns when the program cannot be started.
void become(rlim_t bytes, char** command) {
  if (bytes != 0) {
    const rlimit limit{bytes, bytes};
    setrlimit(RLIMIT_AS, &limit);
  }
  const int nowhere = open("/dev/null", O_WRONLY);  // NOLINT: the system's own interface
  dup2(nowhere, STDOUT_FILENO);
  execvp(command[0], command);
  std::perror(command[0]);
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 3) return 2;
  const auto begin = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child == 0) {
    become(std::strtoul(arguments[1], nullptr, 10), arguments + 2);
    return 127;
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  std::printf("{\"seconds\": %.6f, \"peak_kib\": %ld, \"status\": %d}\n", took.count(),
              usage.ru_maxrss, status);
  return 0;
}
