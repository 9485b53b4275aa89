#pragma once

#include <cstddef>

#include "flags/command_line.h"

namespace somato::program {

/// The flag `--memory` in bytes, or half of the free memory. Errors: kUsage.
Result<std::size_t> read_memory(const Arguments& arguments);

/// A number of bytes, with one of the units B, kB, MB, GB, KiB, MiB, GiB. Errors (kUsage) name the
/// flag.
Result<std::size_t> bytes_in(const std::string& text, const std::string& flag);

Flag memory_flag();

}  // namespace somato::program
