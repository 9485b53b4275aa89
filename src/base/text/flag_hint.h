#pragma once

#include <string>
#include <string_view>

namespace somato {

/// Whether messages name the flags of the program; false until the program sets it, before it
/// starts threads. Users of the library and of the Python package have no flags.
void name_flags_in_messages(bool flags);

/// The flag of the program for what a message advises, as " (--name value)", where messages name
/// flags; otherwise an empty text, so that the message must be complete without it.
std::string flag_hint(std::string_view flag, std::string_view value = {});

}  // namespace somato
