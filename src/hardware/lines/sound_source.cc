#include "hardware/lines/sound_source.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iterator>
#include <thread>
#include <utility>
#include <vector>

#include "base/arrays/wav.h"

extern char** environ;  // NOLINT(readability-redundant-declaration): POSIX leaves it to the program

namespace somato::wire {
namespace {

using Bytes = std::vector<std::uint8_t>;

tl::unexpected<Error> no_sound(ErrorKind kind, std::string what, const std::string& source,
                               std::string advice) {
  return fail(kind, std::move(what), source, std::move(advice));
}

tl::unexpected<Error> system_error(const char* what, const std::string& source) {
  return no_sound(ErrorKind::kSystem, fmt::format("{}: {}", what, std::strerror(errno)), source,
                  "check 'source' of [microphone]");
}

Result<Descriptor> open_raw(const std::string& path) {
  Descriptor opened(open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  if (opened.is_open()) return opened;
  return system_error("cannot open the sound", path);
}

// The samples of a WAV file, 16 bits each.
Result<Bytes> wav_samples(const std::string& path, double rate) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return system_error("cannot open the sound", path);
  const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  SOMATO_TRY(const Sound sound, decode_wav(bytes, path));
  if (sound.samples.columns() != 1) {
    return no_sound(ErrorKind::kData,
                    fmt::format("the file has {} channels, not one", sound.samples.columns()), path,
                    "convert it, for example with: sox FILE -c 1 NEW.wav");
  }
  if (sound.rate != rate) {
    return no_sound(ErrorKind::kData,
                    fmt::format("the file has {} samples per second, not {:g}", sound.rate, rate),
                    path, "correct 'rate' of [microphone], or convert the file");
  }
  Bytes samples;
  samples.reserve(2 * sound.samples.rows());
  for (const float value : sound.samples.values()) {
    const float count = std::round(value * 32768.0F);
    if (count < -32768.0F || count > 32768.0F) {
      return no_sound(ErrorKind::kData, fmt::format("a sample is {:g}, beyond 1", value), path,
                      "lower its volume, for example with: sox FILE --norm NEW.wav");
    }
    const auto bits =
        static_cast<std::uint16_t>(static_cast<std::int16_t>(std::min(count, 32767.0F)));
    samples.push_back(static_cast<std::uint8_t>(bits & 0xFFU));
    samples.push_back(static_cast<std::uint8_t>(bits >> 8U));
  }
  return samples;
}

// Sends the samples when they are due, until all are sent or the other side is closed.
void play(const Descriptor& to, const Bytes& samples, double rate) {
  constexpr auto kPause = std::chrono::milliseconds(5);
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t sent = 0; sent < samples.size();) {
    std::this_thread::sleep_for(kPause);
    const double passed =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const std::size_t due = std::min(samples.size(), 2 * static_cast<std::size_t>(passed * rate));
    while (sent < due) {
      const ssize_t count = send(to.number(), samples.data() + sent, due - sent, MSG_NOSIGNAL);
      if (count < 0) return;
      sent += static_cast<std::size_t>(count);
    }
  }
}

Result<Descriptor> open_wav(const std::string& path, double rate) {
  SOMATO_TRY(auto samples, wav_samples(path, rate));
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    return system_error("cannot play the sound", path);
  }
  Descriptor ours(ends[0]);
  fcntl(ours.number(), F_SETFL, O_NONBLOCK);
  std::thread([to = Descriptor(ends[1]), samples = std::move(samples), rate] {
    play(to, samples, rate);
  }).detach();
  return ours;
}

struct Pipe {
  Descriptor ours;
  Descriptor theirs;
};

Result<Pipe> open_pipe(const std::string& source) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return system_error("cannot record sound", source);
  fcntl(ends[0], F_SETFL, O_NONBLOCK);
  return Pipe{Descriptor(ends[0]), Descriptor(ends[1])};
}

// The environment with messages in English, which fault_in_words() reads.
std::vector<char*> english_environment() {
  static std::string english = "LC_ALL=C";
  std::vector<char*> variables;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view text(*variable);
    if (!text.starts_with("LC_ALL=") && !text.starts_with("LANGUAGE=")) {
      variables.push_back(*variable);
    }
  }
  variables.push_back(english.data());
  variables.push_back(nullptr);
  return variables;
}

