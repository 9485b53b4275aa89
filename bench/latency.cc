// The time from a frame at a serial line to the answer of a program, for scripts/latency.py:
//
//   latency FRAMES PORT COMMAND...
//
// An emulated sensor board with 45 taxels sends FRAMES frames at 1 kHz into a pseudo-terminal,
// whose port becomes the symbolic link PORT. COMMAND, which is 'somato live' with a device at that
// port, answers with lines. The number of a frame is in the taxel that is touched and in the
// amount of the touch, so that the name and the distance of the winner determine the newest frame
// that an answer includes. The latency of a frame lasts from the moment at which it is given to the
// line until the first line of an answer that includes it, or a later frame, is read. Prints JSON
// with microseconds.

#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "hardware/emulation/sensor_board.h"
#include "hardware/lines/serial_port.h"

namespace somato {
namespace {

constexpr std::size_t kTaxels = 45;
constexpr std::size_t kLevels = 16;                      // of the touch
constexpr double kLevel = 0.125;                         // between two of them
constexpr double kCounts = 1000.0;                       // of the board, for a touch of 1
constexpr std::size_t kNumbers = kTaxels * kLevels;      // frames with different numbers
constexpr std::int64_t kPeriod = 1'000'000;              // ns
constexpr std::size_t kWarm = 1000;                      // frames before the first that counts
constexpr int kPriority = 60;                            // above that of the program
constexpr std::int64_t kPatience = 30'000'000'000;       // ns without an answer
constexpr std::int64_t kStall = kPeriod * kNumbers / 2;  // a longer one makes numbers ambiguous

std::int64_t now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec * 1'000'000'000 + time.tv_nsec;
}

void sleep_until(std::int64_t when) {
  const timespec time{when / 1'000'000'000, when % 1'000'000'000};
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr) != 0) {
  }
}

[[noreturn]] void give_up(const std::string& why) {
  std::cerr << "latency: " << why << "\n";
  std::exit(1);
}

// Sends frames and notes when. Frames that the line does not take are lost, as on a real one.
class Sender {
 public:
  Sender(wire::PseudoTerminal& line, std::size_t most) : line_(line), sent_(most) {}

  void run() {
    std::array<float, kTaxels> values{};
    std::vector<std::uint8_t> bytes;
    const std::int64_t start = now();
    for (std::size_t frame = 0; frame < sent_.size() && !stopping_; ++frame) {
      values.fill(0.0F);
      const std::size_t level = frame / kTaxels % kLevels;
      values[frame % kTaxels] =
          static_cast<float>(kCounts * (1.0 + kLevel * static_cast<double>(level)));
      board_.set_values(values);
      const auto due = static_cast<std::int64_t>(frame + 1) * kPeriod;
      sleep_until(start + due);
      bytes.clear();
      board_.advance(1e-9 * static_cast<double>(due) + 1e-7, bytes);
      sent_[frame] = give(bytes) ? given_ : 0;
      count_.store(frame + 1, std::memory_order_release);
    }
  }

  void stop() { stopping_ = true; }
  std::size_t count() const { return count_.load(std::memory_order_acquire); }

  /// 0: the line did not take it.
  std::int64_t time_of(std::size_t frame) const { return sent_[frame]; }

 private:
  // Whether the line takes the whole frame now. What it did not take of a frame that was begun
  // comes before the next one.
  bool give(std::vector<std::uint8_t>& bytes) {
    given_ = now();
    write(rest_);
    if (!rest_.empty()) return false;
    const std::size_t whole = bytes.size();
    write(bytes);
    if (bytes.size() < whole) rest_ = bytes;
    return bytes.empty();
  }

  // Removes what was taken.
  void write(std::vector<std::uint8_t>& bytes) {
    const auto taken = wire::write_available(line_.device.number(), bytes, line_.port);
    if (!taken) return;
    bytes.erase(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(*taken));
  }

  wire::PseudoTerminal& line_;
  emulation::SensorBoard board_{{devices::FrameFormat::kFrames, kTaxels, 1e9 / kPeriod, 25.0F,
                                 wire::SensorValueType::kInt16}};
  std::vector<std::int64_t> sent_;
  std::vector<std::uint8_t> rest_;
  std::int64_t given_ = 0;
  std::atomic<std::size_t> count_ = 0;
  std::atomic<bool> stopping_ = false;
};

// The number in an answer: "value":"taxel7" is the taxel 7, and the distance of its neuron the
// level.
std::optional<std::size_t> number_in(std::string_view line) {
  const auto read = [&](std::string_view key, auto value) -> std::optional<decltype(value)> {
    const std::size_t place = line.find(key);
    if (place == std::string_view::npos) return {};
    const auto done =
        std::from_chars(line.data() + place + key.size(), line.data() + line.size(), value);
    if (done.ec != std::errc()) return {};
    return value;
  };
  const auto taxel = read("\"value\":\"taxel", std::size_t{0});
  const auto distance = read("\"distance\":", 0.0);
  if (!taxel || !distance || *taxel >= kTaxels) return {};
  const long level = std::lround(*distance / kLevel);
  if (level < 0 || level >= static_cast<long>(kLevels)) return {};
  return static_cast<std::size_t>(level) * kTaxels + *taxel;
}

// Finds the frames that answers include, and their latencies.
class Latencies {
 public:
  Latencies(const Sender& sender, std::size_t frames) : sender_(sender) { all_.reserve(frames); }

