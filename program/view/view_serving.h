#pragma once

#include <vector>

#include "flags/command_line.h"
#include "views/live/view_server.h"

namespace somato::program {

/// The pages of the view. Errors (kUsage): the program was built without them.
Result<std::vector<ViewPage>> view_pages();

/// The flags of its server: --port, --address and --allow-others.
std::vector<Flag> server_flags();

/// The flag `--page-memory`, and its bytes, or the default. Errors (kUsage): not an amount, or too
/// small.
Flag page_memory_flag();
Result<std::size_t> read_page_memory(const Arguments& arguments);

/// Their values. Errors: kUsage.
Result<ViewServerSettings> read_server_settings(const Arguments& arguments);

}  // namespace somato::program
