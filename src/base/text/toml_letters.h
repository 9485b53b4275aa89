#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace somato {

/// toml++ (3.3, 3.4) tests whether characters outside of quotation marks, and those behind the
/// backslash at a line's end, are blanks. The test has undefined behaviour for 3,017 characters,
/// such as U+00E4. They are replaced by stand-ins before the text is parsed, and put back into
/// keys, texts and messages afterwards. The stand-in for a character U+XXXX is U+CXXXX; Unicode
/// assigns none of these. Lines and columns stay the same.
std::string with_stand_ins(std::string_view text);

/// The text whose stand-ins `text` contains.
std::string without_stand_ins(std::string_view text);

/// The offset of the first character U+C0000 to U+CFFFF in TOML `text`, or of the first such escape
/// (\U000C...); npos if there is none. Such a text cannot have stand-ins.
std::size_t first_stand_in(std::string_view text);

}  // namespace somato
