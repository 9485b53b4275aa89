#include "command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "somato/core/instruction_set.h"
#include "version.h"

namespace somato::program {
namespace {

constexpr int kFailed = 1;
constexpr int kWrongUsage = 2;
constexpr int kInterrupted = 130;

int exit_code(ErrorKind kind) {
  if (kind == ErrorKind::kUsage) return kWrongUsage;
  return kind == ErrorKind::kInterrupted ? kInterrupted : kFailed;
}

int report(const Error& error) {
  fmt::print(stderr, "somato: {}\n", to_string(error));
  return exit_code(error.kind);
}

std::string description_of(const ParameterInfo& info) {
  std::string text = info.text;
  if (!info.unit.empty()) text += fmt::format(" [{}]", info.unit);
  const std::string range = to_string(info.range);
  if (!range.empty()) text += fmt::format(" ({})", range);
  if (!info.choices.empty()) text += fmt::format(" ({})", fmt::join(info.choices, ", "));
  return text + fmt::format(" Default: {}.", info.default_text);
}

// "-o,--output" is known as "output".
std::string key_of(const std::string& flag) {
  return flag.substr(flag.rfind("--") + 2);
}

// A command's part of the parser, and where its arguments go.
class Parser {
 public:
  Parser(CLI::App& app, const Command& command) : app_(app), command_(command) {
    for (const Positional& positional : command.positionals) {
      add(positional.name, positional.name, positional.text)->required(positional.required);
    }
    for (const Flag& flag : command.flags) add_flag(flag);
    for (const ParameterInfo& info : command.parameters) {
      add(flag_of(info.name).substr(2), flag_of(info.name), description_of(info))
          ->type_name("VALUE");
    }
  }

  bool chosen() const { return app_.parsed(); }

  int run() const {
    Arguments arguments;
    for (const auto& [name, option] : options_) {
      if (option->count() > 0) arguments.texts[name] = option->results().back();
    }
    const Result<void> done = command_.run(arguments);
    return done ? 0 : report(done.error());
  }

  std::vector<std::string> flags() const {
    std::vector<std::string> names;
    for (const CLI::Option* option : app_.get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
  }

 private:
  CLI::Option* add(const std::string& key, const std::string& names, const std::string& text) {
    auto value = std::make_unique<std::string>();
    CLI::Option* option = app_.add_option(names, *value, text);
    values_.push_back(std::move(value));
    options_[key] = option;
    return option;
  }

  void add_flag(const Flag& flag) {
    const std::string key = key_of(flag.name);
    if (flag.takes_value) {
      add(key, flag.name, flag.text)->required(flag.required)->type_name("VALUE");
    } else {
      options_[key] = app_.add_flag(flag.name, flag.text);
    }
  }

  CLI::App& app_;
  const Command& command_;
  std::vector<std::unique_ptr<std::string>> values_;
  std::map<std::string, CLI::Option*> options_;
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

std::string usage_of(const CLI::App& app) {
  std::string path = app.get_name();
  for (const CLI::App* parent = app.get_parent(); parent; parent = parent->get_parent()) {
    path = parent->get_name() + " " + path;
  }
  return path;
}

Error unexpected_argument(const CLI::App& app, const std::string& argument) {
  if (!argument.starts_with("-")) {
    const std::vector<std::string> commands = names_of_subcommands(app);
    if (!commands.empty()) return unknown_name("command", argument, usage_of(app), commands);
    return {ErrorKind::kUsage, fmt::format("unexpected argument '{}'", argument), usage_of(app),
            fmt::format("see '{} --help'", usage_of(app))};
  }
  std::vector<std::string> flags;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) flags.push_back("--" + name);
  }
  return unknown_name("flag", argument.substr(0, argument.find('=')), usage_of(app), flags);
}

int report_parse_error(const CLI::App& root, const CLI::ParseError& error) {
  const CLI::App& app = innermost(root);
  const std::vector<std::string> left = root.remaining(true);
  if (dynamic_cast<const CLI::ExtrasError*>(&error) && !left.empty()) {
    return report(unexpected_argument(app, left.front()));
  }
  return report({ErrorKind::kUsage, error.what(), usage_of(app),
                 fmt::format("see '{} --help'", usage_of(app))});
}

// The parser of the command named `words`, below groups such as "som".
CLI::App& place_of(CLI::App& root, const std::string& words, const std::string& text) {
  const std::size_t blank = words.find(' ');
  if (blank == std::string::npos) return *root.add_subcommand(words, text);
  const std::string group = words.substr(0, blank);
  const auto is_group = [&](const CLI::App* app) { return app->get_name() == group; };
  const std::vector<CLI::App*> found = root.get_subcommands(is_group);
  CLI::App* parent = found.empty()
                         ? root.add_subcommand(group, "Self-organizing maps of any data")
                         : found.front();
  parent->require_subcommand(1);
  return *parent->add_subcommand(words.substr(blank + 1), text);
}

}  // namespace

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
  const Result<Value> value = value_from_text(info, text(name));
  Result<std::int64_t> whole = detail::read_integer(info, *value, 0, kMost);
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

int run_command_line(int argc, char** argv, const std::vector<Command>& commands) {
  CLI::App root("A self-organizing sense of touch", "somato");
  root.set_version_flag("--version", SOMATO_VERSION);
  root.require_subcommand(1);
  root.get_formatter()->column_width(34);
  std::vector<Parser> parsers;
  parsers.reserve(commands.size());
  for (const Command& command : commands) {
    parsers.emplace_back(place_of(root, command.name, command.text), command);
  }
  try {
    root.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return root.exit(help);
  } catch (const CLI::ParseError& error) {
    return report_parse_error(root, error);
  }
  for (const Parser& parser : parsers) {
    if (parser.chosen()) return parser.run();
  }
  return kWrongUsage;
}

}  // namespace somato::program
