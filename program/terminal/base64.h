#pragma once

#include <string>
#include <string_view>

namespace somato::program {

/// The bytes of a text in base64 (RFC 4648, section 4), which another program has written.
std::string from_base64(std::string_view text);

}  // namespace somato::program
