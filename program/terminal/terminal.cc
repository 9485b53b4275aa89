#include "terminal/terminal.h"

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
std::atomic<std::size_t> continuations = 0;
std::atomic<bool> quiet = false;
std::atomic<bool> logs = false;
std::atomic<void (*)(int)> last_handler = SIG_DFL;

void on_interrupt(int signal) {
  interrupted = signal;
  // A terminal that is closed may say so twice, to its shell and by it.
  std::signal(signal, signal == SIGHUP ? SIG_IGN : last_handler.load());
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

// One line that is rewritten at most ten times per second on a terminal, or a new line every half
// minute elsewhere.
class ProgressLine {
 public:
  ProgressLine(std::string what, bool is_terminal)
      : what_(std::move(what)), is_terminal_(is_terminal) {
    if (!is_terminal_) shown_ = started_;
  }
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
    const bool is_early = now - shown_ < (is_terminal_ ? kRewritten : kLogged);
    if (is_early && !(finished && is_terminal_)) return;
    shown_ = now;
    const double elapsed = std::chrono::duration<double>(now - started_).count();
    const double share = static_cast<double>(done) / static_cast<double>(total);
    const std::string text =
        fmt::format("{}: {:3.0f} %{}", what_, 100.0 * share,
                    finished ? ", took " + duration(elapsed) : time_left(elapsed, share));
    std::fputs(line(text, finished).c_str(), stderr);
    begun_ = is_terminal_ && !finished;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr Clock::duration kRewritten = std::chrono::milliseconds(100);
  static constexpr Clock::duration kLogged = std::chrono::seconds(30);

  std::string line(const std::string& text, bool finished) const {
    return is_terminal_ ? "\r" + text + "\033[K" + (finished ? "\n" : "") : text + "\n";
  }

  // No estimate before the first step.
  static std::string time_left(double elapsed, double share) {
    return share > 0.0 ? fmt::format(", {} left", duration(elapsed / share - elapsed)) : "";
  }

  std::string what_;
  bool is_terminal_;
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

void log_progress() {
  logs = true;
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
  catch_signal(SIGHUP);
}

void on_last_signal(void (*handler)(int)) {
  last_handler = handler != nullptr ? handler : SIG_DFL;
  for (const int signal : {SIGQUIT, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV}) {
    std::signal(signal, last_handler);
  }
}

bool stop_requested() {
  return interrupted != 0;
}

std::function<std::size_t()> count_continuations() {
  std::signal(SIGCONT, [](int /*signal*/) { ++continuations; });
  return [] { return continuations.load(); };
}

int stop_signal() {
  return interrupted != 0 ? interrupted.load() : SIGINT;
}

Progress terminal_progress(std::string what) {
  catch_stop_requests();
  std::shared_ptr<ProgressLine> line;
  const bool is_terminal = isatty(STDERR_FILENO) != 0;
  if ((is_terminal || logs) && !quiet) {
    line = std::make_shared<ProgressLine>(std::move(what), is_terminal);
  }
  return [line](std::uint64_t done, std::uint64_t total) {
    if (line) line->show(done, total);
    if (interrupted != 0 && line) line->end();
    return interrupted == 0;
  };
}

}  // namespace somato::program
