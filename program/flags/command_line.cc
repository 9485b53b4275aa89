#include "flags/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <new>
#include <optional>
#include <system_error>

#include "base/kernels/instruction_set.h"
#include "base/text/flag_hint.h"
#include "flags/help_format.h"
#include "flags/left_out.h"
#include "flags/output.h"
#include "flags/usage.h"
#include "somato/core/check.h"
#include "terminal/terminal.h"
#include "terminal/wording.h"
#include "version.h"

namespace somato::program {
namespace {

constexpr int kFailed = 1;
constexpr int kWrongUsage = 2;
constexpr int kIncomplete = 3;
constexpr int kSignal = 128;  // and the signal that interrupted it

int exit_code(ErrorKind kind) {
  if (kind == ErrorKind::kUsage) return kWrongUsage;
  if (kind == ErrorKind::kIncomplete) return kIncomplete;
  return kind == ErrorKind::kInterrupted ? kSignal + stop_signal() : kFailed;
}

// If standard error cannot be written, only the exit code reports the failure.
int report(const Error& error) {
  std::fputs(fmt::format("somato: {}\n", printable(to_string(error))).c_str(), stderr);
  return exit_code(error.kind);
}

Error usage_error(const std::string& what, const std::string& where) {
  return {ErrorKind::kUsage, what, where, {}};
}

std::vector<std::string> names_of_flags(const Command& command) {
  std::vector<std::string> flags;
  flags.reserve(command.flags.size());
  for (const Flag& flag : command.flags) flags.push_back(key_of(flag.name));
  for (const ParameterInfo& info : command.parameters) {
    flags.push_back(flag_of(info.name).substr(2));
  }
  return flags;
}

// A command's subparser and its parsed arguments.
class Parser {
 public:
  Parser(CLI::App& app, const Command& command) : app_(app), command_(command) {
    for (const Positional& positional : command.positionals) add_positional(positional);
    for (const Flag& flag : command.flags) add_flag(flag);
    for (const ParameterInfo& info : command.parameters) {
      CLI::Option* option =
          add(flag_of(info.name).substr(2), flag_of(info.name), parameter_description(info));
      option->type_name("VALUE");
      if (info.type == "switch") make_switch(*option);
    }
    const std::string quiet(kQuietText);
    app.add_flag("--quiet", quiet)->disable_flag_override();
  }

  bool chosen() const { return app_.parsed(); }

  Result<void> run() const {
    Arguments arguments;
    for (const auto& [name, option] : options_) {
      if (option->count() == 0) continue;
      SOMATO_TRY_VOID(check(*option));
      arguments.texts[name] = option->results().back();
    }
    for (const auto& [name, option] : lists_) {
      for (const std::string& value : option->results()) {
        if (value.empty()) return fail(usage_error("the value is empty", name));
      }
      if (option->count() > 0) arguments.lists[name] = option->results();
    }
    take_standard_streams(arguments);
    SOMATO_TRY_VOID(check_outputs(command_, arguments));
    if (app_.get_option("--quiet")->count() > 0) be_quiet();
    name_flags_in_messages(names_of_flags(command_));
    return command_.run(arguments);
  }

 private:
  // "-" is standard input for an input file, and standard output for an output file.
  void take_standard_streams(Arguments& arguments) const {
    const auto replace = [&](const std::string& key, Role role) {
      const auto given = arguments.texts.find(key);
      if (given == arguments.texts.end() || given->second != "-") return;
      if (role == Role::kInput) given->second = "/dev/stdin";
      if (role == Role::kOutput) given->second = "/dev/stdout";
    };
    for (const Positional& positional : command_.positionals) {
      replace(positional.name, positional.role);
    }
    for (auto& [name, values] : arguments.lists) {
      std::replace(values.begin(), values.end(), std::string("-"), std::string("/dev/stdin"));
    }
    for (const Flag& flag : command_.flags) replace(key_of(flag.name), flag.role);
  }

  CLI::Option* add(const std::string& key, const std::string& names, const std::string& text) {
    auto value = std::make_unique<std::string>();
    CLI::Option* option = app_.add_option(names, *value, text);
    values_.push_back(std::move(value));
    option->take_last();  // check() reports repeats
    options_[key] = option;
    return option;
  }

  void add_positional(const Positional& positional) {
    CLI::Option* option = nullptr;
    if (positional.many) {
      auto values = std::make_unique<std::vector<std::string>>();
      option = app_.add_option(positional.name, *values, positional.text);
      many_values_.push_back(std::move(values));
      lists_[positional.name] = option;
    } else {
      option = add(positional.name, positional.name, positional.text);
    }
    option->required(positional.required)->type_name("");
  }

  // "--free" without a value means "--free true".
  static void make_switch(CLI::Option& option) {
    option.expected(0, 1);
    option.default_str("true");
    option.type_name("[true|false]");
  }

  static Result<void> check(const CLI::Option& option) {
    if (option.count() > 1) {
      return fail(usage_error(fmt::format("given {} times", option.count()), option.get_name()));
    }
    if (!option.results().back().empty()) return {};
    return fail(usage_error("the value is empty", option.get_name()));
  }

