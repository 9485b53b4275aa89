#include "flags/help_format.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>

namespace somato::program {
namespace {

constexpr std::size_t kNames = 34;  // columns for names of flags and commands

std::size_t columns_of_terminal() {
  constexpr std::size_t kWithout = 100;
  constexpr std::size_t kLeast = 60;
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return kWithout;
  return std::max<std::size_t>(kLeast, size.ws_col);
}

}  // namespace

HelpFormat::HelpFormat() : width_(columns_of_terminal()) {
  column_width(kNames);
}

std::string HelpFormat::make_option(const CLI::Option* option, bool is_positional) const {
  return entry(make_option_name(option, is_positional) + make_option_opts(option),
               make_option_desc(option));
}

std::string HelpFormat::make_subcommand(const CLI::App* command) const {
  return entry(command->get_name(), command->get_description());
}

std::string HelpFormat::entry(const std::string& name, const std::string& text) const {
  std::string out = "  " + name;
  const std::string margin(kNames, ' ');
  if (out.size() + 2 > kNames) {
    out += "\n" + margin;
  } else {
    out.resize(kNames, ' ');
  }
  std::size_t column = kNames;
  std::istringstream words(text);
  for (std::string word; words >> word; column += word.size() + 1) {
    if (column > kNames && column + word.size() > width_) {
      out.back() = '\n';
      out += margin;
      column = kNames;
    }
    out += word + " ";
  }
  out.back() = '\n';
  return out;
}

}  // namespace somato::program
