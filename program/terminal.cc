#include "terminal.h"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <memory>
#include <string_view>
#include <utility>

namespace somato::program {
namespace {

// Lock-free, so that a signal may set it.
std::atomic<int> interrupted = 0;
std::atomic<bool> quiet = false;
std::atomic<void (*)(int)> last_handler = SIG_DFL;

void on_interrupt(int signal) {
  interrupted = signal;
  std::signal(signal, last_handler);
  constexpr std::string_view kSaid = "\nsomato: stopping; press Ctrl-C again to end immediately\n";
  if (isatty(STDERR_FILENO) == 1 && !quiet) {
    [[maybe_unused]] const auto written = write(STDERR_FILENO, kSaid.data(), kSaid.size());
  }
}

std::string duration(double seconds) {
  const long whole = std::lround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

// One line that is rewritten at most ten times per second.
class ProgressLine {
 public:
  explicit ProgressLine(std::string what) : what_(std::move(what)) {}
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine(ProgressLine&&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ProgressLine& operator=(ProgressLine&&) = delete;
  ~ProgressLine() { end(); }

  // Later output starts on a new line.
  void end() {
    if (std::exchange(begun_, false)) std::fputs("\n", stderr);
  }

  void show(std::uint64_t done, std::uint64_t total) {
    const auto now = Clock::now();
    const bool finished = done == total;
    if (!finished && now - shown_ < std::chrono::milliseconds(100)) return;
    shown_ = now;
    const double elapsed = std::chrono::duration<double>(now - started_).count();
    const double share = static_cast<double>(done) / static_cast<double>(total);
    const std::string line = fmt::format(
        "\r{}: {:3.0f} %{}\033[K{}", what_, 100.0 * share,
        finished ? ", took " + duration(elapsed) : time_left(elapsed, share), finished ? "\n" : "");
    std::fputs(line.c_str(), stderr);
    begun_ = !finished;
  }

 private:
  // No estimate before the first step.
  static std::string time_left(double elapsed, double share) {
    return share > 0.0 ? fmt::format(", {} left", duration(elapsed / share - elapsed)) : "";
  }

  using Clock = std::chrono::steady_clock;

  std::string what_;
  bool begun_ = false;
  Clock::time_point started_ = Clock::now();
  Clock::time_point shown_{};
};

// Signals that the caller ignores (nohup, a background job) remain ignored.
void catch_signal(int signal) {
  if (std::signal(signal, on_interrupt) == SIG_IGN) std::signal(signal, SIG_IGN);
}

}  // namespace

void be_quiet() {
  quiet = true;
}

bool is_quiet() {
  return quiet;
}

void print_summary(const std::string& text) {
  if (!quiet) std::fputs(text.c_str(), stdout);
}

void report_file_size_limits() {
  std::signal(SIGXFSZ, SIG_IGN);
}

void catch_stop_requests() {
  catch_signal(SIGINT);
  catch_signal(SIGTERM);
}

void on_last_signal(void (*handler)(int)) {
  last_handler = handler != nullptr ? handler : SIG_DFL;
  for (const int signal : {SIGHUP, SIGQUIT, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV}) {
    std::signal(signal, last_handler);
  }
}

bool stop_requested() {
  return interrupted != 0;
}

int stop_signal() {
  return interrupted != 0 ? interrupted.load() : SIGINT;
}

Progress terminal_progress(std::string what) {
  catch_stop_requests();
  std::shared_ptr<ProgressLine> line;
  if (isatty(STDERR_FILENO) != 0 && !quiet) line = std::make_shared<ProgressLine>(std::move(what));
  return [line](std::uint64_t done, std::uint64_t total) {
    if (line) line->show(done, total);
    if (interrupted != 0 && line) line->end();
    return interrupted == 0;
  };
}

}  // namespace somato::program
