#pragma once

#include <string>
#include <vector>

#include "flags/command_line.h"

namespace somato::program {

/// A possible next word of a command line.
struct Completion {
  std::string word;
  std::string text;  ///< Its meaning, in one line; may be empty.
};

/// The completions of the last of `words`, the arguments of the program, of which the last is
/// incomplete or empty. Empty if a file, a folder or a number is expected: shells complete files
/// themselves.
std::vector<Completion> completions(const std::vector<Command>& commands,
                                    const std::vector<std::string>& words);

/// `somato completions words WORDS...`: prints the completions, one per line, with a tab before the
/// text. The words are not parsed as arguments of that command: they may be flags, incomplete or
/// empty.
bool is_completion_request(int argc, char** argv);
int answer_completion_request(int argc, char** argv, const std::vector<Command>& commands);

}  // namespace somato::program
