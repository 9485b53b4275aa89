#include "hardware/lines/sound_source.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <span>
#include <thread>
#include <utility>
#include <vector>

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

std::uint32_t number_at(const Bytes& bytes, std::size_t offset, std::size_t size) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < size; ++i) {
    number |= static_cast<std::uint32_t>(bytes[offset + i]) << (8 * i);
  }
  return number;
}

bool has_name(const Bytes& bytes, std::size_t offset, std::string_view name) {
  return bytes.size() >= offset + name.size() &&
         std::equal(name.begin(), name.end(), bytes.begin() + static_cast<std::ptrdiff_t>(offset));
}

// The chunk of that name: its first byte and its length.
std::pair<std::size_t, std::size_t> chunk(const Bytes& bytes, std::string_view name) {
  constexpr std::size_t kHeader = 8;
  for (std::size_t at = 12; at + kHeader <= bytes.size();) {
    const std::size_t size = number_at(bytes, at + 4, 4);
    if (has_name(bytes, at, name)) {
      return {at + kHeader, std::min(size, bytes.size() - at - kHeader)};
    }
    at += kHeader + size + size % 2;
  }
  return {0, 0};
}

// The samples of a WAV file.
Result<Bytes> wav_samples(const std::string& path, double rate) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return system_error("cannot open the sound", path);
  const Bytes bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const auto [format, format_size] = chunk(bytes, "fmt ");
  const auto [data, size] = chunk(bytes, "data");
  if (!has_name(bytes, 0, "RIFF") || !has_name(bytes, 8, "WAVE") || format_size < 16 || data == 0) {
    return no_sound(ErrorKind::kData, "this is no whole WAV file", path, "give a WAV file");
  }
  const std::uint32_t channels = number_at(bytes, format + 2, 2);
  const std::uint32_t bits = number_at(bytes, format + 14, 2);
  const std::uint32_t file_rate = number_at(bytes, format + 4, 4);
  if (number_at(bytes, format, 2) != 1 || channels != 1 || bits != 16) {
    return no_sound(ErrorKind::kData,
                    fmt::format("the file has {} channels of {} bits", channels, bits), path,
                    "convert it, for example with: sox FILE -c 1 -b 16 NEW.wav");
  }
  if (static_cast<double>(file_rate) != rate) {
    return no_sound(ErrorKind::kData,
                    fmt::format("the file has {} samples per second, not {:g}", file_rate, rate),
                    path, "correct 'rate' of [microphone], or convert the file");
  }
  const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(data);
  return Bytes(begin, begin + static_cast<std::ptrdiff_t>(size - size % 2));
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

// ALSA's recorder writes to a pipe; it ends when its reader does.
Result<Descriptor> open_alsa(const std::string& device, double rate) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return system_error("cannot record sound", device);
  Descriptor ours(ends[0]);
  const Descriptor theirs(ends[1]);
  fcntl(ours.number(), F_SETFL, O_NONBLOCK);
  std::array<std::string, 12> words{"arecord", "-q",  "-D", device,
                                    "-t",      "raw", "-f", "S16_LE",
                                    "-c",      "1",   "-r", fmt::format("{:.0f}", rate)};
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions{};
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, theirs.number(), STDOUT_FILENO);
  pid_t process = 0;
  const int failed =
      posix_spawnp(&process, "arecord", &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed == 0) return ours;
  return no_sound(ErrorKind::kSystem,
                  fmt::format("cannot start arecord: {}", std::strerror(failed)), device,
                  "install it, on Debian with: sudo apt-get install alsa-utils");
}

}  // namespace

Result<Descriptor> open_sound(const std::string& source, double rate) {
  const std::size_t colon = source.find(':');
  const std::string kind = source.substr(0, colon);
  const std::string name = colon == std::string::npos ? "" : source.substr(colon + 1);
  if (kind == "raw") return open_raw(name);
  if (kind == "wav") return open_wav(name, rate);
  if (kind == "alsa") return open_alsa(name, rate);
  return no_sound(ErrorKind::kUsage, "this is no source of sound", source,
                  "use alsa:DEVICE, wav:FILE or raw:FILE");
}

}  // namespace somato::wire
