#include <array>
#include <cstdio>
#include <string>
#include <string_view>

#include "flags/commands.h"

namespace somato::program {
namespace {

struct Shell {
  std::string_view name;
  std::string_view script;
};

// The program computes the completions; a script only passes them on.
constexpr std::array<Shell, 3> kShells = {Shell{"bash", R"script(_somato() {
  local IFS=$'\n'
  COMPREPLY=($("$1" completions words "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null | cut -f 1))
}
complete -o default -F _somato somato
)script"},
                                          Shell{"zsh", R"script(#compdef somato
_somato() {
  local -a candidates
  local line
  for line in "${(@f)$("$words[1]" completions words "${(@)words[2,CURRENT]}" 2>/dev/null)}"; do
    [[ -n $line ]] && candidates+=("${${line%%$'\t'*}//:/\\:}:${line#*$'\t'}")
  done
  if (( $#candidates )); then _describe 'somato' candidates; else _files; fi
}
if [[ $funcstack[1] == _somato ]]; then _somato "$@"; else compdef _somato somato; fi
)script"},
                                          Shell{"fish", R"script(function __somato_completions
  set -l words (commandline -opc)
  $words[1] completions words $words[2..-1] "$(commandline -ct)" 2>/dev/null
end
complete -c somato -a '(__somato_completions)'
)script"}};

std::vector<std::string> shells() {
  std::vector<std::string> names;
  names.reserve(kShells.size());
  for (const Shell& shell : kShells) names.emplace_back(shell.name);
  return names;
}

Result<void> print_script(const Arguments& arguments) {
  const std::string name = arguments.text("SHELL");
  for (const Shell& shell : kShells) {
    if (shell.name != name) continue;
    std::fwrite(shell.script.data(), 1, shell.script.size(), stdout);
    return {};
  }
  return fail(unknown_name("shell", name, "completions", shells()));
}

}  // namespace

Command completions_command() {
  return {"completions",
          "Print the script for shell completion of commands, flags and names",
          {{"SHELL", "bash, zsh or fish", true, false, Role::kValue, shells}},
          {},
          {},
          print_script};
}

}  // namespace somato::program
