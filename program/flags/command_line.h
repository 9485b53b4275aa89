#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"

namespace somato::program {

/// The purpose of an argument's value.
enum class Role {
  kValue,         ///< A number, a name, a choice.
  kInput,         ///< A file or folder that is read, or the name of a built-in file.
  kOutput,        ///< A file that is written.
  kOutputFolder,  ///< A folder that files are written into.
};

/// A positional argument.
struct Positional {
  std::string name;  ///< Upper case, as the usage shows it.
  std::string text;
  bool required = true;
  bool many = false;  ///< Takes all remaining arguments, at least one if it is required.
  Role role = Role::kInput;
  std::function<std::vector<std::string>()> names = {};  ///< Known ones, which shells complete.
};

/// A flag that is not a parameter of a struct, such as an input or output file.
struct Flag {
  std::string name;  ///< Such as "--out" or "-o,--output".
  std::string text;
  bool required = false;
  bool takes_value = true;
  Role role = Role::kValue;
  std::vector<std::string> writes = {};  ///< The names of the files in an output folder.
};

Flag input_flag(std::string name, std::string text, bool required = false);
Flag output_flag(std::string name, std::string text, bool required = false);
Flag folder_flag(std::string name, std::string text, std::vector<std::string> writes = {});

/// The arguments on the command line, by the name of a positional or flag without dashes.
class Arguments {
 public:
  std::map<std::string, std::string> texts;
  std::map<std::string, std::vector<std::string>>
      lists;  ///< The values of positionals that take many.

  bool has(const std::string& name) const { return texts.contains(name); }
  std::string text(const std::string& name) const;

  /// A whole number of at least `least`, or nothing when the flag is absent. Errors: kUsage.
  Result<std::optional<std::size_t>> number(const std::string& name, std::size_t least) const;
};

/// Keys of a table of a file, or of flags.
struct KeyTable {
  std::string title;  ///< Markdown, such as "`[study]`".
  std::vector<ParameterInfo> keys;
  std::string text = {};  ///< Markdown before the table, or nothing.
};

/// A section of the reference: tables of keys that a command reads.
struct KeySection {
  std::string title;
  std::string text;  ///< Markdown.
  std::vector<KeyTable> tables;
};

template <typename Parameters>
KeyTable key_table(std::string title, std::string text = {}) {
  return {std::move(title), Parameters::declarations().infos(), std::move(text)};
}

/// A command of the program.
struct Command {
  std::string name;  ///< One or two words: "run", "som train".
  std::string text;
  std::vector<Positional> positionals;
  std::vector<Flag> flags;
  std::vector<ParameterInfo> parameters;  ///< Each is a flag: radius_start is --radius-start.
  std::function<Result<void>(const Arguments&)> run;
  std::vector<std::string> tables = {};  ///< The tables of the reference with the parameters.
  /// The sections of the reference about the keys that the command, and others with it, read.
  std::vector<KeySection> (*key_sections)() = nullptr;
};

/// The key of a flag in Arguments: that of "-o,--output" is "output".
std::string key_of(const std::string& flag);

/// The flag of a parameter: `radius_start` is `--radius-start`.
std::string flag_of(const std::string& parameter_name);

/// The `known` parameters that were given as flags, with the flag as their location.
Table given_parameters(const Arguments& arguments, const std::vector<ParameterInfo>& known);

/// `parameters` with the values that were given as flags. Errors (kUsage) name the flag.
template <typename S>
Result<S> read_flags(const Arguments& arguments, S parameters = {}) {
  return read_parameters(given_parameters(arguments, S::declarations().infos()),
                         std::move(parameters));
}

/// Runs the command of `argv`. Prints help, the version, and errors on standard error. Returns the
/// program's exit code: 0 success, 1 failure, 2 usage error, 3 completed with losses, 129, 130 or
/// 143 interrupted (128 and the signal).
int run_command_line(int argc, char** argv, const std::vector<Command>& commands);

}  // namespace somato::program