// ALSA's recorder writes to a pipe, and its messages to another one.
Result<SoundSource> open_alsa(const std::string& device, double rate) {
  SOMATO_TRY(Pipe samples, open_pipe(device));
  SOMATO_TRY(Pipe words, open_pipe(device));
  std::array<std::string, 11> arguments{"arecord",
                                        "-D",
                                        device,
                                        "-t",
                                        "raw",
                                        "-f",
                                        "S16_LE",
                                        "-c",
                                        "1",
                                        "-r",
                                        fmt::format("{:.0f}", rate)};
  std::vector<char*> pointers;
  pointers.reserve(arguments.size() + 1);
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t actions{};
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, samples.theirs.number(), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, words.theirs.number(), STDERR_FILENO);
  pid_t process = 0;
  const int failed = posix_spawnp(&process, "arecord", &actions, nullptr, pointers.data(),
                                  english_environment().data());
  posix_spawn_file_actions_destroy(&actions);
  if (failed == 0) {
    return SoundSource{std::move(samples.ours), std::move(words.ours), Recorder(process)};
  }
  return no_sound(ErrorKind::kSystem,
                  fmt::format("cannot start arecord: {}", std::strerror(failed)), device,
                  "install it, on Debian with: sudo apt-get install alsa-utils");
}

Result<SoundSource> only_samples(Result<Descriptor> opened) {
  return std::move(opened).map(
      [](Descriptor samples) { return SoundSource{std::move(samples), Descriptor(), Recorder()}; });
}

// The last line of `words` with `text` in it.
std::string_view line_with(std::string_view words, std::string_view text) {
  const std::size_t found = words.rfind(text);
  if (found == std::string_view::npos) return {};
  const std::size_t before = words.rfind('\n', found);
  const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
  return words.substr(begin, words.find('\n', found) - begin);
}

}  // namespace

// It has nothing to finish, and must let go of its device before another one starts.
Recorder::~Recorder() {
  if (process_ <= 0) return;
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

Result<SoundSource> open_sound(const std::string& source, double rate) {
  const std::size_t colon = source.find(':');
  const std::string kind = source.substr(0, colon);
  const std::string name = colon == std::string::npos ? "" : source.substr(colon + 1);
  if (kind == "raw") return only_samples(open_raw(name));
  if (kind == "wav") return only_samples(open_wav(name, rate));
  if (kind == "alsa") return open_alsa(name, rate);
  return no_sound(ErrorKind::kUsage, "this is no source of sound", source,
                  "use alsa:DEVICE, wav:FILE or raw:FILE");
}

std::optional<Error> fault_in_words(std::string_view words, const std::string& source) {
  const auto fault = [&](std::string_view sign, const char* what, std::string advice) {
    const std::string_view line = line_with(words, sign);
    if (line.empty()) return std::optional<Error>();
    return std::optional(
        Error{ErrorKind::kSystem, fmt::format("{}: {}", what, line), source, std::move(advice)});
  };
  if (auto busy = fault("Device or resource busy", "the sound device is in use",
                        "end the program that uses it; 'fuser -v /dev/snd/*' names it")) {
    return busy;
  }
  if (auto rate = fault("rate is not accurate", "the sound device has another rate",
                        "set this rate as 'rate' of [microphone], or use source = "
                        "\"alsa:plughw:...\", which converts the rate")) {
    return rate;
  }
  return fault("overrun!!!", "samples of the microphone were lost",
               "use a computer that is less busy, or a lower 'rate'");
}

Error ended_sound(std::string_view words, const std::string& source) {
  if (auto fault = fault_in_words(words, source)) return *fault;
  while (words.ends_with('\n')) words.remove_suffix(1);
  const std::size_t last = words.rfind('\n') + 1;  // 0 without one.
  return {ErrorKind::kSystem,
          words.empty() ? "the sound has ended"
                        : fmt::format("the recorder has ended: {}", words.substr(last)),
          source, "check the sound device, and 'source' and 'rate' of [microphone]"};
}

}  // namespace somato::wire
