#pragma once

#include <string>
#include <vector>

#include "command_line.h"

namespace somato::program {

/// A word that a command line can go on with.
struct Completion {
  std::string word;
  std::string text;  ///< What it stands for, in one line; may be empty.
};

/// What the last of `words`, which stand behind the program's name and of which the last is
/// unfinished or empty, can become. Nothing where a file, a folder or a number is expected: shells
/// complete files themselves.
std::vector<Completion> completions(const std::vector<Command>& commands,
                                    const std::vector<std::string>& words);

/// `somato completions words WORDS...`: prints the completions, a line each, with a tab before the
/// text. The words are no arguments of that command: they may be flags, unfinished or empty.
bool is_completion_request(int argc, char** argv);
int answer_completion_request(int argc, char** argv, const std::vector<Command>& commands);

}  // namespace somato::program
