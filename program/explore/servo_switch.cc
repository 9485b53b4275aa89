#include "explore/servo_switch.h"

#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <thread>

#include "terminal/terminal.h"

namespace somato::program {
namespace {

// Read by a signal handler: plain memory and lock-free numbers.
std::array<std::uint8_t, 4096> relax{};
std::atomic<std::size_t> relax_size = 0;
std::atomic<int> relax_descriptor = -1;

// Only functions that a signal handler may call.
void relax_and_end(int signal) {
  const std::size_t size = relax_size;
  constexpr int kPatienceMs = 50;  // for a line that is still sending
  for (std::size_t sent = 0; sent < size;) {
    pollfd line{relax_descriptor, POLLOUT, 0};
    if (poll(&line, 1, kPatienceMs) <= 0) break;
    const ssize_t count = write(relax_descriptor, relax.data() + sent, size - sent);
    if (count <= 0) break;
    sent += static_cast<std::size_t>(count);
  }
  std::signal(signal, SIG_DFL);
  raise(signal);
}

class StopKey {
 public:
  StopKey() {
    tcgetattr(STDIN_FILENO, &before_);
    termios keys = before_;
    keys.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    tcsetattr(STDIN_FILENO, TCSANOW, &keys);
    thread_ = std::thread([this] { watch(); });
  }
  StopKey(const StopKey&) = delete;
  StopKey(StopKey&&) = delete;
  StopKey& operator=(const StopKey&) = delete;
  StopKey& operator=(StopKey&&) = delete;
  ~StopKey() {
    ends_ = true;
    thread_.join();
    tcsetattr(STDIN_FILENO, TCSANOW, &before_);
  }

 private:
  void watch() const {
    constexpr int kPollMs = 20;
    constexpr char kEscape = 27;
    while (!ends_) {
      pollfd input{STDIN_FILENO, POLLIN, 0};
      char key = 0;
      if (poll(&input, 1, kPollMs) <= 0) continue;
      if (read(STDIN_FILENO, &key, 1) <= 0) return;
      if (key == ' ' || key == kEscape) kill(getpid(), SIGINT);
    }
  }

  termios before_{};
  std::atomic<bool> ends_ = false;
  std::thread thread_;
};

}  // namespace

void switch_off_at_the_end(int descriptor, std::span<const std::uint8_t> relax_bytes) {
  relax_size = 0;
  relax_descriptor = descriptor;
  const std::size_t size = std::min(relax_bytes.size(), relax.size());
  std::copy_n(relax_bytes.begin(), size, relax.begin());
  relax_size = size;
  on_last_signal(size > 0 ? relax_and_end : nullptr);
}

std::shared_ptr<void> watch_stop_key() {
  // A program in the background must not touch the terminal.
  if (isatty(STDIN_FILENO) != 1 || tcgetpgrp(STDIN_FILENO) != getpgrp()) return nullptr;
  return std::make_shared<StopKey>();
}

}  // namespace somato::program
