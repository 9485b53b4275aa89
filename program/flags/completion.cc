#include "flags/completion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <string_view>
#include <utility>

#include "flags/usage.h"

namespace somato::program {
namespace {

using Words = std::vector<std::string>;

Words words_of(const std::string& name) {
  std::istringstream stream(name);
  Words words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

bool begin_with(const Words& words, const Words& beginning) {
  return beginning.size() <= words.size() &&
         std::equal(beginning.begin(), beginning.end(), words.begin());
}

// A text as one line without tabs, cut before its second sentence.
std::string first_sentence(const std::string& text) {
  std::string line = text.substr(0, text.find(". "));
  std::replace_if(line.begin(), line.end(), [](char c) { return c == '\t' || c == '\n'; }, ' ');
  return line;
}

// The next word of every command that begins with the given words.
std::vector<Completion> next_words(const std::vector<Command>& commands, const Words& before) {
  std::vector<Completion> found;
  for (const Command& command : commands) {
    const Words name = words_of(command.name);
    if (name.size() <= before.size() || !begin_with(name, before)) continue;
    const std::string& word = name[before.size()];
    const bool is_group = name.size() > before.size() + 1;
    const bool is_known = std::any_of(found.begin(), found.end(),
                                      [&](const Completion& other) { return other.word == word; });
    if (!is_known) found.push_back({word, is_group ? "Commands about maps" : command.text});
  }
  return found;
}

std::vector<std::string> spellings(const Flag& flag) {
  std::vector<std::string> names;
  std::istringstream stream(flag.name);
  for (std::string name; std::getline(stream, name, ',');) names.push_back(name);
  return names;
}

std::vector<Completion> flags_of(const Command& command) {
  std::vector<Completion> flags;
  flags.reserve(command.flags.size() + command.parameters.size() + 2);
  for (const Flag& flag : command.flags) {
    flags.push_back({spellings(flag).back(), first_sentence(flag.text)});
  }
  for (const ParameterInfo& info : command.parameters) {
    flags.push_back({flag_of(info.name), first_sentence(info.text)});
  }
  flags.push_back({"--quiet", std::string(kQuietText)});
  flags.push_back({"--help", "Print help for the command"});
  return flags;
}

std::vector<Completion> named(const std::vector<std::string>& names) {
  std::vector<Completion> all;
  all.reserve(names.size());
  for (const std::string& name : names) all.push_back({name, {}});
  return all;
}

// The flag `word` if its value comes next, with the possible values.
bool takes_value(const Command& command, const std::string& word, std::vector<Completion>& values) {
  for (const ParameterInfo& info : command.parameters) {
    if (flag_of(info.name) != word) continue;
    values = named(info.type == "switch" ? Words{"true", "false"} : info.choices);
    return true;
  }
  return std::any_of(command.flags.begin(), command.flags.end(), [&](const Flag& flag) {
    const Words names = spellings(flag);
    return flag.takes_value && std::find(names.begin(), names.end(), word) != names.end();
  });
}

// The positional after `given` words; the last positional may take many.
const Positional* next_positional(const Command& command, std::size_t given) {
  if (given < command.positionals.size()) return &command.positionals[given];
  const bool more = !command.positionals.empty() && command.positionals.back().many;
  return more ? &command.positionals.back() : nullptr;
}

std::size_t positionals_in(const Command& command, const Words& arguments) {
  std::size_t count = 0;
  std::vector<Completion> ignored;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (!arguments[i].starts_with("-")) ++count;
    if (takes_value(command, arguments[i], ignored)) ++i;
  }
  return count;
}

std::vector<Completion> arguments_of(const Command& command, const Words& before,
                                     const std::string& last) {
  std::vector<Completion> values;
  if (!before.empty() && takes_value(command, before.back(), values)) return values;
  if (last.starts_with("-")) return flags_of(command);
  const Positional* next = next_positional(command, positionals_in(command, before));
  return next && next->names ? named(next->names()) : values;
}

}  // namespace

std::vector<Completion> completions(const std::vector<Command>& commands,
                                    const std::vector<std::string>& words) {
  const std::string last = words.empty() ? std::string() : words.back();
  const Words before(words.begin(), words.end() - (words.empty() ? 0 : 1));
  const auto meant = std::find_if(commands.begin(), commands.end(), [&](const Command& command) {
    return begin_with(before, words_of(command.name));
  });
  std::vector<Completion> found;
  if (meant == commands.end()) {
    found = next_words(commands, before);
  } else {
    const auto arguments =
        before.begin() + static_cast<std::ptrdiff_t>(words_of(meant->name).size());
    found = arguments_of(*meant, Words(arguments, before.end()), last);
  }
  std::erase_if(found, [&](const Completion& one) { return !one.word.starts_with(last); });
  return found;
}

bool is_completion_request(int argc, char** argv) {
  return argc > 2 && argv[1] == std::string_view("completions") &&
         argv[2] == std::string_view("words");
}

int answer_completion_request(int argc, char** argv, const std::vector<Command>& commands) {
  std::string text;
  for (const Completion& one : completions(commands, Words(argv + 3, argv + argc))) {
    text += fmt::format("{}\t{}\n", one.word, one.text);
  }
  std::fwrite(text.data(), 1, text.size(), stdout);
  return 0;
}

}  // namespace somato::program
