#pragma once

#include <cstddef>

#include "command_line.h"

namespace somato::program {

/// The bytes that the flag `--memory` allows rows to take, or half of what is free. Errors: kUsage.
Result<std::size_t> read_memory(const Arguments& arguments);

/// A number of bytes, with one of the units B, kB, MB, GB, KiB, MiB, GiB. Errors: kUsage.
Result<std::size_t> bytes_in(const std::string& text);

Flag memory_flag();

}  // namespace somato::program