  void take(std::string_view line, std::int64_t time) {
    const std::size_t sent = sender_.count();
    const auto number = number_in(line);
    if (!number || sent == 0) {
      unread_ += begun_ ? 1 : 0;
      return;
    }
    const std::size_t last = sent - 1;
    const std::size_t back = (last % kNumbers + kNumbers - *number) % kNumbers;
    if (back > last) return;
    const std::size_t known = last - back;
    if (!begun_) {
      begun_ = true;
      next_ = known + 1;
      first_ = known + kWarm;
    }
    stalls_ += answered_ != 0 && time - answered_ > kStall ? 1 : 0;
    answered_ = time;
    for (; next_ <= known; ++next_) add(next_, time);
  }

  bool has(std::size_t frames) const { return all_.size() >= frames; }
  std::int64_t answered() const { return answered_; }

  void print() {
    std::sort(all_.begin(), all_.end());
    const auto share = [&](double part) {
      const auto place = static_cast<std::size_t>(part * static_cast<double>(all_.size() - 1));
      return static_cast<double>(all_[place]) * 1e-3;
    };
    std::cout << "{\"frames\":" << all_.size() << ",\"lost\":" << lost_ << ",\"unread\":" << unread_
              << ",\"stalls\":" << stalls_ << ",\"median\":" << share(0.5)
              << ",\"p99\":" << share(0.99) << ",\"p99_9\":" << share(0.999)
              << ",\"worst\":" << share(1.0) << "}" << std::endl;
  }

 private:
  void add(std::size_t frame, std::int64_t time) {
    if (frame < first_) return;
    if (sender_.time_of(frame) == 0) {
      ++lost_;
    } else {
      all_.push_back(time - sender_.time_of(frame));
    }
  }

  const Sender& sender_;
  std::vector<std::int64_t> all_;
  bool begun_ = false;
  std::size_t next_ = 0;   // The first frame that is not answered.
  std::size_t first_ = 0;  // The first one that counts.
  std::size_t lost_ = 0;
  std::size_t unread_ = 0;
  std::size_t stalls_ = 0;
  std::int64_t answered_ = 0;
};

// The measured program; its input is one empty line, by which a person confirms that the thing is
// placed.
struct Child {
  pid_t pid = -1;
  int output = -1;
};

Child start(char** command) {
  std::array<int, 2> in{};
  std::array<int, 2> out{};
  if (pipe(in.data()) != 0 || pipe(out.data()) != 0) give_up("no pipe");
  const pid_t pid = fork();
  if (pid == 0) {
    dup2(in[0], STDIN_FILENO);
    dup2(out[1], STDOUT_FILENO);
    for (const int end : {in[0], in[1], out[0], out[1]}) close(end);
    execv(command[0], command);
    _exit(127);
  }
  close(in[0]);
  close(out[1]);
  if (pid < 0 || write(in[1], "\n", 1) != 1) give_up("cannot start the program");
  return {pid, out[0]};
}

void read_answers(int output, std::size_t frames, Latencies& latencies) {
  std::string text;
  std::array<char, 65536> part{};
  const std::int64_t begin = now();
  while (!latencies.has(frames)) {
    pollfd ready{output, POLLIN, 0};
    poll(&ready, 1, 100);
    const std::int64_t time = now();
    if (time - std::max(begin, latencies.answered()) > kPatience) give_up("no answers");
    if ((ready.revents & (POLLIN | POLLHUP)) == 0) continue;
    const ssize_t count = read(output, part.data(), part.size());
    if (count <= 0) give_up("the program has ended");
    text.append(part.data(), static_cast<std::size_t>(count));
    std::size_t line = 0;
    for (std::size_t end = 0; (end = text.find('\n', line)) != std::string::npos; line = end + 1) {
      latencies.take(std::string_view(text).substr(line, end - line), time);
    }
    text.erase(0, line);
  }
}

// This program must not add latency of its own.
void take_priority() {
  sched_param parameter{};
  parameter.sched_priority = kPriority;
  if (sched_setscheduler(0, SCHED_FIFO, &parameter) != 0 || mlockall(MCL_CURRENT) != 0) {
    std::cerr << "latency: without a real-time priority, this program adds latency of its own\n";
  }
}

void measure(std::size_t frames, const std::string& port, char** command) {
  auto line = wire::open_pseudo_terminal();
  if (!line) give_up(to_string(line.error()));
  std::filesystem::remove(port);
  std::filesystem::create_symlink(line->port, port);
  const Child child = start(command);
  take_priority();  // Not the child's; the sender inherits it.
  Sender sender(*line, frames * 2 + 600'000);
  Latencies latencies(sender, frames);
  std::thread sending([&] { sender.run(); });
  read_answers(child.output, frames, latencies);
  sender.stop();
  sending.join();
  kill(child.pid, SIGINT);
  close(child.output);
  int status = 0;
  waitpid(child.pid, &status, 0);
  latencies.print();
}

}  // namespace
}  // namespace somato

int main(int count, char** words) {
  std::size_t frames = 0;
  const std::string_view number = count > 3 ? words[1] : "";
  const auto read = std::from_chars(number.data(), number.data() + number.size(), frames);
  if (read.ec != std::errc() || frames == 0) {
    std::cerr << "usage: latency FRAMES PORT COMMAND...\n";
    return 2;
  }
  signal(SIGPIPE, SIG_IGN);
  somato::measure(frames, words[2], words + 3);
}
