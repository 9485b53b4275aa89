#include "terminal/name_input.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <cstdio>

#include "base/text/text.h"
#include "terminal/terminal.h"

namespace somato::program {
namespace {

constexpr int kPatience = 50;  // ms between two looks at stop requests

std::string trimmed(const std::string& line) {
  constexpr const char* kSpace = " \t\r";
  const std::size_t begin = line.find_first_not_of(kSpace);
  if (begin == std::string::npos) return {};
  return line.substr(begin, line.find_last_not_of(kSpace) - begin + 1);
}

}  // namespace

std::optional<std::string> NameInput::take() {
  return !has_ended_ && has_line_within(0) ? read_name() : std::nullopt;
}

std::optional<std::string> NameInput::ask(const std::string& question) {
  if (has_ended_) return {};
  if (isatty(STDIN_FILENO) == 1) std::fputs(question.c_str(), stderr);
  while (!stop_requested()) {
    if (has_line_within(kPatience)) return read_name();
  }
  return {};
}

bool NameInput::has_line_within(int milliseconds) {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  return ::poll(&input, 1, milliseconds) > 0;
}

// A line that has begun is read to its end, byte by byte.
std::optional<std::string> NameInput::read_name() {
  std::string line;
  char byte = 0;
  while (!has_ended_ && byte != '\n') {
    if (!has_line_within(kPatience)) {
      if (stop_requested()) return {};
      continue;
    }
    has_ended_ = ::read(STDIN_FILENO, &byte, 1) <= 0;
    if (!has_ended_ && byte != '\n') line.push_back(byte);
  }
  std::string name = trimmed(line);
  if (name.empty() || is_name(name)) {
    return name.empty() ? std::nullopt : std::optional(std::move(name));
  }
  fmt::print(
      stderr,
      "somato: standard input: a name is not used, because it has control characters or more "
      "than {} bytes, or is not UTF-8; give a short name in one line\n",
      kLongestName);
  return {};
}

}  // namespace somato::program