  void add_flag(const Flag& flag) {
    const std::string key = key_of(flag.name);
    if (flag.takes_value) {
      add(key, flag.name, flag.text)->required(flag.required)->type_name("VALUE");
    } else {
      options_[key] = app_.add_flag(flag.name, flag.text)->disable_flag_override();
    }
  }

  CLI::App& app_;
  const Command& command_;
  std::vector<std::unique_ptr<std::string>> values_;
  std::map<std::string, CLI::Option*> options_;
  std::vector<std::unique_ptr<std::vector<std::string>>> many_values_;
  std::map<std::string, CLI::Option*> lists_;
};

std::vector<std::string> names_of_subcommands(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(sub->get_name());
  }
  return names;
}

// The innermost command that was reached before parsing failed.
const CLI::App& innermost(const CLI::App& app) {
  const CLI::App* at = &app;
  while (!at->get_subcommands().empty()) at = at->get_subcommands().front();
  return *at;
}

// "som train"; empty for the program itself.
std::string words_of(const CLI::App& app) {
  if (!app.get_parent()) return {};
  const std::string before = words_of(*app.get_parent());
  return before.empty() ? app.get_name() : before + " " + app.get_name();
}

std::string see_help(const CLI::App& app) {
  const std::string words = words_of(app);
  return fmt::format("see 'somato{}{} --help'", words.empty() ? "" : " ", words);
}

// The most similar name, or the place that lists all names.
Error unknown_flag(const CLI::App& app, const std::string& flag) {
  if (auto error = left_out_flag(flag, words_of(app))) return *error;
  std::vector<std::string> flags;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) flags.push_back("--" + name);
  }
  Error error = unknown_name("flag", flag, words_of(app), flags);
  if (nearest_name(flag, flags).empty()) error.advice = see_help(app);
  return error;
}

Error unexpected_argument(const CLI::App& app, const std::string& argument) {
  if (argument.starts_with("-")) return unknown_flag(app, argument.substr(0, argument.find('=')));
  const std::vector<std::string> commands = names_of_subcommands(app);
  if (!commands.empty()) return unknown_name("command", argument, words_of(app), commands);
  return {ErrorKind::kUsage, fmt::format("unexpected argument '{}'", argument), words_of(app),
          see_help(app)};
}

Error missing(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<std::string> commands = names_of_subcommands(app);
  if (commands.empty()) return {ErrorKind::kUsage, error.what(), words_of(app), see_help(app)};
  return {ErrorKind::kUsage, "a command is missing", words_of(app),
          fmt::format("choose one of {}; {}", fmt::join(commands, ", "), see_help(app))};
}

// Translates the parser's messages about one option, which are "--rows: 1 required VALUE missing"
// or "standardize was given a disallowed flag override".
Error wrong_values(const CLI::App& app, const CLI::ParseError& error) {
  const std::string said = error.what();
  const std::string name = said.substr(0, said.find_first_of(": "));
  const Error wrong = said.ends_with("missing") ? usage_error("a value is missing", name)
                                                : usage_error("takes no value", "--" + name);
  return {wrong.kind, wrong.what, wrong.where, see_help(app)};
}

// The first words that were no command, with the group before them, may be one of another build.
std::optional<Error> of_another_build(const CLI::App& app, const std::vector<std::string>& left) {
  const std::string before = words_of(app);
  const std::string first = before.empty() ? left.front() : before + " " + left.front();
  if (auto error = left_out_command(first)) return error;
  return left.size() > 1 ? left_out_command(first + " " + left[1]) : std::nullopt;
}

int report_parse_error(const CLI::App& root, const CLI::ParseError& error) {
  const CLI::App& app = innermost(root);
  const std::vector<std::string> left = root.remaining(true);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error)) return report(wrong_values(app, error));
  if (left.empty()) return report(missing(app, error));
  return report(of_another_build(app, left).value_or(unexpected_argument(app, left.front())));
}

std::string text_of_group(const std::string& group) {
  if (group == "som") return "Self-organizing maps of any data";
  SOMATO_ASSERT(group == "device");
  return "Real hands and probes at serial lines: check, monitor and calibrate them";
}

// The parser of the command named `words`, below groups such as "som".
CLI::App& place_of(CLI::App& root, const std::string& words, const std::string& text) {
  const std::size_t blank = words.find(' ');
  if (blank == std::string::npos) return *root.add_subcommand(words, text);
  const std::string group = words.substr(0, blank);
  const auto is_group = [&](const CLI::App* app) { return app->get_name() == group; };
  const std::vector<CLI::App*> found = root.get_subcommands(is_group);
  CLI::App* parent =
      found.empty() ? root.add_subcommand(group, text_of_group(group)) : found.front();
  parent->require_subcommand(1);
  return *parent->add_subcommand(words.substr(blank + 1), text);
}

}  // namespace

Flag input_flag(std::string name, std::string text, bool required) {
  return {std::move(name), std::move(text), required, true, Role::kInput};
}

