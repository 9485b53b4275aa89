#include "flags/man_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "flags/usage.h"
#include "version.h"

namespace somato::program {
namespace {

// A text in roff; a line that begins with a dot or an apostrophe would be a request.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n')) out += "\\&";
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else {
      out += c;
    }
  }
  return out;
}

std::string tagged(const std::string& tag, const std::string& text) {
  return fmt::format(".TP\n.B {}\n{}\n", escaped(tag), escaped(text));
}

// "-o,--output" as "-o, --output".
std::string spelled(const Flag& flag) {
  std::string names;
  for (const char c : flag.name) names += c == ',' ? std::string(", ") : std::string(1, c);
  return flag.takes_value ? names + " VALUE" : names;
}

std::string section_of(const Command& command) {
  std::string text =
      fmt::format(".SS {}\n{}.\n", escaped(usage_of(command)), escaped(command.text));
  for (const Positional& positional : command.positionals) {
    text += tagged(positional.name, positional.text + ".");
  }
  for (const Flag& flag : command.flags) {
    text += tagged(spelled(flag), flag.text + (flag.required ? "; required." : "."));
  }
  for (const ParameterInfo& info : command.parameters) {
    text += tagged(flag_of(info.name) + " VALUE", parameter_description(info));
  }
  return text;
}

}  // namespace

std::string man_page(const std::vector<Command>& commands) {
  std::string page = fmt::format(
      ".TH SOMATO 1 \"\" \"somato {}\" \"User Commands\"\n.SH NAME\n"
      "somato \\- haptic perception with self\\-organizing maps\n.SH SYNOPSIS\n"
      ".B somato\nCOMMAND [ARGUMENTS] [FLAGS]\n.SH DESCRIPTION\n"
      "Somato trains self\\-organizing maps on any data, explores objects with simulated hands and "
      "probes, and runs the haptic systems of Johnsson and Balkenius on simulated or real "
      "recordings.\n.SH COMMANDS\n"
      "Every command takes \\-\\-help and \\-\\-quiet. The file name \\- stands for "
      "standard input or output.\n",
      SOMATO_VERSION);
  for (const Command& command : commands) page += section_of(command);
  page += ".SH EXIT STATUS\n" + tagged("0", "Done.") + tagged("1", "Data or system error.") +
          tagged("2", "Usage error.") + tagged("3", "Completed with losses, which are reported.") +
          tagged("130, 143", "Interrupted.");
  page +=
      ".SH EXAMPLES\n.nf\nsomato som train data.csv \\-o my.map \\-\\-standardize\n"
      "somato som quality my.map data.csv\nsomato som plot my.map data.csv \\-o my.svg\n.fi\n";
  return page;
}

}  // namespace somato::program
