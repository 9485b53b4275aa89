#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace somato {

/// The flags, without dashes, that messages name: those of the command that runs, which the program
/// sets before it starts threads. None until then: users of the library and of the Python package
/// have no flags.
void name_flags_in_messages(std::vector<std::string> flags);

/// The flag for what a message advises, as " (--name value)", if the command has it; otherwise an
/// empty text, so that the message must be complete without it.
std::string flag_hint(std::string_view flag, std::string_view value = {});

}  // namespace somato