Flag output_flag(std::string name, std::string text, bool required) {
  return {std::move(name), std::move(text), required, true, Role::kOutput};
}

Flag folder_flag(std::string name, std::string text, std::vector<std::string> writes) {
  return {std::move(name), std::move(text), false, true, Role::kOutputFolder, std::move(writes)};
}

std::string key_of(const std::string& flag) {
  return flag.substr(flag.rfind("--") + 2);
}

std::string Arguments::text(const std::string& name) const {
  const auto found = texts.find(name);
  return found == texts.end() ? std::string() : found->second;
}

Result<std::optional<std::size_t>> Arguments::number(const std::string& name,
                                                     std::size_t least) const {
  if (!has(name)) return std::optional<std::size_t>{};
  constexpr std::int64_t kMost = 1'000'000'000'000;
  ParameterInfo info;
  info.name = name;
  info.type = "integer";
  info.range = Range::at_least(static_cast<double>(least));
  Result<std::int64_t> whole =
      detail::read_integer(info, value_from_text(info, text(name)), 0, kMost);
  if (!whole) {
    whole.error().where = "--" + name;
    return fail(std::move(whole.error()));
  }
  return std::optional<std::size_t>(static_cast<std::size_t>(*whole));
}

std::string flag_of(const std::string& parameter_name) {
  std::string flag = "--" + parameter_name;
  for (char& c : flag) c = c == '_' ? '-' : c;
  return flag;
}

Table given_parameters(const Arguments& arguments, const std::vector<ParameterInfo>& known) {
  Table table;
  for (const ParameterInfo& info : known) {
    const std::string flag = flag_of(info.name);
    const auto given = arguments.texts.find(flag.substr(2));
    if (given == arguments.texts.end()) continue;
    table.entries.push_back({info.name, flag, value_from_text(info, given->second)});
  }
  return table;
}

namespace {

// Runs the chosen command; exceptions of the standard library for missing memory, threads or
// disk space become ordinary errors.
Result<void> run_chosen(const std::vector<Parser>& parsers) {
  try {
    for (const Parser& parser : parsers) {
      if (parser.chosen()) return parser.run();
    }
    return fail(usage_error("a command is missing", {}));
  } catch (const std::bad_alloc&) {
    return fail(ErrorKind::kSystem, "there is not enough memory", {},
                "choose a smaller map or less data");
  } catch (const std::system_error& error) {
    return fail(ErrorKind::kSystem, error.what());
  }
}

// The requested command: no argument and "help" request help, "help run" that of a command.
std::vector<std::string> command_words(int argc, char** argv) {
  std::vector<std::string> words(argv + std::min(argc, 1), argv + argc);
  const bool asks_help = words.empty() || words.front() == "help";
  if (!asks_help) return words;
  if (!words.empty()) words.erase(words.begin());
  words.emplace_back("--help");
  return words;
}

// Adds all commands to `root`, but the flags of those that `words` may name only: all of them take
// longer to declare than many a command takes.
std::vector<Parser> parsers_of(const std::vector<Command>& commands,
                               const std::vector<std::string>& words, CLI::App& root) {
  std::vector<Parser> parsers;
  for (const Command& command : commands) {
    CLI::App& place = place_of(root, command.name, command.text);
    const std::string first = command.name.substr(0, command.name.find(' '));
    if (std::find(words.begin(), words.end(), first) != words.end())
      parsers.emplace_back(place, command);
  }
  return parsers;
}

// Output that was not written is a failure, even if it is detected at the end.
int finish(int code) {
  if (code != 0 || (std::fflush(stdout) == 0 && std::ferror(stdout) == 0)) return code;
  const std::string reason = std::generic_category().message(errno);
  return report({ErrorKind::kSystem, "cannot write: " + reason, "standard output",
                 "free disk space, or write to another place"});
}

}  // namespace

int run_command_line(int argc, char** argv, const std::vector<Command>& commands) {
  CLI::App root("Haptic perception with self-organizing maps", "somato");
  root.set_version_flag("-V,--version", "somato " SOMATO_VERSION);
  root.require_subcommand(1);
  root.formatter(std::make_shared<HelpFormat>());
  std::vector<std::string> words = command_words(argc, argv);
  const std::vector<Parser> parsers = parsers_of(commands, words, root);
  if constexpr (kHasStudies && kHasReport) {
    root.footer(
        "A map in three steps:\n"
        "  somato som train data.csv -o my.map --standardize\n"
        "  somato som quality my.map data.csv\n"
        "  somato som plot my.map data.csv -o my.svg\n"
        "All flags of a command: somato som train --help");
  }
  std::reverse(words.begin(), words.end());  // as the parser takes them
  try {
    root.parse(std::move(words));
  } catch (const CLI::Success& help) {
    return finish(root.exit(help));
  } catch (const CLI::ParseError& error) {
    return report_parse_error(root, error);
  }
  const Result<void> done = run_chosen(parsers);
  return finish(done ? 0 : report(done.error()));
}

}  // namespace somato::program
