#include "man_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "usage.h"
#include "version.h"

namespace somato::program {
namespace {

// A text as roff shows it; a line that begins with a dot or an apostrophe would be a request.
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
      "somato \\- a self\\-organizing sense of touch\n.SH SYNOPSIS\n"
      ".B somato\nCOMMAND [ARGUMENTS] [FLAGS]\n.SH DESCRIPTION\n"
      "Somato trains self\\-organizing maps on any data, explores things with simulated hands and "
      "probes, and runs the systems of touch of Johnsson and Balkenius on what they feel or on "
      "recordings of real bodies.\n.SH COMMANDS\n"
      "Every command takes \\-\\-help and \\-\\-quiet. Where a file is read or written, \\- is "
      "standard input or output.\n",
      SOMATO_VERSION);
  for (const Command& command : commands) page += section_of(command);
  page += ".SH EXIT STATUS\n" + tagged("0", "Done.") +
          tagged("1", "The data or the machine was at fault.") + tagged("2", "Wrong usage.") +
          tagged("3", "Done with losses, which the messages name.") +
          tagged("130, 143", "Interrupted.");
  page +=
      ".SH EXAMPLES\n.nf\nsomato som train data.csv \\-o my.map \\-\\-standardize\n"
      "somato som quality my.map data.csv\nsomato som plot my.map data.csv \\-o my.svg\n.fi\n";
  return page;
}

}  // namespace somato::program
